// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// A robot's day: many frames of changing sizes through the same objects. The environment
// variable PCL_RGBD_PLANES_SOAK_FRAMES says how many.

#include "floor_scene.h"
#include <malloc.h>

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/filters/obstacle_filter.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>
#include <pcl/segmentation/obstacle_detection.h>
#include <pcl/segmentation/supported_object_extraction.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string_view>

namespace {

using pcl::PointXYZ;
using synthetic::FloorScene;

/** What is allocated and not freed. */
std::size_t
allocatedBytes ()
{
  const auto info = ::mallinfo2();
  return info.uordblks + info.hblkhd;
}

/** A table with boxes on a floor, from a place of its own. */
FloorScene
makeScene (std::uint32_t width, int variant)
{
  const float shift = 0.02f * static_cast<float> (variant);
  std::vector<synthetic::Patch> patches{synthetic::floorAt (0.f)};
  synthetic::addBox ({0.8f, -0.4f, 0.5f}, {1.4f, 0.4f, 0.55f}, patches);
  for (int k = 0; k <= variant; ++k) {
    const float y = -0.3f + 0.2f * static_cast<float> (k);
    synthetic::addBox (
        {0.9f + shift, y, 0.55f}, {1.f + shift, y + 0.09f, 0.65f}, patches);
  }
  const auto pose = synthetic::cameraPose (1.1f + shift, 0.5f + shift, shift);
  return {patches, pose, width, [] (float z) { return 0.001f + 0.002f * z * z; }};
}

template <typename Values>
std::size_t
digest (const Values& values)
{
  return std::hash<std::string_view>() ({reinterpret_cast<const char*> (values.data()),
                                         values.size() * sizeof (*values.data())});
}

class Robot {
public:
  Robot()
  {
    estimation_.setNumberOfThreads (2);
    extraction_.setMinPoints (10);
    extraction_.setSplitAtConcaveEdges (true);
  }

  /** \return digests of all that was found */
  std::vector<std::size_t>
  look (const FloorScene& scene)
  {
    estimation_.setInputCloud (scene.cloud);
    estimation_.compute (*normals_);
    segmentation_.setMinInliers (static_cast<unsigned> (scene.cloud->size() / 300));
    setInputs (segmentation_, scene);
    segmentation_.segmentAndRefine (
        regions_, planes_, inliers_, labels_, label_indices_, boundaries_);
    extraction_.setCameraToBase (scene.camera_to_base);
    setInputs (extraction_, scene);
    extraction_.extract (planes_, inliers_, objects_);
    detection_.setCameraToBase (scene.camera_to_base);
    setInputs (detection_, scene);
    detection_.setInputPlanes (planes_, labels_);
    detection_.detect (obstacles_, *classes_);
    filter_.setInputCloud (scene.cloud);
    filter_.setClasses (classes_);
    filter_.filter (free_);
    return results();
  }

  std::size_t
  planes () const
  {
    return planes_.size();
  }

  std::size_t
  objects () const
  {
    return objects_.size();
  }

  std::size_t
  obstacles () const
  {
    return obstacles_.size();
  }

private:
  template <typename Segmentation>
  void
  setInputs (Segmentation& segmentation, const FloorScene& scene) const
  {
    segmentation.setInputCloud (scene.cloud);
    segmentation.setInputNormals (normals_);
  }

  std::vector<std::size_t>
  results () const
  {
    std::vector<std::size_t> digests{digest (normals_->points),
                                     digest (labels_->points),
                                     digest (classes_->points),
                                     digest (free_.points),
                                     digest (detection_.getScan().ranges)};
    for (const auto& plane : planes_)
      digests.push_back (digest (plane.values));
    for (const auto& object : objects_)
      digests.push_back (digest (object.indices.indices));
    for (const auto& obstacle : obstacles_)
      digests.push_back (digest (obstacle.indices));
    return digests;
  }

  pcl::IntegralImageTangentNormalEstimation<PointXYZ, pcl::Normal> estimation_;
  pcl::NormalSpacePlaneSegmentation<PointXYZ, pcl::Normal> segmentation_;
  pcl::SupportedObjectExtraction<PointXYZ, pcl::Normal> extraction_;
  pcl::ObstacleDetection<PointXYZ, pcl::Normal> detection_;
  pcl::ObstacleFilter<PointXYZ> filter_;

  pcl::PointCloud<pcl::Normal>::Ptr normals_{new pcl::PointCloud<pcl::Normal>};
  decltype (segmentation_)::Regions regions_;
  std::vector<pcl::ModelCoefficients> planes_;
  std::vector<pcl::PointIndices> inliers_, label_indices_, boundaries_;
  pcl::PointCloud<pcl::Label>::Ptr labels_{new pcl::PointCloud<pcl::Label>};
  pcl::PointCloud<pcl::Label>::Ptr classes_{new pcl::PointCloud<pcl::Label>};
  std::vector<pcl::SupportedObject> objects_;
  std::vector<pcl::rgbd_planes::Obstacle> obstacles_;
  pcl::PointCloud<PointXYZ> free_;
};

std::size_t
framesToDo ()
{
  const char* frames = std::getenv ("PCL_RGBD_PLANES_SOAK_FRAMES");
  return frames ? std::strtoul (frames, nullptr, 10) : 1000;
}

} // namespace

TEST (Soak, ManyFramesOfChangingSizes)
{
  std::vector<FloorScene> scenes;
  for (const std::uint32_t width : {80, 160, 96, 128, 64, 112, 144, 320})
    scenes.push_back (makeScene (width, static_cast<int> (scenes.size() % 3)));

  Robot robot;
  std::vector<std::vector<std::size_t>> first;
  for (const auto& scene : scenes) {
    first.push_back (robot.look (scene));
    ASSERT_GE (robot.planes(), 2u);
    ASSERT_GE (robot.objects(), 1u);
    ASSERT_GE (robot.obstacles(), 1u);
  }
  const std::size_t rounds_of_start = 100 / scenes.size();
  const std::size_t rounds =
      std::max (framesToDo() / scenes.size(), rounds_of_start + 1);
  std::size_t at_start = 0, most = 0;
  for (std::size_t round = 1; round < rounds; ++round) {
    for (std::size_t i = 0; i < scenes.size(); ++i)
      ASSERT_EQ (robot.look (scenes[i]), first[i])
          << "frame " << round * scenes.size() + i;
    auto& bytes = round <= rounds_of_start ? at_start : most;
    bytes = std::max (bytes, allocatedBytes());
  }
  std::cout << rounds * scenes.size() << " frames; " << at_start
            << " bytes after the first 100, " << most << " bytes at most thereafter\n";
  // The free lists of malloc, which differ by thread, count as well: some hundred bytes. The
  // smallest block that a frame could leave behind has 32.
  EXPECT_LT (most, at_start + (rounds - rounds_of_start) * scenes.size());
}
