// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "obstacle_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace obstacle_scenes;
using Eigen::Vector3f;

namespace {

/** Less than five standard deviations of height, for a Kinect 2.2 m away. */
constexpr float height = 0.018f;
const Vector3f middle{2.f, 0.f, 0.f};

/** The floor as a camera sees it that measures a place of it too near. */
FloorScene
floorWithBump (const Eigen::Affine3f& camera, std::uint32_t width, float times = 1.f)
{
  FloorScene scene (only_floor, camera, width);
  for (auto& point : *scene.cloud) {
    const Vector3f p = camera * point.getVector3fMap();
    if (!p.allFinite())
      continue;
    const float bell = std::exp (-(p - middle).squaredNorm() / (2.f * 0.06f * 0.06f));
    point.getVector3fMap() *= 1.f - times * height * bell / camera.translation().z();
  }
  return scene;
}

bool
seesNothing (const FloorScene& scene)
{
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  const auto& ranges = detection.getScan().ranges;
  const bool is_scan_free = std::all_of (
      ranges.begin(), ranges.end(), [] (float range) { return std::isinf (range); });
  EXPECT_EQ (result.obstacles.empty(), is_scan_free);
  EXPECT_EQ (result.obstacles.empty(), result.count (ObstacleClass::obstacle) == 0);
  return result.obstacles.empty();
}

/** The camera of the other tests, on its side or upside down. */
Eigen::Affine3f
rolled (float roll)
{
  return pose * Eigen::AngleAxisf (roll, Vector3f::UnitZ());
}

} // namespace

TEST (FloorBumps, AreNoObstacles)
{
  for (const std::uint32_t width : {320u, 640u})
    for (const float roll : {0.f, 1.5f, 3.1f, -1.6f})
      EXPECT_TRUE (seesNothing (floorWithBump (rolled (roll), width)))
          << width << ' ' << roll;
}

TEST (FloorBumps, WhatEndsAtAStepIsAnObstacle)
{
  const auto low_box = box ({1.94f, -0.06f, 0.f}, {2.06f, 0.06f, height});
  for (const std::uint32_t width : {320u, 640u})
    for (const float roll : {0.f, 1.5f, 3.1f, -1.6f})
      EXPECT_FALSE (
          seesNothing (FloorScene (only_floor + low_box, rolled (roll), width)))
          << width << ' ' << roll;
}

TEST (FloorBumps, WhatIsHigherIsAnObstacle)
{
  EXPECT_FALSE (seesNothing (floorWithBump (pose, 640, 2.5f)));
}

TEST (FloorBumps, WhatLacksDepthBehindItIsAnObstacle)
{
  FloorScene scene = floorWithBump (pose, 640);
  for (auto& point : *scene.cloud) {
    const Vector3f p = pose * point.getVector3fMap();
    if (p.x() > middle.x() + 0.02f && p.x() < middle.x() + 0.2f &&
        std::fabs (p.y()) < 0.2f)
      point.x = not_a_number;
  }
  EXPECT_FALSE (seesNothing (scene));
}
