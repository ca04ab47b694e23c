// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "app_test.h"

#include <pcl/io/pcd_io.h>
#include <pcl/simulation/simulate.h>
#include <pcl/simulation/subsample.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace pcl::rgbd_planes;

namespace {

class SimulateRgbd : public AppTest {
protected:
  SimulateRgbd() : AppTest (SIMULATE_RGBD) {}
};

} // namespace

TEST_F (SimulateRgbd, TheTruthGoesToAnotherFileToo)
{
  const Outcome outcome = run ("room --resolution qqvga --output d --json truth.json");
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  const std::string truth = readFile (folder_ / "truth.json");
  EXPECT_FALSE (truth.empty());
  EXPECT_EQ (truth, readFile (folder_ / "d/room_1_kinect_qqvga_truth.json"));
}

TEST_F (SimulateRgbd, TheFilesHoldTheFrame)
{
  const std::string name = "corridor_3_kinect_qqvga";
  const Outcome outcome =
      run ("corridor --seed 3 --sensor kinect --resolution qqvga --output new/d");
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  EXPECT_EQ (listFolder (folder_ / "new/d"),
             (std::vector<std::string>{name + ".pcd",
                                       name + "_colour.png",
                                       name + "_depth.png",
                                       name + "_planes.png",
                                       name + "_truth.json",
                                       name + "_truth.pcd"}));

  const auto frame = simulate ("corridor", 3, Sensor::kinect);
  const auto expected_cloud = subsample (*frame.cloud, 4);
  const auto expected_truth = subsample (*frame.truth, 4);
  pcl::PointCloud<pcl::PointXYZRGB> cloud;
  pcl::PointCloud<TruthPoint> truth;
  const auto path = (folder_ / "new/d" / name).string();
  ASSERT_EQ (pcl::io::loadPCDFile (path + ".pcd", cloud), 0);
  ASSERT_EQ (pcl::io::loadPCDFile (path + "_truth.pcd", truth), 0);
  ASSERT_EQ (cloud.width, 160u);
  ASSERT_EQ (cloud.height, 120u);
  ASSERT_EQ (truth.width, 160u);
  ASSERT_EQ (truth.height, 120u);
  const auto same = [] (float a, float b) {
    return a == b || (std::isnan (a) && std::isnan (b));
  };
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ASSERT_TRUE (same (cloud[i].x, expected_cloud[i].x));
    ASSERT_TRUE (same (cloud[i].z, expected_cloud[i].z));
    ASSERT_EQ (cloud[i].r, expected_cloud[i].r);
    ASSERT_EQ (truth[i].y, expected_truth[i].y);
    ASSERT_EQ (truth[i].normal_x, expected_truth[i].normal_x);
    ASSERT_EQ (truth[i].label, expected_truth[i].label);
    ASSERT_EQ (truth[i].object, expected_truth[i].object);
    ASSERT_EQ (truth[i].obstacle, expected_truth[i].obstacle);
    ASSERT_EQ (truth[i].edge, expected_truth[i].edge);
  }
  const auto colours = readRgbPng (path + "_colour.png");
  ASSERT_EQ (colours.width, 160u);
  EXPECT_EQ (colours.samples[0], cloud[0].r);
}

TEST_F (SimulateRgbd, TheSameSeedGivesTheSameFiles)
{
  for (const char* folder : {"a", "b"})
    ASSERT_EQ (run ("room --seed 2 --output " + std::string (folder)).code, 0);
  const auto files = listFolder (folder_ / "a");
  ASSERT_EQ (files.size(), 6u);
  for (const auto& file : files)
    EXPECT_EQ (readFile (folder_ / ("a/" + file)), readFile (folder_ / ("b/" + file)))
        << file;
}

TEST_F (SimulateRgbd, BadUsageIsToldInOneLine)
{
  expectRefused ("", "no SCENE");
  expectRefused ("room corridor --output .", "only 1 SCENE may be given");
  expectRefused ("room", "no --output");
  expectRefused ("attic --output .", "table_cluttered");
  expectRefused ("room --output . --sensor lidar", "ideal, kinect or active_stereo");
  expectRefused ("room --output . --seed -1", "--seed");
  for (const std::string sensor : {"ideal", "active_stereo"})
    expectRefused ("room --output . --camera 2 --sensor " + sensor, "--camera: only");
  expectRefused ("room --output . --resolution hd", "vga, qvga or qqvga");
  expectRefused ("room --output . --depth", "--help");
  expectRefused ("room --output /dev/null/folder", "/dev/null");
}

TEST_F (SimulateRgbd, HelpNamesTheScenes)
{
  const Outcome outcome = run ("--help");
  EXPECT_EQ (outcome.code, 0);
  for (const auto& scene : sceneNames())
    EXPECT_NE (outcome.out.find (scene), std::string::npos);
}
