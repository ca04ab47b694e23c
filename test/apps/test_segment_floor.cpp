// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "segment_obstacles_test.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

using namespace obstacle_outputs;
using nlohmann::json;

namespace {

class SegmentFloor : public SegmentObstaclesTest {
protected:
  /** A depth image in mm of a camera 0.8 m above a floor that looks down by 30 degrees; a
   * box 30 cm high and 40 cm wide stands 1.2 m ahead, and from 2 m on the floor is
   * \a step lower; all of it \a scale times as large. */
  void
  writeFloor (const std::string& name, double step, double scale = 1.) const
  {
    std::vector<std::uint16_t> depth (320 * 240);
    for (int v = 0; v < 240; ++v)
      for (int u = 0; u < 320; ++u) {
        const double x = (u - 159.5) / 262.5, y = (v - 119.5) / 262.5;
        const double ahead = std::cos (pitch) - y * std::sin (pitch);
        const double down = std::sin (pitch) + y * std::cos (pitch);
        double z = down > 0. ? 0.8 / down : 0.;
        if (z * ahead > 2.)
          z = std::max (2. / ahead, (0.8 + step) / down);
        const double at_box = 1.2 / ahead, height = 0.8 - at_box * down;
        if (std::fabs (x * at_box) < 0.2 && height > 0. && height < 0.3)
          z = at_box;
        if (z < 4.)
          depth[static_cast<std::size_t> (320 * v + u)] =
              static_cast<std::uint16_t> (std::lround (1000. * scale * z));
      }
    writePng (folder_ / name, 320, depth);
  }

  static constexpr double pitch = M_PI / 6.;
  const std::string camera_ =
      " --intrinsics 262.5,262.5,159.5,119.5 --depth-scale 1000 ";
};

} // namespace

TEST_F (SegmentFloor, PoseIsGivenOrEstimatedFromTheFloor)
{
  writeFloor ("floor.png", 0.);
  const std::string input = "floor.png --obstacles" + camera_;
  const Outcome given =
      run (input + "--base-transform 0.5,0.1,0.8,0,30,0 --output given");
  ASSERT_EQ (given.code, 0) << given.err;
  const Outcome estimated = run (input + "--output estimated");
  ASSERT_EQ (estimated.code, 0) << estimated.err;
  EXPECT_EQ (given.err, "");
  EXPECT_EQ (estimated.err,
             "pcl_segment_planes: pose of the camera: estimated, in floor from plane 0 "
             "as the floor, at a distance of 0.80 m; --base-transform gives the true "
             "one\n");
  for (const std::string folder : {"given", "estimated"}) {
    const json frame = readFrame (folder);
    EXPECT_EQ (frame["pose"], folder);
    EXPECT_EQ (frame["floor_found"], true);
    ASSERT_EQ (frame["obstacles"].size(), 1u);
    const double x = folder == "given" ? 1.7 : 1.2, y = folder == "given" ? 0.1 : 0.;
    EXPECT_NEAR (frame["camera_to_base"][2][3], 0.8, 0.005);
    EXPECT_EQ (frame["obstacles"][0]["kind"], "obstacle");
    EXPECT_NEAR (frame["obstacles"][0]["nearest_m"][0], x, 0.01);
    EXPECT_NEAR (frame["obstacles"][0]["centroid_m"][0], x, 0.01);
    EXPECT_NEAR (frame["obstacles"][0]["centroid_m"][1], y, 0.01);
    EXPECT_NEAR (frame["obstacles"][0]["centroid_m"][2], 0.15, 0.02);
  }
}

TEST_F (SegmentFloor, EstimatedPosesThatDifferAreTold)
{
  const auto errorOf = [&] (double scale) {
    std::filesystem::create_directory (folder_ / "two");
    writeFloor ("two/a.png", 0.);
    writeFloor ("two/b.png", 0., scale);
    return run ("two --obstacles --output out" + camera_).err;
  };
  const std::string differing = "pose of the camera: estimated at 0.80 to 1.20 m above";
  EXPECT_NE (errorOf (1.5).find (differing), std::string::npos) << errorOf (1.5);
  EXPECT_EQ (errorOf (1.1).find ("estimated at"), std::string::npos);
}

TEST_F (SegmentFloor, AStepDownIsADropOff)
{
  writeFloor ("step.png", 0.4);
  const Outcome result = run (
      "step.png --obstacles --base-transform 0,0,0.8,0,30,0 --output out" + camera_);
  ASSERT_EQ (result.code, 0) << result.err;
  const Rows rows = readObstacles (folder_ / "out/obstacles.csv");
  ASSERT_EQ (rows.size(), 2u);
  EXPECT_EQ (rows[0][2], "obstacle");
  EXPECT_EQ (rows[1][2], "drop_off");
  EXPECT_NEAR (std::stod (rows[1][4]), 2., 0.05);
  const RgbImage picture = readRgbPng (folder_ / "out/step_obstacles.png");
  const std::size_t far_left = 320 * 70 + 40, near = 320 * 230 + 160;
  EXPECT_EQ (meaningOf (picture, far_left), Meaning::drop_off);
  EXPECT_EQ (meaningOf (picture, near), Meaning::floor);
}

TEST_F (SegmentFloor, WithoutAFloorNothingIsSafe)
{
  writePng (folder_ / "dark.png", 160, std::vector<std::uint16_t> (160 * 120));
  writePng (folder_ / "wall.png", 160, std::vector<std::uint16_t> (160 * 120, 1500));
  const std::string camera = " --intrinsics 131,131,79.5,59.5 --depth-scale 1000 ";
  ASSERT_EQ (run ("dark.png --obstacles --output dark" + camera).code, 0);
  EXPECT_TRUE (readObstacles (folder_ / "dark/obstacles.csv").empty());
  EXPECT_EQ (readFrame ("dark")["floor_found"], false);
  EXPECT_EQ (readFrame ("dark")["pose"], "assumed");
  EXPECT_EQ (readFrame ("dark")["camera_to_base"], nullptr);

  const Outcome wall =
      run ("wall.png --obstacles --base-transform 0,0,1,0,0,0 --output wall" + camera);
  ASSERT_EQ (wall.code, 0) << wall.err;
  EXPECT_NE (wall.out.find ("no floor found: nothing is safe"), std::string::npos);
  ASSERT_EQ (readObstacles (folder_ / "wall/obstacles.csv").size(), 1u);
  EXPECT_NEAR (readFrame ("wall")["obstacles"][0]["distance_m"], 1.5, 0.01);
  const RgbImage picture = readRgbPng (folder_ / "wall/wall_obstacles.png");
  EXPECT_EQ (share (picture, Meaning::obstacle, [] (std::size_t) { return true; }), 1.);
}
