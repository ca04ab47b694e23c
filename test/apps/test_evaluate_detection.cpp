// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "app_test.h"
#include "synthetic_clouds.h"

#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

using nlohmann::json;

namespace {

class EvaluateDetection : public AppTest {
protected:
  EvaluateDetection() : AppTest (EVALUATE_DETECTION) {}

  json
  results () const
  {
    return json::parse (readFile (folder_ / "table.json"))["results"];
  }
};

} // namespace

TEST_F (EvaluateDetection, ObstaclesOnSimulatedFloors)
{
  const Outcome outcome =
      run ("sim:floor_obstacles:1 sim:floor_obstacles:2 sim:floor_obstacles:3 --json "
           "table.json");
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  EXPECT_EQ (outcome.err, "");
  const json rows = results();
  ASSERT_EQ (rows.size(), 3u);
  const double max_false_percent[] = {0.1, 0.15, 0.2};
  const char* resolutions[] = {"vga", "qvga", "qqvga"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ (rows[i]["resolution"], resolutions[i]);
    EXPECT_EQ (rows[i]["obstacles_percent"], 100.) << resolutions[i];
    EXPECT_LE (rows[i]["false_obstacle_points_percent"], max_false_percent[i]);
    EXPECT_GT (rows[i]["rate_hz"], 0.);
  }
}

// The warp of depth raises far floor.
TEST_F (EvaluateDetection, CorrectedDepth)
{
  const std::string frames = "sim:room:1:1 sim:room:2:1 sim:room:3:1 sim:room:4:1 "
                             "--resolution qvga --json table.json ";
  ASSERT_EQ (run (frames).code, 0);
  const json measured = results().at (0);
  for (const std::string source : {"frame", "camera"}) {
    const Outcome outcome = run (frames + "--corrected " + source);
    ASSERT_EQ (outcome.code, 0) << outcome.err;
    const json corrected = results().at (0);
    EXPECT_EQ (corrected["obstacles_percent"], 100.) << source;
    EXPECT_LT (corrected["false_obstacle_points_percent"].get<double>(),
               0.5 * measured["false_obstacle_points_percent"].get<double>())
        << source;
  }
}

TEST_F (EvaluateDetection, ObjectsOnASimulatedTable)
{
  const Outcome outcome = run ("sim:table_single:1 --resolution qvga --object-methods "
                               "--json table.json");
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  const json rows = results();
  ASSERT_EQ (rows.size(), 1u);
  EXPECT_EQ (rows[0]["objects_percent"], 100.);
  EXPECT_EQ (rows[0]["apart_50_percent"], 100.);
  EXPECT_EQ (rows[0]["false_objects"], 0);
  EXPECT_EQ (rows[0]["false_object_points_percent"], 0.);
  EXPECT_EQ (rows[0]["sized"], 1);
  EXPECT_EQ (rows[0]["boxes"], 1);
  EXPECT_GT (rows[0]["obstacles"], 0);
  EXPECT_GT (rows[0]["floor_points"], 0);
  const json methods =
      json::parse (readFile (folder_ / "table.json"))["object_methods"];
  ASSERT_EQ (methods.size(), 3u);
  EXPECT_EQ (methods[1]["method"], "supported_split");
  EXPECT_EQ (methods[1]["objects_percent"], rows[0]["objects_percent"]);
  EXPECT_EQ (methods[2]["method"], "pcl_lccp");
}

// Tops of a few rows, and strips of walls a few columns wide.
TEST_F (EvaluateDetection, ObjectsInSmallImagesOfRooms)
{
  std::string frames;
  for (int seed = 1; seed <= 10; ++seed)
    frames += "sim:room:" + std::to_string (seed) + " ";
  const Outcome outcome = run (frames + "--resolution qqvga --json table.json");
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  const json row = results().at (0);
  EXPECT_GE (row["apart_50_percent"], 90.);
  EXPECT_EQ (row["false_objects"], 0);
  EXPECT_GE (row["graspable_right_percent"], 95.);
}

TEST_F (EvaluateDetection, WithoutTruthWhatNeedsItIsNull)
{
  const auto scene = synthetic::render ({synthetic::tiltedPlane (1.f, 10.f, 5.f)});
  pcl::io::savePCDFileBinary (folder_ / "wall.pcd", *scene.cloud);
  const Outcome outcome = run ("wall.pcd --resolution qvga --json table.json");
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  EXPECT_EQ (outcome.err.rfind ("pcl_evaluate_detection: no truth in this input", 0),
             0u)
      << outcome.err;
  const json rows = results();
  ASSERT_EQ (rows.size(), 1u);
  EXPECT_TRUE (rows[0].at ("obstacles_percent").is_null());
  EXPECT_TRUE (rows[0].at ("false_obstacle_points_percent").is_null());
  EXPECT_TRUE (rows[0].at ("objects_percent").is_null());
  EXPECT_TRUE (rows[0].at ("false_objects").is_null());
  EXPECT_TRUE (rows[0].at ("false_object_points_percent").is_null());
  EXPECT_GT (rows[0]["rate_hz"], 0.);
}

TEST_F (EvaluateDetection, SaysOfHowManyFramesThereIsNoTruth)
{
  const auto scene = synthetic::render ({synthetic::tiltedPlane (1.f, 10.f, 5.f)});
  pcl::io::savePCDFileBinary (folder_ / "wall.pcd", *scene.cloud);
  const Outcome outcome = run ("sim:room:1 wall.pcd --resolution qqvga");
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  EXPECT_EQ (
      outcome.err.rfind ("pcl_evaluate_detection: 1 of 2 frames have no truth", 0), 0u)
      << outcome.err;
}

// With too much noise, low things are floor.
TEST_F (EvaluateDetection, DepthNoiseHidesWhatIsLow)
{
  std::vector<double> found;
  std::vector<std::size_t> obstacles;
  for (const std::string noise : {"kinect_v1", "0.03,0.03"}) {
    const Outcome outcome =
        run ("sim:table_cluttered --resolution qvga --json table.json --object-methods "
             "--depth-noise " +
             noise);
    ASSERT_EQ (outcome.code, 0) << outcome.err;
    const json row = results().at (0);
    found.push_back (row["objects_percent"]);
    obstacles.push_back (row["obstacles"]);
    EXPECT_EQ (json::parse (readFile (
                   folder_ / "table.json"))["object_methods"][1]["objects_percent"],
               row["objects_percent"]);
  }
  EXPECT_LT (found[1], 0.5 * found[0]);
  EXPECT_LT (obstacles[1], obstacles[0]) << "low ones are not asked for";
}

TEST_F (EvaluateDetection, BadUsage)
{
  expectRefused ("sim:floor_obstacles --depth-noise sonar", "--depth-noise");
  expectRefused ("", "INPUT");
  writePng (folder_ / "2x2.png", 2, {1000, 1000, 1000, 1000});
  expectRefused ("2x2.png --intrinsics 2,2,0.5,0.5 --depth-scale 1000",
                 "too small as qvga, 2 x 2 pixels are needed");
  expectRefused ("sim:nowhere", "nowhere");
  expectRefused ("sim:floor_obstacles --corrected floor", "floor");
  expectRefused ("sim:floor_obstacles --json no/where.json", "no");
  writeFile (folder_ / "warp.pcd", asciiPcd ("intensity", 2, 2, "0\n0\n0\n0\n"));
  expectRefused ("sim:floor_obstacles --corrected warp.pcd --json warp.pcd",
                 "is an input");
}
