// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "obstacle_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

using namespace obstacle_scenes;

TEST (FloorPlane, AnEmptyFloorIsSafe)
{
  const FloorScene scene (only_floor, pose);
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  EXPECT_TRUE (detection.isFloorFound());
  EXPECT_TRUE (result.obstacles.empty());
  EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.);
  EXPECT_EQ (result.classes.width, 160u);
  EXPECT_EQ (detection.getScan().ranges.size(), 361u);
  for (const float range : detection.getScan().ranges)
    EXPECT_TRUE (std::isinf (range));
}

TEST (FloorPlane, WithoutAFloorAllIsAnObstacle)
{
  // A wall; then a floor that the pose of the camera does not put at z = 0.
  const Patch wall{-Eigen::Vector3f::UnitX(), {1.5f, 0.f, 0.f}};
  FloorScene scene ({wall}, cameraPose (0.8f, 0.f));
  (*scene.cloud)[5].getVector3fMap().setConstant (not_a_number);
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  EXPECT_FALSE (detection.isFloorFound());
  EXPECT_EQ (result.count (ObstacleClass::obstacle), scene.cloud->size() - 1);
  EXPECT_EQ (result[5], ObstacleClass::unmeasured);
  ASSERT_EQ (result.obstacles.size(), 1u);
  EXPECT_NEAR (result.obstacles[0].distance, 1.5f, 0.01f);

  const FloorScene low (only_floor, pose);
  setInput (detection, low);
  detection.setCameraToBase (cameraPose (0.9f, 0.45f));
  detection.detect (result.obstacles, result.classes);
  EXPECT_FALSE (detection.isFloorFound());
  EXPECT_EQ (result.count (ObstacleClass::floor), 0u);
  detection.setFloorTolerances (0.17f, 0.2f);
  detection.detect (result.obstacles, result.classes);
  EXPECT_TRUE (detection.isFloorFound());
}

TEST (FloorPlane, AtAnyHeightItIsTheLargestPlane)
{
  // Much of the view is a table, in front of more floor.
  Patch table = floorAt (0.5f), floor = floorAt (0.f);
  table.covers = [] (const Eigen::Vector3f& p) { return p.x() < 0.9f; };
  for (const bool table_first : {false, true}) {
    const FloorScene scene (table_first ? std::vector<Patch>{table, floor}
                                        : std::vector<Patch>{floor, table},
                            pose);
    Detection detection;
    setInput (detection, scene);
    detection.setFloorTolerances (0.17f, std::numeric_limits<float>::infinity());
    Result result;
    detection.detect (result.obstacles, result.classes);
    ASSERT_TRUE (detection.isFloorFound());
    EXPECT_NEAR (detection.getFloor()[3], 0.3f, 0.001f) << table_first;
  }
}

TEST (FloorPlane, ASlopeAcrossTheHeightOfTheFloorIsNoFloor)
{
  // 17 degrees, as far above z = 0 as below.
  const Patch slope{Eigen::Vector3f (-0.3f, 0.f, 1.f).normalized(),
                    {1.5f, 0.f, 0.f},
                    [] (const Eigen::Vector3f& p) { return std::abs (p.z()) < 0.1f; }};
  const FloorScene scene ({slope}, pose);
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  EXPECT_FALSE (detection.isFloorFound());
  detection.setFloorTolerances (0.35f, 0.1f);
  detection.detect (result.obstacles, result.classes);
  EXPECT_TRUE (detection.isFloorFound());
}

TEST (FloorPlane, TheCameraMayBeTiltedAndItsPoseSlightlyOff)
{
  for (const float pitch : {0.2f, 0.6f})
    for (const float roll : {-0.3f, 0.2f}) {
      const FloorScene scene (only_floor + a_box, cameraPose (0.8f, pitch, roll), 320);
      Detection detection;
      setInput (detection, scene);
      detection.setCameraToBase (cameraPose (0.82f, pitch + 0.01f, roll - 0.01f));
      Result result;
      detection.detect (result.obstacles, result.classes);
      ASSERT_EQ (result.obstacles.size(), 1u);
      EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.);
      EXPECT_NEAR (result.obstacles[0].distance, 1.2f, 0.03f);
    }
}

TEST (FloorPlane, AFloorIsFoundWithAnyTiltThatIsTolerated)
{
  const FloorScene scene (only_floor, pose, 320);
  for (const float off : {-0.15f, -0.05f, 0.05f, 0.15f}) {
    Detection detection;
    setInput (detection, scene);
    detection.setCameraToBase (cameraPose (0.8f, 0.45f + off));
    Result result;
    detection.detect (result.obstacles, result.classes);
    EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.) << off;
  }
}

TEST (FloorPlane, TheFloorIsNearZeroAlsoWhereMoreIsALittleHigherOrLower)
{
  constexpr float edge = 1.2f;
  for (const float step : {-0.045f, -0.03f, 0.03f, 0.045f}) {
    Patch near = floorAt (0.f), far = floorAt (step);
    near.covers = [] (const Eigen::Vector3f& p) { return p.x() < edge; };
    far.covers = [] (const Eigen::Vector3f& p) { return p.x() >= edge; };
    const FloorScene scene ({near, far}, pose, 320);
    const auto of_far = static_cast<std::size_t> (
        std::count_if (scene.labels->begin(), scene.labels->end(), [] (const auto& l) {
          return l.label == 1;
        }));
    ASSERT_GT (of_far, scene.labels->size() / 2);
    const Result result = detect (scene);
    EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.) << step;
  }
}

TEST (FloorPlane, OfLevelsSideBySideTheFloorIsTheOneNearestToZero)
{
  Patch floor = floorAt (0.f), platform = floorAt (0.04f);
  floor.covers = [] (const Eigen::Vector3f& p) { return p.y() > 0.15f; };
  platform.covers = [] (const Eigen::Vector3f& p) { return p.y() <= 0.15f; };
  const FloorScene scene ({platform, floor}, pose);
  Detection detection;
  setInput (detection, scene);
  std::vector<Obstacle> obstacles;
  detection.detect (obstacles);
  EXPECT_TRUE (
      detection.getFloor().isApprox (Eigen::Vector4f (scene.planes[1].values.data())));
}

TEST (FloorPlane, WhatIsBeyondTheRangeOfTheSensorIsNoFloor)
{
  const FloorScene scene (only_floor, pose);
  Detection detection;
  setInput (detection, scene);
  detection.setDepthNoise ({0.001f, 0.002f, 0.5f});
  std::vector<Obstacle> obstacles;
  detection.detect (obstacles);
  EXPECT_FALSE (detection.isFloorFound());
}

TEST (FloorPlane, TheFloorIsNearTheRobotWhereALowPlatformFillsTheView)
{
  constexpr float edge = 0.9f;
  for (const float step : {-0.03f, 0.02f, 0.03f}) {
    Patch near = floorAt (0.f), far = floorAt (step);
    near.covers = [] (const Eigen::Vector3f& p) { return p.x() < edge; };
    far.covers = [] (const Eigen::Vector3f& p) { return p.x() >= edge; };
    const FloorScene scene ({near, far}, cameraPose (1.f, 0.61f), 320);
    const Eigen::Vector4f floor (scene.planes[0].values.data());
    // The pose is right; it is 1 cm too high; its pitch is off.
    for (const Eigen::Affine3f& to_base :
         {cameraPose (1.f, 0.61f), cameraPose (1.01f, 0.61f), cameraPose (1.f, 0.6f)}) {
      Detection detection;
      setInput (detection, scene);
      detection.setCameraToBase (to_base);
      Result result;
      detection.detect (result.obstacles, result.classes);
      EXPECT_TRUE (detection.getFloor().isApprox (floor)) << step;
      EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.) << step;
    }
  }
}

TEST (FloorPlane, AStepBeforeTheRobotIsNoFloor)
{
  // It fills the near part of the view, and its points weigh most.
  for (const float height : {0.025f, 0.04f}) {
    Patch step = floorAt (height), floor = floorAt (0.f);
    step.covers = [] (const Eigen::Vector3f& p) { return p.x() < 0.9f; };
    floor.covers = [] (const Eigen::Vector3f& p) { return p.x() >= 0.9f; };
    const FloorScene scene ({step, floor}, cameraPose (0.4f, 0.35f), 320);
    const Result result = detect (scene);
    EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::obstacle), 1.) << height;
    EXPECT_EQ (share (scene, result, 1, 1, ObstacleClass::floor), 1.) << height;
  }
}

TEST (FloorPlane, ARampBeforeTheRobotIsNoFloor)
{
  for (const float degrees : {4.f, 5.f, 6.f, 8.f})
    for (const float toe : {0.75f, 0.8f, 0.9f, 1.f}) {
      const float angle = degrees * static_cast<float> (M_PI) / 180.f;
      const Patch ramp{{-std::sin (angle), 0.f, std::cos (angle)},
                       {toe, 0.f, 0.f},
                       [toe] (const Eigen::Vector3f& p) {
                         return p.x() >= toe && p.x() < toe + 2.f &&
                                std::abs (p.y()) < 0.8f;
                       }};
      Patch floor = floorAt (0.f);
      floor.covers = [ramp] (const Eigen::Vector3f& p) { return !ramp.covers (p); };
      const FloorScene scene ({floor, ramp}, cameraPose (1.f, 0.49f), 320, kinectSigma);
      const Result result = detect (scene);
      EXPECT_GT (share (scene, result, 0, 0, ObstacleClass::floor), 0.99)
          << degrees << ' ' << toe;
    }
}

/** Its plane took floor before it as well, so that it is at z = 0 in the mean. */
TEST (FloorPlane, ARampInOnePlaneWithSomeFloorIsNoFloor)
{
  const float angle = 4.f * static_cast<float> (M_PI) / 180.f;
  const Patch ramp{{-std::sin (angle), 0.f, std::cos (angle)},
                   {0.95f, 0.f, 0.f},
                   [] (const Eigen::Vector3f& p) { return std::abs (p.y()) < 0.5f; }};
  Patch floor = floorAt (0.f);
  floor.covers = [ramp] (const Eigen::Vector3f& p) { return !ramp.covers (p); };
  const FloorScene scene ({floor, ramp}, cameraPose (1.f, 0.49f), 320, kinectSigma);
  const Result result = detect (scene);
  EXPECT_GT (share (scene, result, 0, 0, ObstacleClass::floor), 0.99);
}

TEST (FloorPlane, APointAtTheSensorDoesNotChooseTheFloor)
{
  FloorScene scene (only_floor, pose, 320);
  const Eigen::Vector4f floor (scene.planes[0].values.data());
  scene.planes.push_back (scene.planes[0]);
  scene.planes[1].values[3] += 0.04f;
  // One of the points that are looked at.
  ASSERT_EQ (scene.cloud->height, 240u);
  (*scene.cloud) (162, 122).getVector3fMap() << 0.f, 0.f, 1e-10f;
  (*scene.labels) (162, 122).label = 1;
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  EXPECT_TRUE (detection.getFloor().isApprox (floor));
}

TEST (FloorPlane, TheFloorIsFoundInImagesOfFewRows)
{
  static constexpr std::uint32_t rows = 6; // of 768
  FloorScene scene (only_floor, pose, 1024);
  const auto takeRows = [] (auto& cloud) {
    auto wide = pcl::make_shared<std::decay_t<decltype (*cloud)>> (cloud->width, rows);
    for (std::uint32_t v = 0; v < rows; ++v)
      std::copy_n (
          &(*cloud) (0, v * cloud->height / rows), cloud->width, &(*wide) (0, v));
    cloud = wide;
  };
  takeRows (scene.cloud);
  takeRows (scene.normals);
  takeRows (scene.labels);
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  EXPECT_TRUE (detection.isFloorFound());
  EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.);
}

TEST (FloorPlane, APlaneInWhichTheCameraIsIsNoFloor)
{
  for (const float height : {0.005f, 0.05f}) {
    const FloorScene scene (only_floor, cameraPose (height, 0.45f));
    Detection detection;
    setInput (detection, scene);
    Result result;
    detection.detect (result.obstacles, result.classes);
    EXPECT_EQ (detection.isFloorFound(), height > 0.01f) << height;
  }
}

/** A ramp whose plane grew too far: noise alone is higher than the floor there. */
TEST (FloorPlane, FloorInThePlaneOfARampIsFloor)
{
  const Patch ramp{Eigen::Vector3f (-0.139f, 0.f, 0.99f).normalized(),
                   {1.2f, 0.f, 0.f},
                   [] (const Eigen::Vector3f& p) {
                     return p.z() >= 0.f && p.x() < 1.8f && std::abs (p.y()) < 0.4f;
                   }};
  FloorScene scene ({floorAt (0.f), ramp}, pose, 320, kinectSigma);
  std::vector<std::size_t> grown;
  for (std::size_t i = 0; i < scene.labels->size(); ++i) {
    const Eigen::Vector3f p = scene.inBase (i);
    if ((*scene.labels)[i].label == 0 && p.x() > 1.05f && p.x() < 1.17f &&
        std::abs (p.y()) < 0.4f) {
      (*scene.labels)[i].label = 1;
      grown.push_back (i);
    }
  }
  ASSERT_GT (grown.size(), 1000u);
  const Result result = detect (scene);
  const auto floor = std::count_if (grown.begin(), grown.end(), [&] (std::size_t i) {
    return result[i] == ObstacleClass::floor;
  });
  EXPECT_GT (static_cast<double> (floor), 0.95 * static_cast<double> (grown.size()));
}
