// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "obstacle_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace obstacle_scenes;

TEST (ObstacleScan, TheScanHasTheClosestPointOfEachDirection)
{
  const auto things = a_box + box ({2.f, 0.3f, 0.f}, {2.5f, 1.1f, 0.5f}) +
                      box ({0.8f, -1.f, 1.1f}, {3.f, 1.f, 1.2f});
  const FloorScene scene (only_floor + things, cameraPose (0.8f, 0.2f), 320);
  Detection detection;
  setInput (detection, scene);
  // The robot's own frame may be turned against its camera.
  for (const float turn : {0.f, 1.5f, 3.1f}) {
    const Eigen::Affine3f to_base =
        Eigen::AngleAxisf (turn, Eigen::Vector3f::UnitZ()) * scene.camera_to_base;
    detection.setCameraToBase (to_base);
    pcl::rgbd_planes::ScanLimits limits;
    limits.angle_min = -2.f;
    limits.angle_max = 3.5f;
    limits.angle_increment = 0.02f;
    limits.range_min = 1.25f;
    limits.range_max = 2.09f;
    limits.max_height = 1.f;
    detection.setScanLimits (limits);
    Result result;
    detection.detect (result.obstacles, result.classes);

    std::vector<float> expected (276, std::numeric_limits<float>::infinity());
    for (const auto& obstacle : result.obstacles)
      for (const auto i : obstacle.indices) {
        const Eigen::Vector3f p =
            to_base * (*scene.cloud)[static_cast<std::size_t> (i)].getVector3fMap();
        const float range = std::hypot (p.x(), p.y());
        double angle = std::atan2 (p.y(), p.x()) + 2.;
        if (angle < -0.01)
          angle += 2. * M_PI;
        const auto step = static_cast<std::size_t> (std::lround (angle / 0.02));
        if (range <= 2.09f && p.z() <= 1.f && step < expected.size())
          expected[step] = std::min (expected[step], range);
      }
    for (float& range : expected)
      if (range < 1.25f)
        range = -std::numeric_limits<float>::infinity();
    EXPECT_TRUE (std::isinf (*std::min_element (expected.begin(), expected.end())));
    const auto& scan = detection.getScan();
    EXPECT_FLOAT_EQ (scan.angle_min, -2.f);
    EXPECT_FLOAT_EQ (scan.angle_max, 3.5f);
    EXPECT_FLOAT_EQ (scan.angle_increment, 0.02f);
    EXPECT_FLOAT_EQ (scan.range_min, 1.25f);
    EXPECT_FLOAT_EQ (scan.range_max, 2.09f);
    ASSERT_EQ (scan.ranges.size(), expected.size());
    EXPECT_GT (std::count_if (expected.begin(),
                              expected.end(),
                              [] (float range) { return std::isfinite (range); }),
               5);
    std::size_t different = 0;
    for (std::size_t k = 0; k < expected.size(); ++k)
      different += !(expected[k] == scan.ranges[k] ||
                     std::abs (expected[k] - scan.ranges[k]) < 1e-4f);
    EXPECT_LE (different, 2u) << "points that rounding puts on the other side";
  }
}

TEST (ObstacleScan, TheScanOfAnObstacleHasNoGapsWherePixelsAreWiderThanItsSteps)
{
  // Two sills with a gap between them, 5 degrees wide.
  const auto sills = box ({1.f, -3.f, 0.f}, {1.05f, 0.f, 0.06f}) +
                     box ({1.f, 0.09f, 0.f}, {1.05f, 3.f, 0.06f});
  const FloorScene scene (only_floor + sills, cameraPose (1.f, 0.8f), 160);
  constexpr auto turn = static_cast<float> (2. * M_PI);
  Detection detection;
  setInput (detection, scene);
  // Ahead; behind, where the first direction follows on the last one, in the gap or on a sill.
  for (const float yaw : {0.f, turn / 2.f, turn / 2.f + 0.2f, turn / 2.f - 0.2f}) {
    detection.setCameraToBase (Eigen::AngleAxisf (yaw, Eigen::Vector3f::UnitZ()) *
                               scene.camera_to_base);
    pcl::rgbd_planes::ScanLimits limits;
    limits.angle_increment = turn / 3600.f;
    limits.angle_min = -turn / 2.f;
    limits.angle_max = turn / 2.f - limits.angle_increment;
    detection.setScanLimits (limits);
    std::vector<Obstacle> obstacles;
    detection.detect (obstacles);
    const auto& ranges = detection.getScan().ranges;
    ASSERT_EQ (ranges.size(), 3600u);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const float angle =
          limits.angle_min + static_cast<float> (i) * limits.angle_increment - yaw;
      const float x = std::cos (angle), y = std::sin (angle) / x;
      if (x > 0.f && ((y > -0.5f && y < -0.01f) || (y > 0.1f && y < 0.5f))) {
        EXPECT_NEAR (ranges[i] * x, 1.f, 0.02f) << angle << ", " << yaw;
      }
      if (x > 0.f && y > 0.01f && y < 0.08f) {
        EXPECT_TRUE (std::isinf (ranges[i])) << angle << ", " << yaw;
      }
    }
  }
}

TEST (ObstacleScan, ATurnOfNoWholeNumberOfIncrementsHasNoGap)
{
  const auto post = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> (
      640, 480, pcl::PointXYZ (not_a_number, not_a_number, not_a_number));
  for (int v = 200; v < 280; ++v)
    for (int u = 318; u < 322; ++u)
      post->at (u, v) = {(static_cast<float> (u) - 319.5f) / 525.f,
                         (static_cast<float> (v) - 239.5f) / 525.f,
                         1.f};
  Detection detection;
  detection.setInputCloud (post);
  detection.setInputNormals (pcl::make_shared<pcl::PointCloud<pcl::Normal>> (640, 480));
  detection.setInputPlanes (
      {},
      pcl::make_shared<pcl::PointCloud<pcl::Label>> (640, 480, pcl::Label{no_plane}));
  pcl::rgbd_planes::ScanLimits limits;
  limits.angle_min = 0.f;
  limits.angle_max = static_cast<float> (2. * M_PI);
  limits.angle_increment = 0.1f; // the last of 62 directions is 6.1
  detection.setScanLimits (limits);
  for (float yaw = -0.22f; yaw < 0.05f; yaw += 0.02f) {
    detection.setCameraToBase (Eigen::AngleAxisf (yaw, Eigen::Vector3f::UnitZ()) *
                               cameraPose (0.5f, 0.f));
    std::vector<Obstacle> obstacles;
    detection.detect (obstacles);
    const auto& ranges = detection.getScan().ranges;
    ASSERT_EQ (ranges.size(), 62u);
    EXPECT_EQ (std::isfinite (ranges.front()), yaw > -0.0917f) << yaw;
    EXPECT_EQ (std::isfinite (ranges.back()), yaw < -0.0917f) << yaw;
  }
}

TEST (ObstacleScan, TheScanHasNoGapsWhereFewOfManyColumnsAreFarApart)
{
  // Seen across the front of the robot: three columns step back 5 cm each, many directions.
  constexpr int first = 136, step = 200, end = 264;
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> (
      640, 480, pcl::PointXYZ (not_a_number, not_a_number, not_a_number));
  for (int v = 200; v < 280; ++v)
    for (int u = first; u < end; ++u) {
      const float z = 0.4f + 0.05f * static_cast<float> (std::clamp (u - step, 0, 3));
      cloud->at (u, v) = {z * (static_cast<float> (u) - 319.5f) / 525.f,
                          z * (static_cast<float> (v) - 239.5f) / 525.f,
                          z};
    }
  Detection detection;
  Eigen::Affine3f to_left = cameraPose (0.5f, 0.f);
  to_left.prerotate (
      Eigen::AngleAxisf (static_cast<float> (M_PI / 2.), Eigen::Vector3f::UnitZ()));
  to_left.pretranslate (Eigen::Vector3f (0.6f, -0.3f, 0.f));
  detection.setCameraToBase (to_left);
  detection.setInputCloud (cloud);
  detection.setInputNormals (pcl::make_shared<pcl::PointCloud<pcl::Normal>> (640, 480));
  detection.setInputPlanes (
      {},
      pcl::make_shared<pcl::PointCloud<pcl::Label>> (640, 480, pcl::Label{no_plane}));
  std::vector<Obstacle> obstacles;
  detection.detect (obstacles);
  ASSERT_EQ (obstacles.size(), 1u);
  const auto& ranges = detection.getScan().ranges;
  const auto isSeen = [] (float range) { return std::isfinite (range); };
  const auto right = std::find_if (ranges.begin(), ranges.end(), isSeen);
  const auto left = std::find_if (ranges.rbegin(), ranges.rend(), isSeen).base();
  EXPECT_GT (left - right, 30);
  EXPECT_TRUE (std::all_of (right, left, isSeen));
}

TEST (ObstacleScan, TheScanOfAWallHasNoGapsWhoseEndsAreOutOfRange)
{
  // What is in range lies between two columns that are 64 apart.
  Eigen::Affine3f turned = cameraPose (1.5f, 0.f);
  turned.prerotate (Eigen::AngleAxisf (0.105f, Eigen::Vector3f::UnitZ()));
  const auto wall = box ({2.f, -4.f, 0.f}, {2.1f, 4.f, 4.f});
  const FloorScene scene (only_floor + wall, turned);
  Detection detection;
  setInput (detection, scene);
  pcl::rgbd_planes::ScanLimits limits;
  limits.angle_increment = 0.002f;
  limits.range_max = 2.f / std::cos (0.13f);
  detection.setScanLimits (limits);
  std::vector<Obstacle> obstacles;
  detection.detect (obstacles);
  const auto& ranges = detection.getScan().ranges;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const float angle =
        limits.angle_min + static_cast<float> (i) * limits.angle_increment;
    if (std::abs (angle) < 0.12f) {
      EXPECT_NEAR (ranges[i] * std::cos (angle), 2.f, 0.01f) << angle;
    }
  }
}

// Where a column looks changes from row to row: what it saw last says nothing of points that
// are out of limits.
TEST (ObstacleScan, NothingIsNearerThanThePointsThere)
{
  const auto things = a_box + box ({2.f, -2.5f, 0.f}, {2.1f, 2.5f, 3.f}) +
                      box ({0.9f, -0.9f, 0.65f}, {1.6f, -0.4f, 0.7f}) +
                      box ({1.5f, 0.5f, 0.f}, {1.6f, 0.6f, 1.8f});
  for (const float roll : {0.f, 0.3f, 1.57f, -1.57f}) {
    Eigen::Affine3f rolled = cameraPose (1.2f, 0.3f);
    rolled.rotate (Eigen::AngleAxisf (roll, Eigen::Vector3f::UnitZ()));
    const FloorScene scene (only_floor + things, rolled, 320);
    Detection detection;
    setInput (detection, scene);
    for (const float max_height : {0.2f, 0.5f, 1.f}) {
      pcl::rgbd_planes::ScanLimits limits;
      limits.max_height = max_height;
      detection.setScanLimits (limits);
      Result result;
      detection.detect (result.obstacles, result.classes);
      const auto& scan = detection.getScan();
      const auto size = static_cast<int> (scan.ranges.size());
      std::vector<float> nearest (scan.ranges.size(),
                                  std::numeric_limits<float>::infinity());
      for (const auto& obstacle : result.obstacles)
        for (const auto i : obstacle.indices) {
          const Eigen::Vector3f p =
              scene.camera_to_base *
              (*scene.cloud)[static_cast<std::size_t> (i)].getVector3fMap();
          const float step =
              (std::atan2 (p.y(), p.x()) - scan.angle_min) / scan.angle_increment;
          // A point is half-way to its neighbours as well.
          const int pixel = 3, k = static_cast<int> (std::lround (step));
          if (p.z() > max_height)
            continue;
          for (int near = std::max (0, k - pixel);
               near <= std::min (size - 1, k + pixel);
               ++near) {
            float& range = nearest[static_cast<std::size_t> (near)];
            range = std::min (range, std::hypot (p.x(), p.y()));
          }
        }
      EXPECT_GT (std::count_if (scan.ranges.begin(),
                                scan.ranges.end(),
                                [] (float range) { return std::isfinite (range); }),
                 20);
      for (std::size_t k = 0; k < nearest.size(); ++k)
        EXPECT_GE (scan.ranges[k], nearest[k] - 1e-4f)
            << k << ", " << roll << ", " << max_height;
    }
  }
}

TEST (ObstacleScan, DirectionsAreRounded)
{
  // Seen from 6.1 to 8.5 degrees to the left: the direction of 10 degrees is the nearest one.
  const auto pole = box ({1.5f, 0.16f, 0.f}, {1.52f, 0.22f, 0.3f});
  const FloorScene scene (only_floor + pole, pose, 320);
  Detection detection;
  setInput (detection, scene);
  pcl::rgbd_planes::ScanLimits limits;
  limits.angle_increment = static_cast<float> (M_PI / 18.);
  detection.setScanLimits (limits);
  std::vector<Obstacle> obstacles;
  detection.detect (obstacles);
  const auto& ranges = detection.getScan().ranges;
  ASSERT_EQ (ranges.size(), 19u);
  for (std::size_t i = 0; i < ranges.size(); ++i)
    EXPECT_EQ (std::isfinite (ranges[i]), i == 10) << i;
}

TEST (ObstacleScan, TheScanHasWhatIsKnownLateToBeNoSpeck)
{
  const FloorScene scene (only_floor + a_box, pose, 320);
  Detection detection;
  setInput (detection, scene);
  std::vector<Obstacle> expected, found;
  detection.detect (expected);
  ASSERT_EQ (expected.size(), 1u);
  const std::vector<float> ranges = detection.getScan().ranges;
  // Its last row tells that it is large enough.
  detection.setMinClusterSize (static_cast<unsigned> (expected[0].indices.size()));
  detection.detect (found);
  ASSERT_EQ (found.size(), 1u);
  EXPECT_EQ (found[0].nearest, expected[0].nearest);
  EXPECT_EQ (detection.getScan().ranges, ranges);
}

TEST (ObstacleScan, TheScanDoesNotDependOnFramesBefore)
{
  Detection reused;
  std::vector<Obstacle> obstacles;
  for (int k = 0; k < 6; ++k) {
    const float x = 1.f + 0.1f * static_cast<float> (k / 2);
    const auto sill = box ({x, -3.f, 0.f}, {x + 0.05f, 3.f, 0.06f});
    const FloorScene scene (
        only_floor + sill, cameraPose (0.1f, 0.f), 160, kinectSigma);
    setInput (reused, scene);
    reused.detect (obstacles);
    Detection fresh;
    setInput (fresh, scene);
    fresh.detect (obstacles);
    EXPECT_EQ (reused.getScan().ranges, fresh.getScan().ranges) << "frame " << k;
  }
}
