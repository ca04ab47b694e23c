// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "obstacle_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace obstacle_scenes;

TEST (DropOffs, AStepDownIsADropOffAtItsEdge)
{
  Patch near = floorAt (0.f);
  near.covers = [] (const Eigen::Vector3f& p) { return p.x() < 1.5f; };
  const FloorScene scene ({near, floorAt (-0.2f)}, pose, 320);
  const Result result = detect (scene);
  ASSERT_EQ (result.obstacles.size(), 1u);
  EXPECT_EQ (result.obstacles[0].kind, Obstacle::Kind::drop_off);
  EXPECT_EQ (share (scene, result, 1, 1, ObstacleClass::drop_off), 1.);
  EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.);
  EXPECT_NEAR (result.obstacles[0].distance, 1.5f, 0.02f);
  EXPECT_NEAR (result.obstacles[0].nearest.z(), 0.f, 1e-3f);
}

TEST (DropOffs, AHoleInTheFloorIsADropOff)
{
  const auto is_hole = [] (const Eigen::Vector3f& p) {
    return p.x() > 1.2f && p.x() < 1.6f && std::abs (p.y()) < 0.2f;
  };
  Patch with_hole = floorAt (0.f);
  with_hole.covers = [is_hole] (const Eigen::Vector3f& p) { return !is_hole (p); };
  const FloorScene scene ({with_hole, floorAt (-0.3f)}, pose, 320);
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  ASSERT_EQ (result.obstacles.size(), 1u);
  EXPECT_EQ (result.obstacles[0].kind, Obstacle::Kind::drop_off);
  EXPECT_NEAR (result.obstacles[0].distance, 1.2f, 0.02f);
  const auto& scan = detection.getScan();
  EXPECT_NEAR (scan.ranges[180], 1.2f, 0.02f) << "straight ahead";
  EXPECT_TRUE (std::isinf (scan.ranges[230])) << "25 degrees left of it";
}

TEST (DropOffs, ADropOffWhoseEdgeIsOutOfViewIsWhereRaysMeetZero)
{
  // The lowest rays of the image meet z = 0 at 1.21 m, and what is below it at 1.81 m.
  const auto on_it = box ({1.9f, 0.3f, -0.5f}, {2.2f, 0.7f, 0.2f});
  const FloorScene scene (
      std::vector<Patch>{floorAt (-0.5f)} + on_it, cameraPose (1.f, 0.262f), 320);
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  EXPECT_FALSE (detection.isFloorFound());
  EXPECT_EQ (detection.getFloor(), Eigen::Vector4f::Zero());
  EXPECT_EQ (result.count (ObstacleClass::floor), 0u);
  EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::drop_off), 1.);
  for (std::size_t i = 0; i < scene.cloud->size(); ++i)
    if (scene.inBase (i).z() > 0.f) {
      EXPECT_EQ (result[i], ObstacleClass::obstacle) << i;
    }
  ASSERT_GE (result.obstacles.size(), 2u);
  EXPECT_EQ (result.obstacles[0].kind, Obstacle::Kind::drop_off);
  EXPECT_NEAR (result.obstacles[0].distance, 1.21f, 0.01f);
  EXPECT_NEAR (result.obstacles[0].nearest.z(), 0.f, 1e-3f);
  EXPECT_NEAR (detection.getScan().ranges[180], 1.21f, 0.01f) << "straight ahead";

  // z = 0 of the default pose is the height of the camera, and tells nothing.
  detection.setCameraToBase (Detection().getCameraToBase());
  detection.detect (result.obstacles, result.classes);
  EXPECT_EQ (result.count (ObstacleClass::drop_off), 0u);
}

TEST (DropOffs, ShallowDropsAreNone)
{
  Patch near = floorAt (0.f);
  near.covers = [] (const Eigen::Vector3f& p) { return p.x() < 1.f; };
  const FloorScene scene ({near, floorAt (-0.02f)}, pose);
  EXPECT_EQ (detect (scene).count (ObstacleClass::drop_off), 0u);
}
