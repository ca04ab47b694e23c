// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "obstacle_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace obstacle_scenes;

TEST (FloorLevels, APieceOfTheFloorThatTheErrorOfDepthBentIsFloor)
{
  const Eigen::Affine3f high = cameraPose (1.4f, 0.45f);
  Patch floor = floorAt (0.f);
  floor.covers = [] (const Eigen::Vector3f& p) { return p.y() < 0.5f; };
  // Rises by 2 degrees, to more than 4.5 standard deviations of height; falls by 2.6.
  for (const float slope : {0.035f, -0.045f}) {
    const Patch piece{Eigen::Vector3f (0.f, -slope, 1.f).normalized(),
                      {0.f, 0.5f, 0.f},
                      [] (const Eigen::Vector3f& p) { return p.y() > 0.7f; }};
    const FloorScene scene ({floor, piece}, high, 320, kinectSigma);
    const Result result = detect (scene);
    EXPECT_GT (share (scene, result, 1, 1, ObstacleClass::floor), 0.998) << slope;
  }
}

TEST (FloorLevels, APieceOfTheFloorIsFloorToItsEnds)
{
  const Eigen::Affine3f high = cameraPose (1.4f, 0.45f);
  Patch floor = floorAt (0.f);
  floor.covers = [] (const Eigen::Vector3f& p) { return p.y() < 0.5f; };
  // Its near end is 3.5 standard deviations of depth below the floor, or above it.
  for (const float slope : {0.05f, -0.05f}) {
    const Patch piece{Eigen::Vector3f (0.f, -slope, 1.f).normalized(),
                      {0.f, 1.5f, 0.f},
                      [] (const Eigen::Vector3f& p) { return p.y() > 0.7f; }};
    const FloorScene scene ({floor, piece}, high, 320, kinectSigma);
    const Result result = detect (scene);
    EXPECT_GT (share (scene, result, 1, 1, ObstacleClass::floor), 0.99) << slope;
  }
}

TEST (FloorLevels, OnlyLargePiecesOfTheFloorMayBeBentMuch)
{
  const Eigen::Affine3f high = cameraPose (1.4f, 0.45f);
  Patch floor = floorAt (0.f);
  floor.covers = [] (const Eigen::Vector3f& p) { return std::abs (p.y()) < 0.5f; };
  for (const bool is_large : {true, false}) {
    // 1.1 to 2.4 standard deviations of depth high.
    Patch piece = floorAt (0.035f);
    piece.covers = [is_large] (const Eigen::Vector3f& p) {
      return p.y() > 0.7f && p.x() > 2.f && p.x() < 3.5f && (is_large || p.y() < 1.f);
    };
    const FloorScene scene ({floor, piece}, high, 320);
    const Result result = detect (scene);
    const double share_of_floor = share (scene, result, 1, 1, ObstacleClass::floor);
    if (is_large)
      EXPECT_EQ (share_of_floor, 1.);
    else
      EXPECT_LT (share_of_floor, 0.1);
  }
}

TEST (FloorLevels, ASmallPieceThatTheFloorPassesIntoMayBeBentAsMuch)
{
  const Eigen::Affine3f high = cameraPose (1.4f, 0.45f);
  Patch floor = floorAt (0.f);
  floor.covers = [] (const Eigen::Vector3f& p) { return p.y() < 0.5f; };
  // Two standard deviations of depth high in the mean, without and with a step.
  for (const float slope : {0.08f, 0.f}) {
    const Patch piece{Eigen::Vector3f (0.f, -slope, 1.f).normalized(),
                      {0.f, 0.5f, slope > 0.f ? 0.f : 0.04f},
                      [] (const Eigen::Vector3f& p) {
                        return p.x() > 2.f && p.x() < 3.5f && p.y() > 0.5f &&
                               p.y() < 1.5f;
                      }};
    const FloorScene scene ({floor, piece}, high, 320);
    const Result result = detect (scene);
    const double share_of_floor = share (scene, result, 1, 1, ObstacleClass::floor);
    if (slope > 0.f)
      EXPECT_EQ (share_of_floor, 1.);
    else
      EXPECT_LT (share_of_floor, 0.1);
  }
}

TEST (FloorLevels, PiecesOfTheFloorThatTheErrorOfDepthBentApartAreFloor)
{
  const Eigen::Affine3f high = cameraPose (1.4f, 0.45f);
  // Three standard deviations of depth apart, and more at the near end. The error of depth may
  // have moved both only if z = 0 is between them.
  for (const float low : {-0.015f, 0.f}) {
    Patch floor = floorAt (low), piece = floorAt (low + 0.03f);
    floor.covers = [] (const Eigen::Vector3f& p) {
      return p.y() < 0.1f && p.x() < 3.f;
    };
    piece.covers = [] (const Eigen::Vector3f& p) {
      return p.y() > 0.4f && p.x() < 3.f;
    };
    const FloorScene scene ({floor, piece}, high, 320);
    const Result result = detect (scene);
    const double share_of_floor = share (scene, result, 1, 1, ObstacleClass::floor);
    if (low < 0.f)
      EXPECT_GT (share_of_floor, 0.99);
    else
      EXPECT_LT (share_of_floor, 0.1);
  }
}

TEST (FloorLevels, ASmallPieceApartFromTheFloorIsFloorIfBothAreAtZero)
{
  // Tilted by 2.3 degrees: in its plane, the piece is six standard deviations of depth too low.
  Patch floor{Eigen::Vector3f (0.f, -0.04f, 1.f).normalized(),
              {0.f, -0.4f, 0.f},
              [] (const Eigen::Vector3f& p) { return p.y() < -0.1f; }};
  for (const float height : {0.f, -0.03f}) {
    Patch piece = floorAt (height);
    piece.covers = [] (const Eigen::Vector3f& p) {
      return p.y() > 0.5f && p.y() < 0.7f && p.x() < 2.f;
    };
    const FloorScene scene ({floor, piece}, cameraPose (1.4f, 0.45f), 320);
    const Result result = detect (scene);
    const double share_of_floor = share (scene, result, 1, 1, ObstacleClass::floor);
    if (height == 0.f)
      EXPECT_GT (share_of_floor, 0.99);
    else
      EXPECT_LT (share_of_floor, 0.1);
  }
}

TEST (FloorLevels, APieceOfTheFloorThatTheErrorOfDepthTiltedIsFloorWhereItIsLow)
{
  constexpr float edge = 0.8f;
  Patch floor = floorAt (0.f);
  floor.covers = [] (const Eigen::Vector3f& p) { return p.y() < edge; };
  // 9 degrees; the lower one ends 2.4 standard deviations of depth above the floor.
  for (const float width : {0.16f, 0.5f}) {
    const Patch piece{Eigen::Vector3f (0.f, -0.16f, 1.f).normalized(),
                      {0.f, edge, 0.f},
                      [width] (const Eigen::Vector3f& p) {
                        return p.y() >= edge && p.y() < edge + width && p.x() < 2.5f;
                      }};
    const FloorScene scene (
        {floor, piece}, cameraPose (1.05f, 0.35f), 320, kinectSigma);
    const Result result = detect (scene);
    EXPECT_GT (share (scene, result, 0, 0, ObstacleClass::floor), 0.99) << width;
    if (width < 0.2f) {
      EXPECT_GT (share (scene, result, 1, 1, ObstacleClass::floor), 0.95);
      continue;
    }
    std::size_t points = 0, of_floor = 0;
    for (std::size_t i = 0; i < scene.labels->size(); ++i)
      if ((*scene.labels)[i].label == 1 && scene.inBase (i).y() > edge + 0.06f) {
        ++points;
        of_floor += result[i] == ObstacleClass::floor;
      }
    EXPECT_LT (of_floor, points / 50) << "of those 1 cm and more above the floor";
  }
}

TEST (FloorLevels, LowObstaclesOnThePlaneOfAPieceOfTheFloorAreFound)
{
  const Eigen::Affine3f high = cameraPose (1.2f, 0.6f);
  Patch floor = floorAt (0.f), piece = floor;
  floor.covers = [] (const Eigen::Vector3f& p) { return p.x() < 3.f; };
  piece.covers = [] (const Eigen::Vector3f& p) { return p.x() > 3.2f; };
  const Patch top{Eigen::Vector3f::UnitZ(),
                  {0.f, 0.f, 0.025f}, // 4 standard deviations of depth
                  [] (const Eigen::Vector3f& p) {
                    return p.x() > 0.9f && p.x() < 1.1f && std::abs (p.y()) < 0.1f;
                  }};
  FloorScene scene ({floor, piece, top}, high, 320, kinectSigma);
  const FloorScene apart = scene;
  scene.labels.reset (new pcl::PointCloud<pcl::Label> (*apart.labels));
  for (auto& label : *scene.labels)
    if (label.label == 2u)
      label.label = 1u;
  scene.planes.resize (2);
  const Result result = detect (scene);
  EXPECT_GT (share (apart, result, 2, 2, ObstacleClass::obstacle), 0.8);
  EXPECT_GT (share (apart, result, 0, 1, ObstacleClass::floor), 0.998);
}

TEST (FloorLevels, AnotherLevelThatIsClearNearTheRobotIsNoFloorFurtherAway)
{
  constexpr float edge = 1.2f;
  const float pitch = 0.7f;
  // Where the levels begin, three standard deviations of depth are 2.1 cm, and 15 cm at 5 m.
  for (const float step : {-0.04f, 0.03f}) {
    Patch near = floorAt (0.f), far = floorAt (step);
    near.covers = [] (const Eigen::Vector3f& p) { return p.x() < edge; };
    far.covers = [] (const Eigen::Vector3f& p) { return p.x() >= edge; };
    const auto other = step < 0.f ? ObstacleClass::drop_off : ObstacleClass::obstacle;
    for (const std::uint32_t width : {160u, 320u, 640u}) {
      const FloorScene scene (
          {near, far}, cameraPose (1.3f, pitch), width, kinectSigma);
      const Result result = detect (scene);
      EXPECT_GT (share (scene, result, 1, 1, other), 0.99) << step << ", " << width;
      EXPECT_GT (share (scene, result, 0, 0, ObstacleClass::floor), 0.998) << step;
      ASSERT_EQ (result.obstacles.size(), 1u) << step << ", " << width;
      EXPECT_NEAR (result.obstacles[0].distance, edge, 0.03f);
    }
  }
}

TEST (FloorLevels, LevelsThatAreLowerThanObstaclesAndDropsAreFloor)
{
  for (const float step : {-0.04f, 0.03f}) {
    Patch near = floorAt (0.f), far = floorAt (step);
    near.covers = [] (const Eigen::Vector3f& p) { return p.x() < 1.2f; };
    far.covers = [] (const Eigen::Vector3f& p) { return p.x() >= 1.2f; };
    const FloorScene scene ({near, far}, cameraPose (1.3f, 0.7f), 160, kinectSigma);
    Detection detection;
    setInput (detection, scene);
    detection.setMinObstacleHeight (0.1f);
    detection.setMinDropDepth (0.1f);
    Result result;
    detection.detect (result.obstacles, result.classes);
    EXPECT_GT (share (scene, result, 1, 1, ObstacleClass::floor), 0.98) << step;
  }
}

TEST (FloorLevels, AStepOfThreeStandardDeviationsOfDepthAcrossTheViewIsNoFloor)
{
  constexpr float edge = 2.f;
  for (const float step : {-0.044f, -0.036f, 0.036f, 0.044f}) {
    Patch near = floorAt (0.f), far = floorAt (step);
    near.covers = [] (const Eigen::Vector3f& p) { return p.x() < edge; };
    far.covers = [] (const Eigen::Vector3f& p) { return p.x() >= edge; };
    const auto other = step < 0.f ? ObstacleClass::drop_off : ObstacleClass::obstacle;
    for (const std::uint32_t width : {160u, 320u, 640u}) {
      const FloorScene scene ({near, far}, cameraPose (1.f, 0.44f), width, kinectSigma);
      const Result result = detect (scene);
      EXPECT_GT (share (scene, result, 1, 1, other), 0.99) << step << ", " << width;
      EXPECT_GT (share (scene, result, 0, 0, ObstacleClass::floor), 0.998) << step;
    }
  }
}
