// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "app_test.h"

#include <pcl/apps/frame_segmenter.h>
#include <pcl/apps/obstacle_report.h>
#include <pcl/apps/plane_report.h>
#include <pcl/simulation/simulate.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

using namespace pcl::rgbd_planes;
using nlohmann::json;

namespace {

using Rows = std::vector<std::vector<std::string>>;

Rows
readCsv (const std::filesystem::path& file, const std::string& header)
{
  std::istringstream lines (readFile (file));
  std::string line;
  std::getline (lines, line);
  EXPECT_EQ (line, header);
  Rows rows;
  while (std::getline (lines, line)) {
    rows.emplace_back();
    std::istringstream fields (line);
    for (std::string field; std::getline (fields, field, ',');)
      rows.back().push_back (field);
  }
  return rows;
}

Rows
readObstacles (const std::filesystem::path& file)
{
  return readCsv (file,
                  "frame,obstacle,kind,points,distance_m,direction_rad,nearest_x_m,"
                  "nearest_y_m,nearest_z_m,centroid_x_m,centroid_y_m,centroid_z_m");
}

/** What the colours of a picture of obstacles mean. */
enum class Meaning { unmeasured, floor, obstacle, drop_off, speck, nothing };

Meaning
meaningOf (const RgbImage& picture, std::size_t pixel)
{
  const std::uint8_t* colour = &picture.samples[3 * pixel];
  const int r = colour[0], g = colour[1], b = colour[2];
  return r == 0 && g == 0 && b == 0         ? Meaning::unmeasured
         : r == 255 && g == 255 && b == 255 ? Meaning::speck
         : g > r && g > b                   ? Meaning::floor
         : r > g && b == 0                  ? Meaning::obstacle
         : b > g && b > r                   ? Meaning::drop_off
                                            : Meaning::nothing;
}

/** The share of the pixels of which \a is_part is true that mean what is expected. */
template <typename IsPart>
double
share (const RgbImage& picture, Meaning expected, const IsPart& is_part)
{
  std::size_t part = 0, right = 0;
  for (std::size_t i = 0; i < picture.samples.size() / 3; ++i)
    if (is_part (i)) {
      ++part;
      right += meaningOf (picture, i) == expected;
    }
  EXPECT_GT (part, 0u);
  return static_cast<double> (right) / static_cast<double> (part);
}

class SegmentObstacles : public AppTest {
protected:
  SegmentObstacles() : AppTest (SEGMENT_PLANES) {}

  /** A depth image in mm of a camera 0.8 m above a floor that looks down by 30 degrees; a
   * box 30 cm high and 40 cm wide stands 1.2 m ahead, and from 2 m on the floor is
   * \a step lower. */
  void
  writeFloor (const std::string& name, double step) const
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
              static_cast<std::uint16_t> (std::lround (1000. * z));
      }
    writePng (folder_ / name, 320, depth);
  }

  json
  readFrame (const std::string& folder) const
  {
    return json::parse (readFile (folder_ / (folder + "/result.json")))["frames"][0];
  }

  static constexpr double pitch = M_PI / 6.;
  const std::string camera_ =
      " --intrinsics 262.5,262.5,159.5,119.5 --depth-scale 1000 ";
};

} // namespace

TEST_F (SegmentObstacles, PictureScanAndListAreTrue)
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

  // The closest true point in each direction, of those that are measured.
  std::vector<float> closest (361, std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < truth.truth->size(); ++i) {
    const Eigen::Vector3f p = truth.camera_to_base * (*truth.truth)[i].getVector3fMap();
    const auto direction = std::lround (std::atan2 (p.y(), p.x()) / M_PI * 360.) + 180;
    auto& range = closest[static_cast<std::size_t> (std::clamp (direction, 0l, 360l))];
    if (measured (i) && is_obstacle (i) && p.z() <= 2.f)
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
        std::stod (scan[i][0]), (static_cast<double> (i) - 180.) * M_PI / 360., 1e-4);
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
    ASSERT_EQ (rows[k].size(), 12u);
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
    const double x = obstacle["nearest_m"][0], y = obstacle["nearest_m"][1];
    EXPECT_NEAR (std::hypot (x, y), obstacle["distance_m"], 1e-5);
    EXPECT_NEAR (std::atan2 (y, x), obstacle["direction_rad"], 1e-5);
    EXPECT_GE (obstacle["distance_m"], last);
    last = obstacle["distance_m"];
  }
  for (const std::string stage : {"objects", "obstacles"})
    EXPECT_GT (frame["stage_times_ms"][stage], 0.) << stage;
}

TEST_F (SegmentObstacles, PoseIsGivenOrEstimatedFromTheFloor)
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

TEST_F (SegmentObstacles, AStepDownIsADropOff)
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

TEST_F (SegmentObstacles, WithoutAFloorNothingIsSafe)
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
