// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "obstacle_scenes.h"

#include <pcl/common/angles.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
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

TEST (ScanLimits, NoDirectionIsBeyondThem)
{
  constexpr auto degree = static_cast<float> (M_PI / 180.);
  constexpr auto pi = static_cast<float> (M_PI);
  struct Case {
    float first, last, increment;
    std::size_t directions;
  };
  for (const auto& [first, last, increment, directions] :
       {Case{0.f, 1.f, 0.6f, 2},
        {0.f, 1.f, 0.4f, 3},
        {-90.f * degree, 90.f * degree, degree, 181},
        {-135.f * degree, 135.f * degree, 0.25f * degree, 1081},
        {-pi, pi, degree, 360},
        {0.f, 2.f * pi, degree, 360},
        {-3.1416f, 3.1416f, 0.5f * degree, 720},
        {-pi, pi, 0.02f, 314},
        {0.f, 0.01f, 1e-4f, 101},
        {0.5f, 0.5f, 0.1f, 1}}) {
    pcl::rgbd_planes::ScanLimits limits;
    limits.angle_min = first;
    limits.angle_max = last;
    limits.angle_increment = increment;
    Detection detection;
    detection.setScanLimits (limits);
    EXPECT_EQ (detection.getScanLimits().angle_min, first);
    const FloorScene scene (only_floor, pose);
    setInput (detection, scene);
    std::vector<Obstacle> obstacles;
    detection.detect (obstacles);
    const auto& scan = detection.getScan();
    EXPECT_EQ (scan.ranges.size(), directions) << first << " to " << last;
    const float steps = static_cast<float> (directions - 1);
    EXPECT_FLOAT_EQ (scan.angle_max, first + steps * increment);
    EXPECT_LT (scan.angle_max, last + 1e-5f);
  }
}

TEST (ScanLimits, AnglesFarFromZeroAndStepsThatNumbersCannotCountAreRefused)
{
  const pcl::rgbd_planes::ScanLimits usual;
  for (const auto& [first, last, increment] : {std::tuple (1e6f, 1e6f, 0.1f),
                                               {-6.5f, -6.4f, 0.1f},
                                               {6.4f, 6.5f, 0.1f},
                                               {-3.2f, 3.2f, 0.1f},
                                               {0.f, 0.f, 1e-25f},
                                               {0.f, 0.01f, 0.99e-4f}}) {
    pcl::rgbd_planes::ScanLimits limits;
    limits.angle_min = first;
    limits.angle_max = last;
    limits.angle_increment = increment;
    Detection detection;
    testing::internal::CaptureStderr();
    detection.setScanLimits (limits);
    EXPECT_NE (testing::internal::GetCapturedStderr().find ("setScanLimits"),
               std::string::npos);
    EXPECT_EQ (detection.getScanLimits().angle_min, usual.angle_min);
    EXPECT_EQ (detection.getScanLimits().angle_increment, usual.angle_increment);
  }
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

TEST (ScanLimits, TheLastAngleIsADirectionHoweverTheStepIsRounded)
{
  const FloorScene scene (only_floor, pose);
  Detection detection;
  setInput (detection, scene);
  std::vector<Obstacle> obstacles;
  for (const int degrees : {90, 150, 180, 240})
    for (const int step : {1, 2, 3, 5}) {
      pcl::rgbd_planes::ScanLimits limits;
      limits.angle_max = pcl::deg2rad (0.5f * static_cast<float> (degrees));
      limits.angle_min = -limits.angle_max;
      limits.angle_increment = pcl::deg2rad (static_cast<float> (step));
      detection.setScanLimits (limits);
      detection.detect (obstacles);
      EXPECT_EQ (detection.getScan().ranges.size(),
                 static_cast<std::size_t> (degrees / step + 1))
          << degrees << ' ' << step;
    }
}

TEST (ScanLimits, AnotherFirstAngleTurnsAllDirections)
{
  const FloorScene scene (only_floor + a_box, pose, 320);
  Detection used;
  setInput (used, scene);
  pcl::rgbd_planes::ScanLimits limits;
  std::vector<Obstacle> obstacles;
  for (const float first : {-1.5f, -1.5f + 0.25f * limits.angle_increment, -0.7f}) {
    Detection fresh;
    setInput (fresh, scene);
    limits.angle_min = first;
    for (Detection* detection : {&used, &fresh}) {
      detection->setScanLimits (limits);
      detection->detect (obstacles);
    }
    EXPECT_EQ (used.getScan().ranges, fresh.getScan().ranges) << first;
  }
}
