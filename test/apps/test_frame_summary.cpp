// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/frame_segmenter.h>
#include <pcl/apps/obstacle_report.h>
#include <pcl/apps/plane_report.h>

#include <gtest/gtest.h>

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
