// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "obstacle_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace obstacle_scenes;

TEST (ScanLimits, DirectionsDoNotDependOnThem)
{
  // Pixels are almost four directions wide, also those across the limits.
  const auto wall = box ({2.f, -4.f, 0.f}, {2.1f, 4.f, 4.f});
  const FloorScene scene (only_floor + wall, cameraPose (1.f, 0.f));
  Detection detection;
  setInput (detection, scene);
  pcl::rgbd_planes::ScanLimits limits;
  limits.angle_increment = 0.002f;
  limits.angle_min = -0.1f;
  std::vector<Obstacle> obstacles;
  std::vector<float> wide;
  for (const float last : {1.f, 0.1f}) {
    limits.angle_max = last;
    detection.setScanLimits (limits);
    detection.detect (obstacles);
    if (wide.empty())
      wide = detection.getScan().ranges;
  }
  const auto& narrow = detection.getScan().ranges;
  ASSERT_EQ (narrow.size(), 101u);
  EXPECT_TRUE (std::equal (narrow.begin(), narrow.end(), wide.begin()));
  EXPECT_TRUE (std::all_of (narrow.begin(), narrow.end(), [] (float range) {
    return std::isfinite (range);
  }));
}

TEST (ScanLimits, AScanOfAlmostAWholeTurnHasEachDirectionOnce)
{
  // 720 steps of half a degree make a turn; these limits are 719.6 steps apart.
  pcl::rgbd_planes::ScanLimits limits;
  limits.angle_min = -3.14f;
  limits.angle_max = 3.14f;
  const FloorScene scene (only_floor + a_box, pose, 320);
  Detection detection;
  setInput (detection, scene);
  detection.setScanLimits (limits);
  std::vector<Obstacle> obstacles;
  // The box behind the robot: it lies across the first and the last direction.
  detection.setCameraToBase (
      Eigen::AngleAxisf (static_cast<float> (M_PI), Eigen::Vector3f::UnitZ()) *
      scene.camera_to_base);
  detection.detect (obstacles);
  const auto& ranges = detection.getScan().ranges;
  ASSERT_EQ (ranges.size(), 720u);
  EXPECT_TRUE (std::isfinite (ranges.front()));
  EXPECT_TRUE (std::isfinite (ranges.back()));
}

TEST (ScanLimits, StepsThatNumbersCannotCountAreRefused)
{
  pcl::rgbd_planes::ScanLimits limits;
  limits.angle_min = limits.angle_max = 0.f;
  limits.angle_increment = 1e-25f;
  Detection detection;
  const float usual = detection.getScanLimits().angle_increment;
  detection.setScanLimits (limits);
  EXPECT_EQ (detection.getScanLimits().angle_increment, usual);
}

TEST (ScanLimits, AScanInStepsOfMoreThanATurnHasOneDirection)
{
  pcl::rgbd_planes::ScanLimits limits;
  limits.angle_increment = 10.f;
  Detection detection;
  detection.setScanLimits (limits);
  const FloorScene scene (only_floor + a_box, pose);
  setInput (detection, scene);
  std::vector<Obstacle> obstacles;
  detection.detect (obstacles);
  EXPECT_EQ (detection.getScan().ranges.size(), 1u);
  EXPECT_EQ (detection.getScan().angle_max, limits.angle_min);
}
