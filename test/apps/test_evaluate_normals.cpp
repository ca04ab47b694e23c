// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "app_test.h"
#include "synthetic_clouds.h"

#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>

using nlohmann::json;

namespace {

class EvaluateNormals : public AppTest {
protected:
  EvaluateNormals() : AppTest (EVALUATE_NORMALS) {}

  void
  writePlane (const std::string& name, int width) const
  {
    pcl::io::savePCDFileBinary (
        folder_ / name,
        *synthetic::render (
             {synthetic::tiltedPlane (1.f, 10.f, 5.f)}, width, width * 3 / 4)
             .cloud);
  }
};

json
row (const json& results, const std::string& method, const std::string& resolution)
{
  for (const auto& result : results)
    if (result["method"] == method && result["resolution"] == resolution)
      return result;
  ADD_FAILURE() << "no row for " << method << ' ' << resolution;
  return {};
}

} // namespace

TEST_F (EvaluateNormals, PclSaysNothingOfScansThatAreNoImageOfACamera)
{
  pcl::PointCloud<pcl::PointXYZ> scan (160, 120);
  for (std::uint32_t v = 0; v < scan.height; ++v)
    for (std::uint32_t u = 0; u < scan.width; ++u) {
      const float azimuth = (static_cast<float> (u) - 79.5f) / 80.f;
      const float elevation = (static_cast<float> (v) - 59.5f) / 80.f;
      scan (u, v).getVector3fMap() =
          2.f * Eigen::Vector3f (std::cos (elevation) * std::sin (azimuth),
                                 std::sin (elevation),
                                 std::cos (elevation) * std::cos (azimuth));
    }
  pcl::io::savePCDFileBinary (folder_ / "scan.pcd", scan);
  const Outcome outcome = run ("scan.pcd --resolution vga");
  EXPECT_EQ (outcome.code, 0);
  EXPECT_EQ (outcome.err, "");
}

TEST_F (EvaluateNormals, SimulatedFrameAgainstTruth)
{
  const Outcome outcome = run ("sim:table_single --json table.json");
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  EXPECT_EQ (outcome.err, "");
  EXPECT_NE (outcome.out.find ("pcl_average_3d_gradient_10"), std::string::npos);
  const json results = json::parse (readFile (folder_ / "table.json"))["results"];
  for (const std::string resolution : {"vga", "qvga", "qqvga"})
    for (const std::string method : {"tangent",
                                     "pcl_average_3d_gradient_10",
                                     "pcl_average_3d_gradient_20",
                                     "pcl_covariance_matrix_10",
                                     "pcl_covariance_matrix_20",
                                     "pcl_simple_3d_gradient_10",
                                     "pcl_simple_3d_gradient_20",
                                     "pcl_average_depth_change_10",
                                     "pcl_average_depth_change_20",
                                     "pcl_linear_least_squares",
                                     "two_run_pca"}) {
      const json result = row (results, method, resolution);
      EXPECT_EQ (result["reference"], "truth");
      EXPECT_GT (result["ms_median"], 0.);
      for (const json& part : {result,
                               result["interior"],
                               result["edges"],
                               result["tangent_there"],
                               result["tangent_there_edges"]}) {
        EXPECT_GE (part["mean_deg"], 0.);
        EXPECT_LE (part["median_deg"], 180.);
        EXPECT_LE (part["over_25_percent"], 100.);
        EXPECT_LE (part["coverage_percent"], 100.);
      }
    }
}

TEST_F (EvaluateNormals, RecordedFramesAgainstTwoRunPca)
{
  writePlane ("a.pcd", 320);
  writePlane ("b.pcd", 320);
  const Outcome outcome =
      run (". b.pcd --far-reference --resolution qvga --json table.json");
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  const json results = json::parse (readFile (folder_ / "table.json"))["results"];
  for (const auto& result : results) {
    EXPECT_EQ (result["reference"], "two_run_pca");
    EXPECT_EQ (result["resolution"], "qvga");
    EXPECT_NE (result["method"], "two_run_pca");
    EXPECT_TRUE (result["interior"].is_null());
    EXPECT_TRUE (result["edges"].is_null());
    EXPECT_TRUE (result["tangent_there_edges"].is_null());
  }
  EXPECT_LT (row (results, "tangent", "qvga")["mean_deg"], 0.1);
  EXPECT_EQ (row (results, "tangent", "qvga")["coverage_percent"], 100.);
}

TEST_F (EvaluateNormals, Help)
{
  const Outcome outcome = run ("--help");
  EXPECT_EQ (outcome.code, 0);
  EXPECT_NE (outcome.out.find ("--far-reference"), std::string::npos);
}

TEST_F (EvaluateNormals, BadUsage)
{
  writePlane ("small.pcd", 80);
  expectRefused ("", "INPUT");
  expectRefused ("missing.pcd", "missing.pcd");
  expectRefused ("small.pcd missing.pcd", "missing.pcd");
  expectRefused ("sim:nowhere", "nowhere");
  expectRefused ("small.pcd --resolution tiny", "tiny");
  expectRefused ("small.pcd --resolution qvga", "; use --resolution vga or larger");
  writePlane ("smaller.pcd", 32);
  expectRefused ("smaller.pcd --resolution vga",
                 "40 x 40 pixels are needed; use larger");
  for (const std::string radius : {"1", "1,2,3", "a,b", "0,0", "-1,2", "inf,1"})
    expectRefused ("small.pcd --radius=" + radius, "--radius");
  expectRefused ("small.pcd --radius 1,0 --far-reference", "--far-reference");
  expectRefused ("small.pcd --wrong", "--help");
  expectRefused ("small.pcd --resolution vga --json no/where.json", "no");
  expectRefused ("small.pcd --resolution vga --json small.pcd", "is an input");
}
