// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "obstacle_scenes.h"

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace obstacle_scenes;

namespace {

/** Replaces the true normals and planes by those that are found. */
void
segmentPlanes (FloorScene& scene)
{
  pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud (scene.cloud);
  estimation.compute (*scene.normals);
  pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> segmentation;
  segmentation.setInputCloud (scene.cloud);
  segmentation.setInputNormals (scene.normals);
  std::vector<pcl::PointIndices> inliers;
  segmentation.segment (scene.planes, inliers, *scene.labels);
}

} // namespace

TEST (ObstacleDetection, WhatSticksOutIsAnObstacle)
{
  for (const std::uint32_t width : {160u, 320u, 640u}) {
    const FloorScene scene (only_floor + a_box, pose, width);
    const Result result = detect (scene);
    ASSERT_EQ (result.obstacles.size(), 1u);
    const Obstacle& found = result.obstacles[0];
    EXPECT_EQ (found.kind, Obstacle::Kind::obstacle);
    EXPECT_TRUE (std::is_sorted (found.indices.begin(), found.indices.end()));
    for (const auto i : found.indices)
      EXPECT_EQ (result[static_cast<std::size_t> (i)], ObstacleClass::obstacle);
    EXPECT_EQ (found.indices.size(), result.count (ObstacleClass::obstacle));
    // All of the box but its lowest rows, nothing of the floor.
    EXPECT_GT (share (scene, result, 1, 6, ObstacleClass::obstacle), 0.9);
    EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.);
    EXPECT_NEAR (found.distance, 1.2f, 0.01f) << "the front, beside its centre";
    EXPECT_NEAR (found.direction, 0.f, 0.02f);
    EXPECT_NEAR (found.nearest.x(), 1.2f, 0.001f);
  }
}

TEST (ObstacleDetection, HeightsAreThoseOfTheLowestAndTheHighestPoint)
{
  Patch with_hole = floorAt (0.f);
  with_hole.covers = [] (const Eigen::Vector3f& p) {
    return p.x() < 1.7f || p.y() < 0.3f;
  };
  const auto lintel = box ({2.f, -2.f, 1.2f}, {2.2f, 0.f, 1.5f});
  // A camera that is rolled as well, and images whose rows end within a vector.
  for (const std::uint32_t width : {157u, 640u}) {
    const FloorScene scene (std::vector<Patch>{with_hole, floorAt (-0.3f)} + a_box +
                                lintel,
                            cameraPose (1.f, 0.2f, 0.2f),
                            width,
                            kinectSigma);
    Detection detection;
    setInput (detection, scene);
    const auto excluded = pcl::make_shared<pcl::Indices>();
    for (const bool has_excluded : {false, true}) {
      detection.setExcludedIndices (has_excluded ? excluded : nullptr);
      std::vector<Obstacle> obstacles;
      detection.detect (obstacles);
      ASSERT_GE (obstacles.size(), 3u);
      float lowest = 0.f, highest = 0.f;
      for (const auto& obstacle : obstacles) {
        std::vector<float> heights;
        for (const auto i : obstacle.indices)
          heights.push_back (
              (scene.camera_to_base *
               (*scene.cloud)[static_cast<std::size_t> (i)].getVector3fMap())
                  .z());
        const auto [low, high] = std::minmax_element (heights.begin(), heights.end());
        EXPECT_NEAR (obstacle.min_height, *low, 1e-4f);
        EXPECT_NEAR (obstacle.max_height, *high, 1e-4f);
        lowest = std::min (lowest, obstacle.min_height);
        highest = std::max (highest, obstacle.max_height);
      }
      EXPECT_LT (lowest, -0.25f) << "the hole";
      EXPECT_GT (highest, 1.3f) << "the lintel";
    }
  }
}

/** A rod that is 1 to 2 pixels wide: where it is slanted, pixels of it touch at corners only. */
TEST (ObstacleDetection, ThinThingsAreFoundHoweverTheyAreTurned)
{
  for (const float degrees : {0.f, 10.f, 30.f, 45.f, 60.f, 80.f, 90.f}) {
    const float angle = degrees * static_cast<float> (M_PI / 180.);
    const Eigen::Vector3f middle (2.f, 0.f, 0.8f);
    const Eigen::Vector3f along (0.f, std::sin (angle), std::cos (angle));
    const Patch rod{-Eigen::Vector3f::UnitX(), middle, [=] (const Eigen::Vector3f& p) {
                      const float way = along.dot (p - middle);
                      return std::fabs (way) < 0.3f &&
                             (p - middle - way * along).norm() < 0.0025f;
                    }};
    const FloorScene scene (
        only_floor + std::vector<Patch>{rod}, cameraPose (0.8f, 0.1f), 640);
    const Result result = detect (scene);
    EXPECT_GT (share (scene, result, 1, 1, ObstacleClass::obstacle), 0.9) << degrees;
  }
}

TEST (ObstacleDetection, LowObstaclesInTheNoiseAreFound)
{
  // 1 cm high where depth has a standard deviation of 3.2 mm.
  const auto low_box = box ({0.7f, -0.08f, 0.f}, {0.82f, 0.08f, 0.01f});
  for (const std::uint32_t width : {160u, 320u, 640u}) {
    const FloorScene scene (only_floor + low_box, pose, width, kinectSigma);
    const Result result = detect (scene);
    EXPECT_GE (share (scene, result, 1, 6, ObstacleClass::obstacle), 0.5) << width;
    EXPECT_GE (share (scene, result, 0, 0, ObstacleClass::floor), 0.998) << width;
  }
}

TEST (ObstacleDetection, WhatDoesNotStickOutButIsTurnedIsAnObstacle)
{
  FloorScene scene (only_floor, pose, 320);
  const Eigen::Vector3f up (scene.planes[0].values.data());
  const Eigen::Vector3f turned =
      Eigen::AngleAxisf (0.9f, Eigen::Vector3f::UnitX()) * up;
  for (std::uint32_t v = 100; v < 140; ++v)
    for (std::uint32_t u = 100; u < 160; ++u) {
      (*scene.normals) (u, v).getNormalVector3fMap() = turned;
      (*scene.labels) (u, v).label = no_plane;
    }
  // Alone, such normals are noise.
  for (std::uint32_t v = 0; v < 60; v += 6)
    for (std::uint32_t u = 0; u < 60; u += 6)
      (*scene.normals) (u, v).getNormalVector3fMap() = turned;
  const Result result = detect (scene);
  ASSERT_EQ (result.obstacles.size(), 1u);
  EXPECT_EQ (result.count (ObstacleClass::speck), 0u);
  EXPECT_GT (result.obstacles[0].indices.size(), 0.85 * 40 * 60);
  EXPECT_EQ (result.count (ObstacleClass::obstacle),
             result.obstacles[0].indices.size());
  for (const auto i : result.obstacles[0].indices) {
    EXPECT_TRUE (i / 320 >= 100 && i / 320 < 140) << i;
    EXPECT_TRUE (i % 320 >= 100 && i % 320 < 160) << i;
  }
}

/** Rotated cameras: the image is upside down, or its rows are its columns. */
TEST (ObstacleDetection, DoesNotDependOnWhichSideOfTheImageIsUp)
{
  FloorScene scene (only_floor + a_box, pose, 480, kinectSigma);
  const Eigen::Vector3f turned = Eigen::AngleAxisf (0.9f, Eigen::Vector3f::UnitX()) *
                                 Eigen::Vector3f (scene.planes[0].values.data());
  for (std::uint32_t v = 200; v < 240; ++v)
    for (std::uint32_t u = 50; u < 91; ++u)
      (*scene.normals) (u, v).getNormalVector3fMap() = turned;
  const Result upright = detect (scene);
  EXPECT_GT (upright.count (ObstacleClass::obstacle), 2000u);

  FloorScene rotated (only_floor, pose, 480);
  rotated.cloud = scene.cloud->makeShared();
  rotated.normals = scene.normals->makeShared();
  rotated.labels = scene.labels->makeShared();
  rotated.planes = scene.planes;
  std::reverse (rotated.cloud->begin(), rotated.cloud->end());
  std::reverse (rotated.normals->begin(), rotated.normals->end());
  std::reverse (rotated.labels->begin(), rotated.labels->end());
  const Result upside_down = detect (rotated);
  const std::uint32_t width = scene.cloud->width, height = scene.cloud->height;
  const auto turn = [&] (const auto& image, auto& portrait) {
    portrait.width = height;
    portrait.height = width;
    for (std::uint32_t v = 0; v < height; ++v)
      for (std::uint32_t u = 0; u < width; ++u)
        portrait (v, u) = image (u, v);
  };
  turn (*scene.cloud, *rotated.cloud);
  turn (*scene.normals, *rotated.normals);
  turn (*scene.labels, *rotated.labels);
  const Result portrait = detect (rotated);
  std::size_t others_upside_down = 0, others_in_portrait = 0;
  for (std::uint32_t v = 0; v < height; ++v)
    for (std::uint32_t u = 0; u < width; ++u) {
      const std::size_t i = std::size_t{v} * width + u;
      others_upside_down += upright[i] != upside_down[width * height - 1 - i];
      others_in_portrait += upright[i] != portrait[std::size_t{u} * height + v];
    }
  EXPECT_EQ (others_upside_down, 0u);
  EXPECT_EQ (others_in_portrait, 0u);
}

/** As windows have that reach over the border of a thing. */
TEST (ObstacleDetection, TurnedNormalsOfTheFloorBesideAThingAreNoObstacle)
{
  const auto board = box ({1.2f, -0.3f, 0.15f}, {1.205f, 0.3f, 0.4f});
  FloorScene scene (only_floor + board, pose);
  const Eigen::Vector3f front (scene.planes[box_front].values.data());
  std::size_t turned = 0;
  for (std::uint32_t v = 0; v < scene.labels->height; ++v)
    for (std::uint32_t u = 0; u + 1 < scene.labels->width; ++u)
      if ((*scene.labels) (u, v).label == 0 &&
          (*scene.labels) (u + 1, v).label == box_front) {
        (*scene.normals) (u, v).getNormalVector3fMap() = front;
        ++turned;
      }
  ASSERT_GT (turned, 10u);
  const Result result = detect (scene);
  EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.);
  EXPECT_EQ (share (scene, result, box_front, box_front, ObstacleClass::obstacle), 1.);
}

TEST (ObstacleDetection, ARampIsAnObstacleFromItsToeOn)
{
  // 8 degrees, from x = 1 m on.
  const Patch ramp{Eigen::Vector3f (-0.139f, 0.f, 0.99f).normalized(),
                   {1.f, 0.f, 0.f},
                   [] (const Eigen::Vector3f& p) {
                     return p.z() >= 0.f && p.x() < 1.6f && std::abs (p.y()) < 0.4f;
                   }};
  const FloorScene scene ({floorAt (0.f), ramp}, pose, 320);
  const Result result = detect (scene);
  ASSERT_EQ (result.obstacles.size(), 1u);
  for (std::size_t i = 0; i < scene.labels->size(); ++i) {
    const Eigen::Vector3f p = scene.inBase (i);
    if ((*scene.labels)[i].label == 1 && p.x() > 1.045f && std::abs (p.y()) < 0.38f) {
      EXPECT_EQ (result[i], ObstacleClass::obstacle) << p.transpose();
    }
  }
  EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.);
  EXPECT_LT (result.obstacles[0].distance, 1.03f);
}

TEST (ObstacleDetection, ATableIsAnObstacleThoughHorizontal)
{
  const auto table = box ({1.f, -0.6f, 0.28f}, {1.8f, 0.6f, 0.3f});
  const FloorScene scene (only_floor + table, pose);
  const Result result = detect (scene);
  EXPECT_EQ (share (scene, result, 1, 6, ObstacleClass::obstacle), 1.);
}

/** Less than 1 m away, after Holz et al. 2011, figure 4. It has no plane of its own. */
TEST (ObstacleDetection, ALighterOnATableIsAnObstacle)
{
  const auto lighter = box ({0.74f, -0.04f, 0.f}, {0.765f, 0.04f, 0.012f});
  // To the robot's floor, the table is an obstacle; to the table, the lighter is.
  for (const float table_height : {0.f, 0.7f}) {
    FloorScene scene (only_floor + lighter, cameraPose (0.5f, 0.6f), 640, kinectSigma);
    scene.camera_to_base.pretranslate (Eigen::Vector3f (0.f, 0.f, table_height));
    const auto patches = pcl::make_shared<pcl::PointCloud<pcl::Label>> (*scene.labels);
    segmentPlanes (scene);
    const Result result = detect (scene);
    *scene.labels = *patches;
    EXPECT_GE (share (scene, result, 1, 6, ObstacleClass::obstacle), 0.5);
    EXPECT_GE (
        share (scene,
               result,
               0,
               0,
               table_height > 0.f ? ObstacleClass::obstacle : ObstacleClass::floor),
        0.998);
  }
}

/** Fine structure is no noise, in which a robot would see nothing. */
TEST (ObstacleDetection, AFenceIsAnObstacleOnAFloor)
{
  constexpr float fence = 1.f;
  FloorScene scene (
      {floorAt (0.f), {{-1.f, 0.f, 0.f}, {4.f, 0.f, 0.f}}}, pose, 640, kinectSigma);
  std::vector<std::size_t> wires;
  for (std::size_t i = 0; i < scene.cloud->size(); ++i) {
    const std::size_t u = i % 640, v = i / 640;
    auto& point = (*scene.cloud)[i];
    if (((u + v) % 16 < 2 || (u + 480 - v) % 16 < 2) && point.z > fence) {
      point.getVector3fMap() *= fence / point.z;
      wires.push_back (i);
    }
  }
  segmentPlanes (scene);
  const Result result = detect (scene);
  const auto obstacles =
      std::count_if (wires.begin(), wires.end(), [&] (std::size_t i) {
        return result[i] == ObstacleClass::obstacle;
      });
  EXPECT_GT (static_cast<double> (obstacles), 0.9 * static_cast<double> (wires.size()));
  EXPECT_GT (result.count (ObstacleClass::floor), scene.cloud->size() / 4);
}

TEST (ObstacleDetection, ObstaclesHaveDistanceAndDirection)
{
  // Left of the robot, then right of it: their corners are nearest.
  for (const float side : {1.f, -1.f}) {
    const auto thing = box ({1.2f, std::min (0.3f * side, 0.5f * side), 0.f},
                            {1.5f, std::max (0.3f * side, 0.5f * side), 0.3f});
    const Result result = detect (FloorScene (only_floor + thing, pose, 320));
    ASSERT_EQ (result.obstacles.size(), 1u);
    EXPECT_NEAR (result.obstacles[0].distance, std::hypot (1.2f, 0.3f), 0.01f);
    EXPECT_NEAR (result.obstacles[0].direction, side * std::atan2 (0.3f, 1.2f), 0.01f);
  }
}

TEST (ObstacleDetection, ObstaclesAreSeparateWhereDepthJumpsAndComeByDistance)
{
  const auto behind = box ({2.5f, -0.3f, 0.f}, {2.7f, 0.6f, 1.f});
  const FloorScene scene (only_floor + behind + a_box, pose, 320);
  const Result result = detect (scene);
  ASSERT_EQ (result.obstacles.size(), 2u);
  EXPECT_NEAR (result.obstacles[0].distance, 1.2f, 0.01f);
  EXPECT_NEAR (result.obstacles[1].distance, 2.5f, 0.02f);
}

TEST (ObstacleDetection, AGapOfOnePixelDoesNotCutAnObstacle)
{
  const Result whole = detect (FloorScene (only_floor + a_box, pose));
  for (const bool is_column : {true, false}) {
    FloorScene scene (only_floor + a_box, pose);
    const auto& found = whole.obstacles.at (0).indices;
    const auto middle = static_cast<std::uint32_t> (found[found.size() / 2]);
    const std::uint32_t u = 80, v = middle / 160;
    for (std::uint32_t k = 0; k < (is_column ? scene.cloud->height : 160u); ++k)
      (is_column ? (*scene.cloud) (u, k) : (*scene.cloud) (k, v))
          .getVector3fMap()
          .setConstant (not_a_number);
    const Result result = detect (scene);
    EXPECT_EQ (result.obstacles.size(), 1u) << is_column;
    EXPECT_EQ (result[v * 160 + u], ObstacleClass::unmeasured);
  }
}

TEST (ObstacleDetection, SpecksAreNoObstacles)
{
  FloorScene scene (only_floor, pose, 320);
  std::vector<std::size_t> specks;
  for (std::uint32_t v = 50; v < 230; v += 30)
    for (std::uint32_t u = 20; u < 310; u += 30)
      for (const std::uint32_t k : {0u, 1u}) {
        specks.push_back (v * 320 + u + k);
        (*scene.cloud)[specks.back()].getVector3fMap() *= 0.7f;
      }
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  EXPECT_TRUE (result.obstacles.empty());
  EXPECT_EQ (result.count (ObstacleClass::speck), specks.size());
  for (const std::size_t i : specks)
    EXPECT_EQ (result[i], ObstacleClass::speck);
  for (const float range : detection.getScan().ranges)
    EXPECT_TRUE (std::isinf (range));

  detection.setMinClusterSize (2);
  detection.detect (result.obstacles, result.classes);
  EXPECT_EQ (result.obstacles.size(), specks.size() / 2);
}

TEST (ObstacleDetection, TheSmallestObstacleHasOnePointIn20000OfTheImageOrTwo)
{
  for (const auto& [width, least] : {std::pair (160u, 2u), {320u, 3u}})
    for (const std::uint32_t missing : {0u, 1u}) {
      const FloorScene scene (only_floor, pose, width);
      for (std::uint32_t k = 0; k < least - missing; ++k)
        (*scene.cloud) (width / 2 + k, width / 2).getVector3fMap() *= 0.7f;
      const Result result = detect (scene);
      EXPECT_EQ (result.obstacles.size(), 1 - missing) << width;
      EXPECT_EQ (result.count (ObstacleClass::speck), missing * (least - 1)) << width;
    }
}
