// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "count_allocations.h"
#include "floor_scene.h"

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/filters/depth_warp_correction.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>
#include <pcl/segmentation/obstacle_detection.h>
#include <pcl/segmentation/supported_object_extraction.h>

#include <gtest/gtest.h>

#include <cmath>
#include <new>
#include <vector>

namespace {

using Numbers = std::vector<double>;

/** A box on a floor, and its planes. */
struct Frame {
  explicit Frame (std::uint32_t width)
  : scene (patches(), synthetic::cameraPose (0.8f, 0.45f), width, [] (float z) {
    return 0.001f * z;
  })
  {
    pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> segmentation;
    segmentation.setMinInliers (50);
    segmentation.setInputCloud (scene.cloud);
    segmentation.setInputNormals (scene.normals);
    segmentation.segment (planes, inliers, labels);
  }

  static std::vector<synthetic::Patch>
  patches ()
  {
    std::vector<synthetic::Patch> all{synthetic::floorAt (0.f)};
    synthetic::addBox ({1.2f, -0.1f, 0.f}, {1.5f, 0.2f, 0.25f}, all);
    return all;
  }

  synthetic::FloorScene scene;
  std::vector<pcl::ModelCoefficients> planes;
  std::vector<pcl::PointIndices> inliers;
  pcl::PointCloud<pcl::Label> labels;
};

class Normals {
public:
  void
  compute (const Frame& frame)
  {
    estimation_.setInputCloud (frame.scene.cloud);
    estimation_.compute (normals_);
  }

  Numbers
  numbers () const
  {
    Numbers all;
    for (const auto& normal : normals_)
      all.push_back (std::isnan (normal.normal_z) ? -2. : normal.normal_z);
    return all;
  }

private:
  pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation_;
  pcl::PointCloud<pcl::Normal> normals_;
};

class Planes {
public:
  void
  compute (const Frame& frame)
  {
    segmentation_.setMinInliers (50);
    segmentation_.setInputCloud (frame.scene.cloud);
    segmentation_.setInputNormals (frame.scene.normals);
    segmentation_.segment (models_, inliers_);
  }

  Numbers
  numbers ()
  {
    pcl::PointCloud<pcl::Label>::Ptr labels;
    std::vector<pcl::PointIndices> of_labels;
    segmentation_.refine (models_, inliers_, labels, of_labels);
    std::vector<std::size_t> plane_of_segment;
    segmentation_.getSegments (of_labels, plane_of_segment);
    Numbers all (plane_of_segment.begin(), plane_of_segment.end());
    for (const auto& model : models_)
      all.insert (all.end(), model.values.begin(), model.values.end());
    for (const auto& indices : inliers_)
      all.insert (all.end(), indices.indices.begin(), indices.indices.end());
    all.insert (
        all.end(), segmentation_.getRms().begin(), segmentation_.getRms().end());
    return all;
  }

private:
  pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> segmentation_;
  std::vector<pcl::ModelCoefficients> models_;
  std::vector<pcl::PointIndices> inliers_;
};

class Objects {
public:
  void
  compute (const Frame& frame)
  {
    extraction_.setInputCloud (frame.scene.cloud);
    extraction_.setInputNormals (frame.scene.normals);
    extraction_.setCameraToBase (frame.scene.camera_to_base);
    extraction_.setSplitAtConcaveEdges (true);
    extraction_.extract (frame.planes, frame.inliers, objects_);
  }

  Numbers
  numbers () const
  {
    Numbers all;
    for (const auto& object : objects_) {
      all.insert (
          all.end(), object.indices.indices.begin(), object.indices.indices.end());
      all.push_back (object.box_size.sum());
    }
    return all;
  }

private:
  pcl::SupportedObjectExtraction<pcl::PointXYZ, pcl::Normal> extraction_;
  std::vector<pcl::SupportedObject> objects_;
};

class Obstacles {
public:
  void
  compute (const Frame& frame)
  {
    detection_.setInputCloud (frame.scene.cloud);
    detection_.setInputNormals (frame.scene.normals);
    detection_.setInputPlanes (
        frame.planes, pcl::make_shared<pcl::PointCloud<pcl::Label>> (frame.labels));
    detection_.setCameraToBase (frame.scene.camera_to_base);
    detection_.detect (obstacles_);
  }

  Numbers
  numbers () const
  {
    Numbers all;
    for (const auto& obstacle : obstacles_)
      all.insert (all.end(), obstacle.indices.begin(), obstacle.indices.end());
    for (const auto point : detection_.getClasses())
      all.push_back (static_cast<double> (point));
    for (const float range : detection_.getScan().ranges)
      all.push_back (std::isfinite (range) ? range : -1.);
    return all;
  }

private:
  pcl::ObstacleDetection<pcl::PointXYZ, pcl::Normal> detection_;
  std::vector<pcl::rgbd_planes::Obstacle> obstacles_;
};

class Warp {
public:
  void
  compute (const Frame& frame)
  {
    correction_.clearFrames();
    correction_.addFrame (frame.scene.cloud, frame.planes, frame.inliers);
  }

  Numbers
  numbers () const
  {
    Numbers all;
    for (const auto& point : correction_.getWarp())
      all.push_back (point.intensity);
    return all;
  }

private:
  pcl::DepthWarpCorrection<pcl::PointXYZ> correction_;
};

template <typename Class>
class FailedAllocations : public testing::Test {};

using Classes = testing::Types<Normals, Planes, Objects, Obstacles, Warp>;

} // namespace

TYPED_TEST_SUITE (FailedAllocations, Classes);

/** Whichever allocation fails in a frame that is larger or smaller than the one before: the next
 * frames are as if nothing had been. */
TYPED_TEST (FailedAllocations, AreGotOver)
{
#if HAS_SANITIZER
  GTEST_SKIP() << "allocations do not fail together with a sanitizer";
#endif
  const Frame small (80), large (160);
  const auto numbersOf = [] (TypeParam& object, const Frame& frame) {
    object.compute (frame);
    return object.numbers();
  };
  TypeParam fresh;
  const Numbers of_small = numbersOf (fresh, small),
                of_large = numbersOf (fresh, large);
  ASSERT_GT (of_small.size(), 50u);
  for (const bool is_larger : {true, false}) {
    const Frame &before = is_larger ? small : large,
                &failing = is_larger ? large : small;
    for (std::size_t k = 1;; ++k) {
      TypeParam object;
      object.compute (before);
      failing_allocation = allocations + k;
      try {
        object.compute (failing);
      }
      catch (const std::bad_alloc&) {
      }
      if (allocations < failing_allocation)
        break;
      ASSERT_EQ (numbersOf (object, large), of_large) << k;
      ASSERT_EQ (numbersOf (object, small), of_small) << k;
    }
    failing_allocation = 0;
  }
}
