// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "evaluate_planes_test.h"
#include "synthetic_clouds.h"

#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <vector>

using nlohmann::json;

namespace {

class EvaluatePlanes : public EvaluatePlanesTest {};

} // namespace

TEST_F (EvaluatePlanes, SimulatedFramesAgainstTruth)
{
  const Outcome outcome = run ("sim:table_single sim:corridor:2 --json table.json");
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  EXPECT_EQ (outcome.err, "");
  EXPECT_NE (outcome.out.find ("pcl_omps"), std::string::npos);
  const json rows = results();
  ASSERT_EQ (rows.size(), 9u);
  std::size_t i = 0;
  for (const std::string resolution : {"vga", "qvga", "qqvga"})
    for (const std::string method : {"normal_space", "pcl_omps", "pcl_omps_tuned"}) {
      const json& row = rows[i++];
      EXPECT_EQ (row["method"], method);
      EXPECT_EQ (row["resolution"], resolution);
      EXPECT_GT (row["ms_median"], 0.);
      EXPECT_GE (row["ms_worst"], row["ms_median"]);
      EXPECT_GE (row["planes_truth"], 6);
      const int truth = row["planes_truth"], found = row["planes_found"];
      EXPECT_LE (row["correct_80"].get<int>() + row["missed"].get<int>(), truth);
      EXPECT_LE (row["correct_80"].get<int>() + row["noise"].get<int>(), found);
      if (method == "normal_space") {
        EXPECT_GT (row["f1_50"], 0.95);
        EXPECT_GT (row["mean_iou"], 0.9);
        EXPECT_GT (row["coverage_percent"], 98.);
        EXPECT_LT (row["median_angle_error_deg"], 1.);
      }
      EXPECT_TRUE (row["curved_labelled_percent"].is_null()) << "nothing is curved";
      EXPECT_GT (row["far_points"], 1000);
      for (const char* key : {"far_rms_along_ray_mm", "far_rms_along_normal_mm"})
        EXPECT_LT (row[key], row["far_rms_before_mm"]) << key;
      EXPECT_LT (row["far_rms_fit_mm"], row["far_rms_before_mm"]);
      EXPECT_GT (row["wall_pairs"], 0);
      EXPECT_GT (row["wall_angle_fit_percent"], 0.);
    }
}

TEST_F (EvaluatePlanes, CurvedSurfacesOfSimulatedFrames)
{
  for (const std::string scene : {"table_cluttered", "crockery"}) {
    ASSERT_EQ (run ("sim:" + scene + " --resolution qqvga --json table.json").code, 0);
    for (const json& row : results()) {
      ASSERT_TRUE (row["curved_labelled_percent"].is_number()) << scene;
      const double labelled = row["curved_labelled_percent"].get<double>();
      const double shattered = row["curved_shattered_percent"].get<double>();
      EXPECT_LE (shattered, labelled);
      EXPECT_LT (labelled, 20.) << row["method"];
    }
  }
}

TEST_F (EvaluatePlanes, RoundThingsOnAFloorAreNoPlanes)
{
  ASSERT_EQ (run ("sim:floor_obstacles:1 sim:floor_obstacles:4 --json table.json").code,
             0);
  for (const json& row : results())
    if (row["method"] == "normal_space") {
      EXPECT_EQ (row["curved_shattered_percent"], 0.) << row["resolution"];
    }
}

// The planes of the frame itself tell the warp of its camera, those of several frames of
// the camera tell it better.
TEST_F (EvaluatePlanes, CorrectedDepth)
{
  for (const std::string source : {"frame", "camera"}) {
    const Outcome outcome = run ("sim:corridor:1:2 sim:corridor:2:2 sim:corridor:3:2 "
                                 "--resolution qvga --json table.json --corrected " +
                                 source);
    ASSERT_EQ (outcome.code, 0) << outcome.err;
    const json rows = results();
    ASSERT_EQ (rows.size(), 4u);
    const json &measured = rows[0], &corrected = rows[3];
    EXPECT_EQ (corrected["method"], "corrected");
    const auto ratio = [&] (const char* key) {
      return corrected[key].get<double>() / measured[key].get<double>();
    };
    EXPECT_EQ (corrected["far_rms_before_mm"], measured["far_rms_before_mm"]);
    EXPECT_LT (ratio ("far_rms_along_ray_mm"), source == "frame" ? 0.5 : 0.3);
    EXPECT_LT (ratio ("median_angle_error_deg"), source == "frame" ? 0.8 : 0.6);
    EXPECT_LT (corrected["off_percent"], 0.1);
    EXPECT_GE (corrected["f1_50"], 0.9);
  }
}

TEST_F (EvaluatePlanes, PlanesFallToPiecesWhereLessNoiseIsExpected)
{
  std::vector<double> f1;
  for (const std::string noise : {"kinect_v1",
                                  "0.001,0.002",
                                  "0.0001,0.0002",
                                  "0.001,0.002,1",
                                  "0.001,0.002,2.5"}) {
    ASSERT_EQ (
        run ("sim:room:1 --resolution qvga --json table.json --depth-noise " + noise)
            .code,
        0);
    f1.push_back (results()[0]["f1_50"]);
  }
  EXPECT_EQ (f1[0], f1[1]);
  EXPECT_EQ (f1[0], f1[3]);
  EXPECT_NE (f1[0], f1[4]);
  EXPECT_LT (f1[2], f1[0] - 0.2);
  expectRefused ("sim:room --depth-noise kinect_v1 --corrected frame",
                 "leave out --depth-noise or --corrected");
}

TEST_F (EvaluatePlanes, WithoutAdditions)
{
  // A wall behind a column: joining makes its two parts one plane.
  auto wall = synthetic::tiltedPlane (2.f, 0.f, 0.f);
  wall.covers = [] (int u, int) { return u < 250 || u >= 350; };
  pcl::io::savePCDFileBinary (folder_ / "wall.pcd", *synthetic::render ({wall}).cloud);
  ASSERT_EQ (run ("wall.pcd --resolution vga --json table.json --without joining "
                  "--without curved,repeat --without all")
                 .code,
             0);
  const json rows = results();
  ASSERT_EQ (rows.size(), 6u);
  EXPECT_EQ (rows[0]["planes_found"], 1);
  EXPECT_EQ (rows[3]["method"], "no_joining");
  EXPECT_EQ (rows[3]["planes_found"], 2);
  EXPECT_EQ (rows[4]["method"], "no_curved,repeat");
  EXPECT_EQ (rows[4]["planes_found"], 1);
  EXPECT_EQ (rows[5]["method"], "no_all");
  EXPECT_EQ (rows[5]["planes_found"], 1) << "a cluster, however many its parts";
}

/** Section 4.1 of the paper: they differ by no more than noise. */
TEST_F (EvaluatePlanes, BothGridsFindTheSame)
{
  ASSERT_EQ (
      run ("sim:room sim:table_cluttered --spherical-grid --resolution vga --json "
           "table.json")
          .code,
      0);
  const json rows = results();
  ASSERT_EQ (rows.size(), 4u);
  const json &voxels = rows[0], &spherical = rows[3];
  EXPECT_EQ (spherical["method"], "spherical_grid");
  const auto differ = [&] (const char* key) {
    return std::abs (voxels[key].get<double>() - spherical[key].get<double>());
  };
  EXPECT_LE (differ ("planes_found"), 2.);
  EXPECT_LE (differ ("f1_50"), 0.05);
  EXPECT_LE (differ ("coverage_percent"), 1.);
}

/** A program in which nothing but the names of classes changed gains from that. */
TEST_F (EvaluatePlanes, MoreThanPclWithTheSettingsOfPcl)
{
  ASSERT_EQ (
      run ("sim:room sim:table_cluttered --kept-settings --json table.json").code, 0);
  const json rows = results();
  ASSERT_EQ (rows.size(), 12u);
  for (std::size_t i = 0; i < rows.size(); i += 4) {
    const json &ours = rows[i], &theirs = rows[i + 1], &kept = rows[i + 3];
    EXPECT_EQ (theirs["method"], "pcl_omps");
    EXPECT_EQ (kept["method"], "kept_settings");
    EXPECT_GT (kept["correct_80"], theirs["correct_80"]);
    EXPECT_LE (kept["noise"], theirs["noise"]);
    EXPECT_GT (kept["f1_50"], theirs["f1_50"]);
    EXPECT_LT (kept["f1_50"], ours["f1_50"]) << "the settings count";
  }
}

TEST_F (EvaluatePlanes, FramesOfACameraHaveOneSize)
{
  const auto scene = synthetic::render ({synthetic::tiltedPlane (1.f, 10.f, 5.f)});
  pcl::io::savePCDFileBinary (folder_ / "wide.pcd", *scene.cloud);
  auto narrow = *scene.cloud;
  narrow.resize (640, 400);
  pcl::io::savePCDFileBinary (folder_ / "narrow.pcd", narrow);
  EXPECT_EQ (run ("wide.pcd narrow.pcd --resolution qvga --corrected frame").code, 0);
  expectRefused ("wide.pcd narrow.pcd --resolution qvga --corrected camera", "sizes");
}

// While it works, a folder appears where one of the pictures goes.
TEST_F (EvaluatePlanes, NoTableWherePicturesCannotBeWritten)
{
  std::filesystem::create_directory (folder_ / "in");
  writePng (folder_ / "frame.png", 160, std::vector<std::uint16_t> (160 * 120, 1000));
  const Outcome outcome =
      shell ("cp frame.png in/1.png; mkfifo in/2.png; " + application_ +
             " in --intrinsics 131,131,79.5,59.5 --depth-scale 1000 --resolution vga "
             "--json table.json --pictures pictures & pid=$!; exec 3>in/2.png; "
             "mkdir pictures/1_normal_space_vga.png; cat frame.png >&3; exec 3>&-; "
             "wait $pid");
  EXPECT_EQ (outcome.code, 1);
  EXPECT_NE (outcome.err.find ("1_normal_space_vga.png: cannot write this file"),
             std::string::npos)
      << outcome.err;
  EXPECT_FALSE (std::filesystem::exists (folder_ / "table.json"));
}

TEST_F (EvaluatePlanes, BadUsage)
{
  expectRefused ("", "INPUT");
  expectRefused ("sim:nowhere", "nowhere");
  expectRefused ("sim:table_single --resolution tiny", "tiny");
  expectRefused ("sim:table_single --right-angles most", "most");
  expectRefused ("sim:table_single --corrected room", "room");
  expectRefused ("sim:table_single --corrected no.pcd", "no.pcd");
  expectRefused ("sim:table_single --json no/where.json", "no");
  expectRefused ("sim:table_single --json ''", "no name of a file");
  expectRefused ("sim:table_single --without growth,roots", "roots");
  expectRefused ("sim:table_single --without ''", "''");
  expectRefused ("sim:table_single --without edges --without edges",
                 "'edges' is given twice");
  expectRefused ("sim:table_single --without edges,peaks --without peaks,edges",
                 "'peaks,edges' is the same as 'edges,peaks'");
  std::filesystem::create_directory (folder_ / "in");
  writeFile (folder_ / "in/frame.pcd",
             asciiPcd ("x y z", 2, 2, "0 0 1\n0 0 1\n0 0 1\n0 0 1\n"));
  expectRefused ("in --resolution vga", "40 x 40 pixels are needed; use larger");
  writeFile (folder_ / "in/frame.pcd", "");
  expectRefused ("in --pictures in", "is a folder of INPUT");
  expectRefused ("in/frame.pcd --pictures in", "is a folder of INPUT");
  expectRefused ("sim:table_single in --json in/frame.pcd", "is an input");
  std::filesystem::create_directory (folder_ / "other");
  writeFile (folder_ / "other/frame.pcd", "");
  expectRefused ("in other --pictures pictures",
                 "frames of two inputs are named 'frame'");
}
