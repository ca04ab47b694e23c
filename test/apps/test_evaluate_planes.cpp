// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "app_test.h"
#include "synthetic_clouds.h"

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
      EXPECT_GE (row["planes_truth"], 6);
      const int truth = row["planes_truth"], found = row["planes_found"];
      EXPECT_LE (row["correct_80"].get<int>() + row["missed"].get<int>(), truth);
      EXPECT_LE (row["correct_80"].get<int>() + row["noise"].get<int>(), found);
      EXPECT_LE (row["f1_50"], 1.);
      EXPECT_LE (row["mean_iou"], 1.);
      EXPECT_LE (row["coverage_percent"], 100.);
      EXPECT_GE (row["median_angle_error_deg"], 0.);
    }
}

TEST_F (EvaluatePlanes, WithoutTruthWhatNeedsItIsNull)
{
  const auto scene = synthetic::render ({synthetic::tiltedPlane (1.f, 10.f, 5.f)});
  pcl::io::savePCDFileBinary (folder_ / "wall.pcd", *scene.cloud);
  ASSERT_EQ (run ("wall.pcd --resolution qvga --json table.json").code, 0);
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
                          "median_distance_error_mm"})
    EXPECT_TRUE (rows[0].at (key).is_null()) << key;
  EXPECT_EQ (rows[0]["method"], "normal_space");
  EXPECT_EQ (rows[0]["planes_found"], 1);
  EXPECT_EQ (rows[0]["coverage_percent"], 100.);
  EXPECT_EQ (rows[0]["off_percent"], 0.);
}

TEST_F (EvaluatePlanes, BadUsage)
{
  expectRefused ("", "INPUT");
  expectRefused ("sim:nowhere", "nowhere");
  expectRefused ("sim:table_single --resolution tiny", "tiny");
  expectRefused ("sim:table_single --json no/where.json", "no");
}
