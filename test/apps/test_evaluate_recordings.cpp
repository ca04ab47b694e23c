// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "evaluate_planes_test.h"
#include "synthetic_clouds.h"

#include <pcl/common/io.h>
#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

using nlohmann::json;

namespace {

class EvaluateRecordings : public EvaluatePlanesTest {};

/** A corner of two walls 90.5 degrees apart. */
class EvaluateCorner : public EvaluatePlanesTest {
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

} // namespace

TEST_F (EvaluateRecordings, SaysOfHowManyFramesThereIsNoTruth)
{
  const auto scene = synthetic::render ({synthetic::tiltedPlane (1.f, 10.f, 5.f)});
  pcl::io::savePCDFileBinary (folder_ / "wall.pcd", *scene.cloud);
  const Outcome outcome = run ("sim:room:1 wall.pcd --resolution qqvga");
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  EXPECT_EQ (outcome.err.rfind ("pcl_evaluate_planes: 1 of 2 frames have no truth", 0),
             0u)
      << outcome.err;
}

TEST_F (EvaluateRecordings, WithoutTruthWhatNeedsItIsNull)
{
  const auto scene = synthetic::render ({synthetic::tiltedPlane (1.f, 10.f, 5.f)});
  pcl::io::savePCDFileBinary (folder_ / "wall.pcd", *scene.cloud);
  const Outcome outcome = run ("wall.pcd --resolution qvga --json table.json");
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  EXPECT_EQ (outcome.err.rfind ("pcl_evaluate_planes: no truth in this input", 0), 0u)
      << outcome.err;
  const json rows = results();
  ASSERT_EQ (rows.size(), 3u);
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
TEST_F (EvaluateRecordings, LabelledRecordings)
{
  SKIP_WITHOUT_RECORDINGS();
  const std::string folder = synthetic::dataFolder();
  const Outcome outcome = run (folder + "/synpeb --resolution vga --json table.json");
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  EXPECT_EQ (outcome.err, "");
  const json planes = results().at (0);
  EXPECT_GE (planes["correct_80"].get<double>(),
             0.8 * planes["planes_truth"].get<double>());
}

// The table is found whole in every cloud, and cleanly cut from what stands on it.
TEST_F (EvaluateRecordings, TablesOfRecordings)
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

TEST_F (EvaluateCorner, Pictures)
{
  auto cloud = cornerAs<pcl::PointXYZ>();
  cloud (0, 0).x = cloud (0, 0).y = cloud (0, 0).z = synthetic::nan;
  evaluate (cloud, "--pictures pictures");
  EXPECT_EQ (listFolder (folder_ / "pictures"),
             (std::vector<std::string>{"corner_normal_space_qvga.png",
                                       "corner_pcl_omps_qvga.png",
                                       "corner_pcl_omps_tuned_qvga.png"}));
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
