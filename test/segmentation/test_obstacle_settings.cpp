// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "obstacle_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

using namespace obstacle_scenes;

TEST (ObstacleSettings, HeightsOfObstaclesAndDepthsOfDropsAreSettings)
{
  const FloorScene low (only_floor + box ({1.2f, -0.3f, 0.f}, {1.5f, 0.3f, 0.03f}),
                        pose);
  Detection detection;
  Result result;
  setInput (detection, low);
  detection.detect (result.obstacles, result.classes);
  const std::size_t before = result.count (ObstacleClass::obstacle);
  detection.setMinObstacleHeight (0.05f);
  detection.detect (result.obstacles, result.classes);
  EXPECT_LT (result.count (ObstacleClass::obstacle), before);
  detection.setMinObstacleHeight (0.1f);
  detection.detect (result.obstacles, result.classes);
  constexpr std::uint32_t box_top = 6;
  EXPECT_EQ (share (low, result, box_top, box_top, ObstacleClass::floor), 1.);
  EXPECT_GT (share (low, result, box_front, box_front, ObstacleClass::obstacle), 0.9)
      << "may be the foot of something";

  Patch near = floorAt (0.f);
  near.covers = [] (const Eigen::Vector3f& p) { return p.x() < 1.5f; };
  const FloorScene step ({near, floorAt (-0.2f)}, pose);
  setInput (detection, step);
  detection.detect (result.obstacles, result.classes);
  EXPECT_GT (result.count (ObstacleClass::drop_off), 0u);
  detection.setMinDropDepth (0.3f);
  detection.detect (result.obstacles, result.classes);
  EXPECT_EQ (result.count (ObstacleClass::drop_off), 0u);
}

TEST (ObstacleSettings, ScansAreOf180DegreesUpTo10MetresAndUnder2)
{
  const Detection detection;
  const auto& limits = detection.getScanLimits();
  EXPECT_FLOAT_EQ (limits.angle_min, static_cast<float> (-M_PI / 2.));
  EXPECT_FLOAT_EQ (limits.angle_max, static_cast<float> (M_PI / 2.));
  EXPECT_FLOAT_EQ (limits.angle_increment, static_cast<float> (M_PI / 360.));
  EXPECT_EQ (limits.range_min, 0.f);
  EXPECT_EQ (limits.range_max, 10.f);
  EXPECT_EQ (limits.max_height, 2.f);
  EXPECT_EQ (detection.getMinClusterSize(), 0u);
}

TEST (ObstacleSettings, SettersRefuseWhatMakesNoSense)
{
  Detection detection;
  detection.setCameraToBase (pose);
  Eigen::Affine3f scaled = pose;
  scaled.linear() *= 2.f;
  detection.setCameraToBase (scaled);
  EXPECT_TRUE (detection.getCameraToBase().isApprox (pose));
  detection.setDepthNoise ({0.001f, not_a_number});
  EXPECT_EQ (detection.getDepthNoise().quadratic, 0.002f);
  for (const float increment : {0.f, -0.1f, not_a_number, 1e-9f}) {
    pcl::rgbd_planes::ScanLimits limits;
    limits.angle_increment = increment;
    detection.setScanLimits (limits);
    EXPECT_FLOAT_EQ (detection.getScanLimits().angle_increment, 0.0087266463f);
  }
  for (const float last : {-2.f, 5.f, not_a_number}) {
    pcl::rgbd_planes::ScanLimits limits;
    limits.angle_max = last; // less than the first one, more than a turn from it
    detection.setScanLimits (limits);
    EXPECT_FLOAT_EQ (detection.getScanLimits().angle_max, 1.5707963f);
  }
  pcl::rgbd_planes::ScanLimits one_direction;
  one_direction.angle_min = one_direction.angle_max = 0.5f;
  detection.setScanLimits (one_direction);
  EXPECT_EQ (detection.getScanLimits().angle_min, 0.5f);
  for (float pcl::rgbd_planes::ScanLimits::*limit :
       {&pcl::rgbd_planes::ScanLimits::range_min,
        &pcl::rgbd_planes::ScanLimits::range_max,
        &pcl::rgbd_planes::ScanLimits::max_height}) {
    pcl::rgbd_planes::ScanLimits limits;
    limits.*limit = not_a_number;
    detection.setScanLimits (limits);
    EXPECT_FALSE (std::isnan (detection.getScanLimits().*limit));
  }
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const auto& [nearest, farthest] :
       {std::pair (-0.5f, 2.f), {-3.f, -2.f}, {infinity, infinity}}) {
    pcl::rgbd_planes::ScanLimits limits;
    limits.range_min = nearest;
    limits.range_max = farthest;
    detection.setScanLimits (limits);
    EXPECT_EQ (detection.getScanLimits().range_min, 0.f);
    EXPECT_EQ (detection.getScanLimits().range_max, 10.f);
  }
  detection.setMinObstacleHeight (infinity);
  for (const float wrong : {-1.f, not_a_number}) {
    detection.setFloorTolerances (wrong, wrong);
    detection.setFloorTolerances (0.1f, wrong);
    detection.setFloorTolerances (wrong, 0.1f);
    detection.setMinObstacleHeight (wrong);
    detection.setMinDropDepth (wrong);
  }
  EXPECT_EQ (detection.getFloorAngleTolerance(), 0.17f);
  EXPECT_EQ (detection.getFloorHeightTolerance(), 0.05f);
  EXPECT_EQ (detection.getMinObstacleHeight(), 0.01f);
  EXPECT_EQ (detection.getMinDropDepth(), 0.03f);
  constexpr auto right_angle = static_cast<float> (M_PI / 2.);
  detection.setFloorTolerances (right_angle, 0.06f);
  EXPECT_EQ (detection.getFloorAngleTolerance(), right_angle);
  EXPECT_EQ (detection.getFloorHeightTolerance(), 0.06f);
  detection.setFloorTolerances (1.6f, 0.f); // ceilings, and no floor at all
  EXPECT_EQ (detection.getFloorAngleTolerance(), right_angle);
  EXPECT_EQ (detection.getFloorHeightTolerance(), 0.06f);
}
