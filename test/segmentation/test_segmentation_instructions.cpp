// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// Planes, objects and obstacles hardly depend on the vector instructions of the machine: only
// points at a threshold may be on either side of it.

#include "floor_scene.h"
#include <hwy/targets.h>

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>
#include <pcl/segmentation/obstacle_detection.h>
#include <pcl/segmentation/supported_object_extraction.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

using synthetic::FloorScene;

/** What the library falls back to where it knows no better instructions: scalar ones, or those
 * that every processor of this kind has. */
constexpr std::int64_t fallback = HWY_STATIC_TARGET;

struct Found {
  std::vector<pcl::ModelCoefficients> models;
  std::vector<std::uint32_t> labels;
  std::vector<std::uint32_t> objects; // of each point, from 1 on
  std::vector<std::uint32_t> classes;
  std::vector<float> ranges;
};

/** A table with touching boxes on it and a step down beside it, with the noise of a Kinect. */
FloorScene
makeScene (std::uint32_t width)
{
  std::vector<synthetic::Patch> patches{synthetic::floorAt (0.f)};
  synthetic::addBox ({0.8f, -0.4f, 0.5f}, {1.4f, 0.4f, 0.55f}, patches);
  synthetic::addBox ({0.9f, -0.3f, 0.55f}, {1.f, -0.2f, 0.65f}, patches);
  synthetic::addBox ({0.9f, -0.2f, 0.55f}, {1.f, -0.1f, 0.6f}, patches);
  synthetic::addBox ({1.1f, 0.1f, 0.55f}, {1.2f, 0.2f, 0.7f}, patches);
  const auto pose = synthetic::cameraPose (1.1f, 0.5f, 0.02f);
  return {patches, pose, width, [] (float z) { return 0.001f + 0.002f * z * z; }};
}

Found
findWith (std::int64_t target,
          const FloorScene& scene,
          const pcl::PointCloud<pcl::Normal>::Ptr& normals)
{
  hwy::SetSupportedTargetsForTest (target);
  Found found;
  std::vector<pcl::PointIndices> inliers, label_indices;
  pcl::PointCloud<pcl::Label>::Ptr labels (new pcl::PointCloud<pcl::Label>);
  using Segmentation = pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal>;
  Segmentation segmentation;
  Segmentation::Centroids centroids;
  Segmentation::Covariances covariances;
  segmentation.setMinInliers (static_cast<unsigned> (scene.cloud->size() / 300));
  segmentation.setInputCloud (scene.cloud);
  segmentation.setInputNormals (normals);
  segmentation.segment (
      found.models, inliers, centroids, covariances, *labels, label_indices);
  for (const auto& label : *labels)
    found.labels.push_back (label.label);

  pcl::SupportedObjectExtraction<pcl::PointXYZ, pcl::Normal> extraction;
  extraction.setCameraToBase (scene.camera_to_base);
  extraction.setMinPoints (20);
  extraction.setSplitAtConcaveEdges (true);
  extraction.setInputCloud (scene.cloud);
  extraction.setInputNormals (normals);
  std::vector<pcl::SupportedObject> objects;
  extraction.extract (found.models, inliers, objects);
  found.objects.assign (scene.cloud->size(), 0);
  for (std::size_t k = 0; k < objects.size(); ++k)
    for (const auto i : objects[k].indices.indices)
      found.objects[static_cast<std::size_t> (i)] = static_cast<std::uint32_t> (k + 1);

  pcl::ObstacleDetection<pcl::PointXYZ, pcl::Normal> detection;
  detection.setCameraToBase (scene.camera_to_base);
  detection.setInputCloud (scene.cloud);
  detection.setInputNormals (normals);
  detection.setInputPlanes (found.models, labels);
  std::vector<pcl::rgbd_planes::Obstacle> obstacles;
  detection.detect (obstacles);
  for (const auto what : detection.getClasses())
    found.classes.push_back (static_cast<std::uint32_t> (what));
  found.ranges = detection.getScan().ranges;
  hwy::SetSupportedTargetsForTest (0);
  return found;
}

double
shareOfDifferences (const std::vector<std::uint32_t>& a,
                    const std::vector<std::uint32_t>& b)
{
  std::size_t differ = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    differ += a[i] != b[i];
  return static_cast<double> (differ) / static_cast<double> (a.size());
}

} // namespace

TEST (SegmentationInstructions, AllFindTheSame)
{
  for (const std::uint32_t width : {640u, 331u, 160u}) {
    const FloorScene scene = makeScene (width);
    pcl::PointCloud<pcl::Normal>::Ptr normals (new pcl::PointCloud<pcl::Normal>);
    pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    estimation.setInputCloud (scene.cloud);
    estimation.compute (*normals);
    const Found expected = findWith (fallback, scene, normals);
    ASSERT_GE (expected.models.size(), 4u);
    ASSERT_GE (*std::max_element (expected.objects.begin(), expected.objects.end()),
               2u);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      SCOPED_TRACE (std::to_string (width) + ", " + hwy::TargetName (target));
      const Found found = findWith (target, scene, normals);
      ASSERT_EQ (found.models.size(), expected.models.size());
      for (std::size_t k = 0; k < found.models.size(); ++k)
        for (std::size_t c = 0; c < 4; ++c)
          EXPECT_NEAR (found.models[k].values[c], expected.models[k].values[c], 1e-3f);
      EXPECT_LE (shareOfDifferences (found.labels, expected.labels), 1e-3);
      EXPECT_LE (shareOfDifferences (found.objects, expected.objects), 1e-3);
      EXPECT_LE (shareOfDifferences (found.classes, expected.classes), 1e-3);
      ASSERT_EQ (found.ranges.size(), expected.ranges.size());
      ASSERT_FALSE (found.ranges.empty());
      std::size_t differ = 0;
      for (std::size_t i = 0; i < found.ranges.size(); ++i)
        differ += found.ranges[i] != expected.ranges[i] &&
                  !(std::fabs (found.ranges[i] - expected.ranges[i]) <= 1e-3f);
      EXPECT_LE (differ, 2u);
    }
  }
}
