// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "segment_obstacles_test.h"

#include <pcl/simulation/simulate.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace obstacle_outputs;
using namespace pcl::rgbd_planes;
using nlohmann::json;

namespace {

class SegmentObstacles : public SegmentObstaclesTest {};

} // namespace

TEST_F (SegmentObstacles, PictureIsTrue)
{
  const Outcome result = run ("sim:floor_obstacles:3 --obstacles --output out");
  ASSERT_EQ (result.code, 0) << result.err;
  EXPECT_EQ (result.err, "");
  EXPECT_NE (result.out.find ("\nobstacles  "), std::string::npos) << result.out;
  const std::string name = "floor_obstacles_3";
  EXPECT_EQ (listFolder (folder_ / "out"),
             (std::vector<std::string>{name + "_depth.png",
                                       name + "_labels.pcd",
                                       name + "_normals.png",
                                       name + "_obstacles.png",
                                       name + "_planes.png",
                                       name + "_scan.csv",
                                       "obstacles.csv",
                                       "planes.csv",
                                       "result.json"}));

  const auto truth = simulate ("floor_obstacles", 3, Sensor::kinect);
  const auto measured = [&] (std::size_t i) {
    return std::isfinite ((*truth.cloud)[i].z);
  };
  const auto is_obstacle = [&] (std::size_t i) {
    return (*truth.truth)[i].obstacle != 0;
  };
  const RgbImage picture = readRgbPng (folder_ / ("out/" + name + "_obstacles.png"));
  EXPECT_EQ (share (picture,
                    Meaning::unmeasured,
                    [&] (std::size_t i) { return !measured (i); }),
             1.);
  EXPECT_GT (share (picture,
                    Meaning::obstacle,
                    [&] (std::size_t i) { return measured (i) && is_obstacle (i); }),
             0.95);
  EXPECT_GT (share (picture,
                    Meaning::floor,
                    [&] (std::size_t i) { return measured (i) && !is_obstacle (i); }),
             0.98);
}

TEST_F (SegmentObstacles, ScanIsTrue)
{
  const std::string name = "floor_obstacles_3";
  const Outcome result = run ("sim:floor_obstacles:3 --obstacles --output out");
  ASSERT_EQ (result.code, 0) << result.err;
  const auto truth = simulate ("floor_obstacles", 3, Sensor::kinect);
  // The closest true point in each direction, of those that are measured.
  constexpr std::size_t directions = 720;
  std::vector<float> closest (directions, std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < truth.truth->size(); ++i) {
    const Eigen::Vector3f p = truth.camera_to_base * (*truth.truth)[i].getVector3fMap();
    const auto direction = std::lround (std::atan2 (p.y(), p.x()) / M_PI * 360.) + 360;
    auto& range = closest[static_cast<std::size_t> (direction) % directions];
    if (std::isfinite ((*truth.cloud)[i].z) && (*truth.truth)[i].obstacle != 0 &&
        p.z() <= 2.f)
      range = std::min (range, p.head<2>().norm());
  }
  const Rows scan =
      readCsv (folder_ / ("out/" + name + "_scan.csv"), "direction_rad,range_m");
  ASSERT_EQ (scan.size(), closest.size());
  const json as_json = readFrame ("out")["scan"];
  ASSERT_EQ (as_json["ranges_m"].size(), closest.size());
  EXPECT_NEAR (as_json["angle_min_rad"], std::stod (scan[0][0]), 1e-5);
  EXPECT_NEAR (as_json["angle_increment_rad"], M_PI / 360., 1e-6);
  int seen = 0, right = 0;
  for (std::size_t i = 0; i < scan.size(); ++i) {
    EXPECT_NEAR (
        std::stod (scan[i][0]), (static_cast<double> (i) - 360.) * M_PI / 360., 1e-4);
    const float range = std::stof (scan[i][1]);
    seen += std::isfinite (closest[i]);
    right += std::isfinite (closest[i]) &&
             std::fabs (range - closest[i]) < 0.01f + 0.008f * range * range;
    EXPECT_EQ (scan[i][1] == "inf", std::isinf (range));
    const json& same = as_json["ranges_m"][i];
    EXPECT_TRUE (same.is_null() ? std::isinf (range)
                                : std::fabs (same.get<float>() - range) < 1e-4f);
  }
  EXPECT_GT (seen, 80);
  EXPECT_GT (right, 0.9 * seen);
}

TEST_F (SegmentObstacles, ListAndJsonSayTheSame)
{
  const Outcome result =
      run ("sim:floor_obstacles --resolution qvga --objects --obstacles --output out");
  ASSERT_EQ (result.code, 0) << result.err;
  const json frame = readFrame ("out");
  const Rows rows = readObstacles (folder_ / "out/obstacles.csv");
  ASSERT_GE (rows.size(), 10u);
  ASSERT_EQ (frame["obstacles"].size(), rows.size());
  EXPECT_GE (frame["objects"].size(), 5u);
  EXPECT_EQ (frame["floor_found"], true);
  double last = 0.;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const json& obstacle = frame["obstacles"][k];
    ASSERT_EQ (rows[k].size(), 14u);
    EXPECT_EQ (rows[k][0], "floor_obstacles_1");
    EXPECT_EQ (rows[k][1], std::to_string (k));
    EXPECT_EQ (rows[k][2], obstacle["kind"]);
    EXPECT_EQ (std::stoi (rows[k][3]), obstacle["points"]);
    EXPECT_NEAR (std::stod (rows[k][4]), obstacle["distance_m"], 1e-4);
    EXPECT_NEAR (std::stod (rows[k][5]), obstacle["direction_rad"], 1e-4);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR (std::stod (rows[k][6 + i]), obstacle["nearest_m"][i], 1e-4);
      EXPECT_NEAR (std::stod (rows[k][9 + i]), obstacle["centroid_m"][i], 1e-4);
    }
    EXPECT_NEAR (std::stod (rows[k][12]), obstacle["min_height_m"], 1e-4);
    EXPECT_NEAR (std::stod (rows[k][13]), obstacle["max_height_m"], 1e-4);
    const double height = obstacle["centroid_m"][2];
    EXPECT_LE (obstacle["min_height_m"], height);
    EXPECT_GE (obstacle["max_height_m"], height);
    const double x = obstacle["nearest_m"][0], y = obstacle["nearest_m"][1];
    EXPECT_NEAR (std::hypot (x, y), obstacle["distance_m"], 1e-5);
    EXPECT_NEAR (std::atan2 (y, x), obstacle["direction_rad"], 1e-5);
    EXPECT_GE (obstacle["distance_m"], last);
    last = obstacle["distance_m"];
  }
  for (const std::string stage : {"objects", "obstacles"})
    EXPECT_GT (frame["stage_times_ms"][stage], 0.) << stage;
}

TEST_F (SegmentObstacles, WithoutTheOptionNothingIsWritten)
{
  ASSERT_EQ (run ("sim:table_single --resolution qqvga --output out").code, 0);
  for (const auto& file : listFolder (folder_ / "out")) {
    EXPECT_EQ (file.find ("obstacle"), std::string::npos) << file;
    EXPECT_EQ (file.find ("scan"), std::string::npos) << file;
  }
  EXPECT_EQ (readFrame ("out")["pose"], "simulated");
  EXPECT_EQ (readFrame ("out")["floor_found"], nullptr);
  EXPECT_EQ (readFrame ("out").at ("scan"), nullptr);
}

TEST_F (SegmentObstacles, BadInputLeavesNothing)
{
  const std::string output = " --obstacles --objects --output out --json out.json ";
  expectRefused ("missing.pcd" + output, "missing.pcd: no such file");
  expectRefused ("sim:floor_obstacles --base-transform 1,2,3" + output,
                 "x,y,z,roll,pitch,yaw");
  expectRefused ("sim:floor_obstacles --obstacles --output out",
                 "cannot write",
                 "trap '' XFSZ && ulimit -f 1 &&");
  std::filesystem::create_directories (folder_ / "taken/obstacles.csv");
  expectRefused ("sim:floor_obstacles --obstacles --output taken", "no regular file");
  EXPECT_EQ (listFolder (folder_ / "taken"), std::vector<std::string>{"obstacles.csv"});
}
