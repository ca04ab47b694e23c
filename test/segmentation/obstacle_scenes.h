// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "floor_scene.h"

#include <pcl/segmentation/obstacle_detection.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace obstacle_scenes {

using pcl::rgbd_planes::Obstacle;
using pcl::rgbd_planes::ObstacleClass;
using synthetic::box;
using synthetic::cameraPose;
using synthetic::floorAt;
using synthetic::FloorScene;
using synthetic::Patch;
using Detection = pcl::ObstacleDetection<pcl::PointXYZ, pcl::Normal>;

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint32_t no_plane = std::numeric_limits<std::uint32_t>::max();

struct Result {
  std::vector<Obstacle> obstacles;
  pcl::PointCloud<pcl::Label> classes;

  ObstacleClass
  operator[] (std::size_t i) const
  {
    return static_cast<ObstacleClass> (classes[i].label);
  }

  std::size_t
  count (ObstacleClass c) const
  {
    return static_cast<std::size_t> (
        std::count_if (classes.begin(), classes.end(), [c] (const pcl::Label& label) {
          return label.label == static_cast<std::uint32_t> (c);
        }));
  }
};

inline void
setInput (Detection& detection, const FloorScene& scene)
{
  detection.setCameraToBase (scene.camera_to_base);
  detection.setInputCloud (scene.cloud);
  detection.setInputNormals (scene.normals);
  detection.setInputPlanes (scene.planes, scene.labels);
}

inline Result
detect (const FloorScene& scene)
{
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  return result;
}

inline std::vector<Patch>
operator+ (std::vector<Patch> a, const std::vector<Patch>& b)
{
  a.insert (a.end(), b.begin(), b.end());
  return a;
}

inline const Eigen::Affine3f pose = cameraPose (0.8f, 0.45f);
inline const std::vector<Patch> only_floor{floorAt (0.f)};
inline const std::vector<Patch> a_box = box ({1.2f, -0.1f, 0.f}, {1.5f, 0.2f, 0.3f});
constexpr std::uint32_t box_front = 1; // of only_floor + a_box

/** The share of the points of these patches that are of a class. */
inline double
share (const FloorScene& scene,
       const Result& result,
       std::uint32_t first_patch,
       std::uint32_t last_patch,
       ObstacleClass c)
{
  std::size_t points = 0, of_class = 0;
  for (std::size_t i = 0; i < scene.labels->size(); ++i) {
    const std::uint32_t patch = (*scene.labels)[i].label;
    if (patch < first_patch || patch > last_patch)
      continue;
    ++points;
    of_class += result[i] == c;
  }
  EXPECT_GT (points, 0u);
  return static_cast<double> (of_class) / static_cast<double> (points);
}

inline float
kinectSigma (float z)
{
  return 0.001f + 0.002f * z * z;
}

} // namespace obstacle_scenes
