// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/frame_segmenter.h>
#include <pcl/apps/obstacle_report.h>
#include <pcl/apps/plane_report.h>
#include <pcl/filters/camera_pose.h>

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

using namespace pcl::rgbd_planes;

TEST (FrameSummary, NeedsNoIndicesForItsReports)
{
  InputOptions input;
  input.input = "sim:table_cluttered";
  input.step = 4;
  SegmenterOptions options;
  options.find_objects = options.find_obstacles = true;
  FrameSegmenter segmenter (options);
  std::vector<FrameSummary> frames{segmenter.segment (FrameSource (input).read (0))};
  const auto& objects = frames[0].objects;
  const auto& obstacles = frames[0].obstacles;
  ASSERT_FALSE (objects.empty());
  ASSERT_FALSE (obstacles.empty());
  const auto reports = [&] {
    std::ostringstream lists;
    printObjects (lists, frames[0]);
    printObstacles (lists, frames[0]);
    return lists.str() + objectsCsv (frames) + obstaclesCsv (frames) +
           resultJson (input, frames);
  };
  const std::string expected = reports();
  EXPECT_EQ (objects[0].object.indices.indices.size(), objects[0].points);
  EXPECT_EQ (obstacles[0].obstacle.indices.size(), obstacles[0].points);
  frames[0].freeIndices();
  EXPECT_EQ (reports(), expected);
  for (const auto& summary : objects)
    EXPECT_EQ (summary.object.indices.indices.capacity(), 0u);
  for (const auto& summary : obstacles)
    EXPECT_EQ (summary.obstacle.indices.capacity(), 0u);
}

/** Not by where it meets the ground below the camera. */
TEST (FrameSummary, HorizontalPlanesAreFloorOrTableByTheirPoints)
{
  Eigen::Affine3f pose = defaultCameraToBase();
  pose.translation().z() = 1.f;
  const Eigen::Vector3d level (0., -1., 0.),
      slight (0., -std::cos (0.15), -std::sin (0.15)),
      ramp (0., -std::cos (0.2), -std::sin (0.2));
  EXPECT_EQ (planeClass (level, {0., 1.04, 2.}, pose), "floor");
  EXPECT_EQ (planeClass (level, {0., 0.94, 2.}, pose), "table");
  EXPECT_EQ (planeClass (slight, {0., 1.02, 2.}, pose), "floor");
  EXPECT_EQ (planeClass (ramp, {0., 1.02, 2.}, pose), "table");
  EXPECT_EQ (planeClass (ramp, {0., 1. - 2. * std::tan (0.2), 2.}, pose), "table");
  EXPECT_EQ (planeClass (-level, {0., -2., 2.}, pose), "ceiling");
  EXPECT_EQ (planeClass ({0., 0., -1.}, {0., 0., 2.}, pose), "wall");
  EXPECT_EQ (planeClass ({0., -0.8, -0.6}, {0., 1., 2.}, pose), "slope");
  EXPECT_EQ (planeClass (level, {0., 1., 2.}, std::nullopt), "unknown");
}

TEST (FrameSummary, AFrameWithoutPoseLeavesTheHeightsOfPlanesOfTheNextOne)
{
  InputOptions input;
  input.input = "sim:table_cluttered";
  input.step = 2;
  SegmenterOptions options;
  options.find_objects = true;
  FrameSegmenter segmenter (options);
  Frame frame = FrameSource (input).read (0);
  Frame without_pose = frame;
  without_pose.camera_to_base.reset();
  EXPECT_FALSE (segmenter.segment (without_pose).objects.empty());
  frame.camera_to_base->translation().z() += 1.f; // the table is higher than 1.2 m
  EXPECT_TRUE (segmenter.segment (frame).objects.empty());
}
