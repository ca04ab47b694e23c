// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "app_test.h"
#include "synthetic_clouds.h"

#include <pcl/common/io.h>
#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

using nlohmann::json;

namespace {

class EvaluatePlanes : public AppTest {
protected:
  EvaluatePlanes() : AppTest (EVALUATE_PLANES) {}

  json
  results () const
  {
    return json::parse (readFile (folder_ / "table.json"))["results"];
  }
};

} // namespace

TEST_F (EvaluatePlanes, SimulatedFramesAgainstTruth)
{
  const Outcome outcome = run ("sim:table_single sim:corridor:2 --json table.json");
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  EXPECT_EQ (outcome.err, "");
  EXPECT_NE (outcome.out.find ("pcl_omps"), std::string::npos);
  const json rows = results();
  ASSERT_EQ (rows.size(), 6u);
  std::size_t i = 0;
  for (const std::string resolution : {"vga", "qvga", "qqvga"})
    for (const std::string method : {"normal_space", "pcl_omps"}) {
      const json& row = rows[i++];
      EXPECT_EQ (row["method"], method);
      EXPECT_EQ (row["resolution"], resolution);
      EXPECT_GT (row["ms_median"], 0.);
      EXPECT_GE (row["ms_worst"], row["ms_median"]);
      EXPECT_GE (row["planes_truth"], 6);
      const int truth = row["planes_truth"], found = row["planes_found"];
      EXPECT_LE (row["correct_80"].get<int>() + row["missed"].get<int>(), truth);
      EXPECT_LE (row["correct_80"].get<int>() + row["noise"].get<int>(), found);
      EXPECT_LE (row["f1_50"], 1.);
      EXPECT_LE (row["mean_iou"], 1.);
      EXPECT_LE (row["coverage_percent"], 100.);
      EXPECT_GE (row["median_angle_error_deg"], 0.);
      EXPECT_TRUE (row["curved_labelled_percent"].is_null()) << "nothing is curved";
      EXPECT_GT (row["far_points"], 1000);
      for (const char* key : {"far_rms_along_ray_mm", "far_rms_along_normal_mm"})
        EXPECT_LT (row[key], row["far_rms_before_mm"]) << key;
      EXPECT_LT (row["far_rms_fit_mm"], row["far_rms_before_mm"]);
      EXPECT_GT (row["wall_pairs"], 0);
      EXPECT_GE (row["wall_angle_percent"], 0.);
      EXPECT_GT (row["wall_angle_fit_percent"], 0.);
    }
}

TEST_F (EvaluatePlanes, CurvedSurfacesOfSimulatedFrames)
{
  ASSERT_EQ (run ("sim:table_cluttered --resolution qqvga --json table.json").code, 0);
  for (const json& row : results()) {
    const double labelled = row["curved_labelled_percent"].get<double>();
    const double shattered = row["curved_shattered_percent"].get<double>();
    EXPECT_GE (shattered, 0.);
    EXPECT_LE (shattered, labelled);
    EXPECT_LE (labelled, 100.);
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
    ASSERT_EQ (rows.size(), 3u);
    const json &measured = rows[0], &corrected = rows[2];
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

TEST_F (EvaluatePlanes, WithoutTruthWhatNeedsItIsNull)
{
  const auto scene = synthetic::render ({synthetic::tiltedPlane (1.f, 10.f, 5.f)});
  pcl::io::savePCDFileBinary (folder_ / "wall.pcd", *scene.cloud);
  const Outcome outcome = run ("wall.pcd --resolution qvga --json table.json");
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  EXPECT_EQ (outcome.err.rfind ("pcl_evaluate_planes: no truth in this input", 0), 0u)
      << outcome.err;
  const json rows = results();
  ASSERT_EQ (rows.size(), 2u);
  for (const char* key : {"planes_truth",
                          "correct_80",
                          "over",
                          "under",
                          "missed",
                          "noise",
                          "f1_50",
                          "mean_iou",
                          "median_angle_error_deg",
                          "median_distance_error_mm",
                          "table_iou",
                          "table_iou_worst",
                          "purity_percent",
                          "curved_labelled_percent",
                          "curved_shattered_percent",
                          "right_angle_median_deg",
                          "right_angle_pairs_percent",
                          "right_angle_frames_percent",
                          "far_rms_before_mm",
                          "far_rms_along_ray_mm",
                          "far_rms_along_normal_mm",
                          "far_rms_fit_mm",
                          "wall_angle_median_deg",
                          "wall_angle_percent",
                          "wall_angle_fit_median_deg",
                          "wall_angle_fit_percent"})
    EXPECT_TRUE (rows[0].at (key).is_null()) << key;
  EXPECT_EQ (rows[0]["method"], "normal_space");
  EXPECT_EQ (rows[0]["planes_found"], 1);
  EXPECT_EQ (rows[0]["coverage_percent"], 100.);
  EXPECT_EQ (rows[0]["off_percent"], 0.);
}

/** A corner of two walls 90.5 degrees apart. */
class EvaluateCorner : public EvaluatePlanes {
protected:
  EvaluateCorner()
  : corner_ (synthetic::render ({synthetic::tiltedPlane (2.f, 0.f, 50.f),
                                 synthetic::tiltedPlane (2.f, 0.f, -40.5f)}))
  {}

  /** Runs the comparison on \a cloud at QVGA and returns the figures of our method. */
  template <typename PointT>
  json
  evaluate (const pcl::PointCloud<PointT>& cloud, const std::string& options = "")
  {
    pcl::io::savePCDFileBinaryCompressed (folder_ / "corner.pcd", cloud);
    const Outcome outcome =
        run ("corner.pcd --resolution qvga --json table.json " + options);
    EXPECT_EQ (outcome.code, 0) << outcome.err;
    table_ = outcome.out;
    return results()[0];
  }

  template <typename PointT>
  pcl::PointCloud<PointT>
  cornerAs () const
  {
    pcl::PointCloud<PointT> cloud;
    pcl::copyPointCloud (*corner_.cloud, cloud);
    return cloud;
  }

  const synthetic::Scene corner_;
  std::string table_;
};

TEST_F (EvaluateCorner, RightAngles)
{
  const auto cloud = cornerAs<pcl::PointXYZ>();
  json row = evaluate (cloud, "--right-angles all");
  EXPECT_EQ (row["right_angle_frames"], 1);
  EXPECT_NEAR (row["right_angle_median_deg"], 0.5, 0.1);
  EXPECT_EQ (row["right_angle_pairs_percent"], 100.);
  EXPECT_EQ (row["right_angle_frames_percent"], 100.);
  EXPECT_NE (table_.find ("right angles"), std::string::npos);
  row = evaluate (cloud);
  EXPECT_EQ (row["right_angle_frames"], 0);
  EXPECT_EQ (table_.find ("right angles"), std::string::npos);
}

TEST_F (EvaluateCorner, LabelledPlanesAreTheTruth)
{
  auto cloud = cornerAs<pcl::PointXYZI>();
  for (std::size_t i = 0; i < cloud.size(); ++i)
    cloud[i].intensity = static_cast<float> (corner_.surface[i] + 1);
  const json row = evaluate (cloud);
  EXPECT_EQ (row["planes_truth"], 2);
  EXPECT_EQ (row["correct_80"], 2);
  EXPECT_EQ (row["noise"], 0);
  EXPECT_LE (row["median_angle_error_deg"], 0.1);
  EXPECT_TRUE (row["table_iou"].is_null());
}

TEST_F (EvaluateCorner, LabelledObjects)
{
  auto cloud = cornerAs<pcl::PointXYZL>();
  for (std::size_t i = 0; i < cloud.size(); ++i)
    cloud[i].label = corner_.surface[i] == 0 ? 1 : 20;
  const json row = evaluate (cloud);
  EXPECT_TRUE (row["planes_truth"].is_null());
  EXPECT_GE (row["table_iou"], 0.98);
  EXPECT_EQ (row["table_iou"], row["table_iou_worst"]);
  EXPECT_GE (row["purity_percent"], 98.);
  EXPECT_NE (table_.find ("table IoU"), std::string::npos);
}

// Planes of a scan whose rows and columns are no image of a pinhole camera.
TEST_F (EvaluatePlanes, LabelledRecordings)
{
  SKIP_WITHOUT_RECORDINGS();
  const std::string folder = synthetic::dataFolder();
  ASSERT_EQ (run (folder + "/synpeb --resolution vga --json table.json").code, 0);
  const json planes = results().at (0);
  EXPECT_GE (planes["correct_80"].get<double>(),
             0.8 * planes["planes_truth"].get<double>());
}

// The table is found whole in every cloud, and cleanly cut from what stands on it.
TEST_F (EvaluatePlanes, TablesOfRecordings)
{
  SKIP_WITHOUT_RECORDINGS();
  const std::string folder = synthetic::dataFolder();
  ASSERT_EQ (run (folder + "/mosd_learn --json table.json").code, 0);
  for (const json& row : results())
    if (row["method"] == "normal_space") {
      EXPECT_GE (row["table_iou"], 0.98) << row["resolution"];
      EXPECT_GE (row["table_iou_worst"], 0.95) << row["resolution"];
      EXPECT_GE (row["purity_percent"], 99.7) << row["resolution"];
    }
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
  ASSERT_EQ (rows.size(), 5u);
  EXPECT_EQ (rows[0]["planes_found"], 1);
  EXPECT_EQ (rows[2]["method"], "no_joining");
  EXPECT_EQ (rows[2]["planes_found"], 2);
  EXPECT_EQ (rows[3]["method"], "no_curved,repeat");
  EXPECT_EQ (rows[3]["planes_found"], 1);
  EXPECT_EQ (rows[4]["method"], "no_all");
  EXPECT_EQ (rows[4]["planes_found"], 1) << "a cluster, however many its parts";
}

TEST_F (EvaluateCorner, Pictures)
{
  auto cloud = cornerAs<pcl::PointXYZ>();
  cloud (0, 0).x = cloud (0, 0).y = cloud (0, 0).z = synthetic::nan;
  evaluate (cloud, "--pictures pictures");
  EXPECT_EQ (listFolder (folder_ / "pictures"),
             (std::vector<std::string>{"corner_normal_space_qvga.png",
                                       "corner_pcl_omps_qvga.png"}));
  const RgbImage picture =
      readRgbPng (folder_ / "pictures" / "corner_normal_space_qvga.png");
  ASSERT_EQ (picture.width, 320u);
  ASSERT_EQ (picture.height, 240u);
  const auto colour = [&] (std::size_t u, std::size_t v) {
    const std::uint8_t* rgb = &picture.samples[3 * (v * 320 + u)];
    return std::vector<std::uint8_t> (rgb, rgb + 3);
  };
  EXPECT_EQ (colour (0, 0), (std::vector<std::uint8_t>{0, 0, 0}));
  EXPECT_EQ (colour (50, 50), colour (50, 200));
  EXPECT_EQ (colour (270, 50), colour (270, 200));
  EXPECT_NE (colour (50, 50), colour (270, 50));
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
  std::filesystem::create_directory (folder_ / "in");
  writeFile (folder_ / "in/frame.pcd", "");
  expectRefused ("in --pictures in", "is the INPUT folder");
  expectRefused ("in/frame.pcd --pictures in", "is the folder of INPUT");
  expectRefused ("sim:table_single in --json in/frame.pcd", "is an input");
  std::filesystem::create_directory (folder_ / "other");
  writeFile (folder_ / "other/frame.pcd", "");
  expectRefused ("in other --pictures pictures",
                 "frames of two inputs are named 'frame'");
}
