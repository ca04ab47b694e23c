// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "app_test.h"
#include "synthetic_clouds.h"

#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <set>
#include <sstream>

using nlohmann::json;

namespace {

class Benchmark : public AppTest {
protected:
  Benchmark() : AppTest (BENCHMARK) {}

  std::set<std::string>
  names (const std::string& arguments) const
  {
    std::istringstream lines (run (arguments + " --benchmark_list_tests").out);
    std::set<std::string> result;
    for (std::string line; std::getline (lines, line);)
      result.insert (line);
    return result;
  }

  void
  saveWall (const std::string& name, int width, int height) const
  {
    const auto scene =
        synthetic::render ({synthetic::tiltedPlane (1.f, 10.f, 5.f)}, width, height);
    pcl::io::savePCDFileBinary (folder_ / name, *scene.cloud);
  }
};

} // namespace

TEST_F (Benchmark, HasTheNamesThatOthersRelyOn)
{
  const auto all = names ("");
  for (const std::string method : {"normals/copy_floor",
                                   "normals/tangent",
                                   "normals/tangent_plain",
                                   "normals/pcl_average_3d_gradient",
                                   "planes/normal_space",
                                   "planes/pcl_omps",
                                   "objects/supported",
                                   "objects/supported_split",
                                   "objects/pcl_lccp",
                                   "obstacles/detection",
                                   "pipeline/all"})
    for (const std::string resolution : {"/vga", "/qvga", "/qqvga"})
      EXPECT_EQ (all.count (method + resolution), 1u) << method << resolution;
  for (const std::string method :
       {"normals/tangent_window", "normals/tangent_plain_window"})
    for (const std::string window : {"/8", "/16", "/32", "/64"})
      EXPECT_EQ (all.count (method + window), 1u) << method << window;
  for (const std::string size : {"/0.3mp", "/1mp", "/2mp", "/4mp"})
    EXPECT_EQ (all.count ("normals/tangent_points" + size), 1u) << size;
  for (const std::string threads : {"/1", "/2"})
    EXPECT_EQ (all.count ("normals/tangent_threads" + threads), 1u) << threads;
}

TEST_F (Benchmark, AllButTheLargestCloudsRunWithoutError)
{
  saveWall ("wall.pcd", 320, 240);
  saveWall ("other_wall.pcd", 320, 240);
  const std::string arguments =
      "wall.pcd other_wall.pcd '--benchmark_filter=-/[124](mp|$)'";
  const Outcome outcome =
      run (arguments + " --benchmark_min_time=0.001 --benchmark_format=json");
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  const json report = json::parse (outcome.out);
  std::set<std::string> measured;
  for (const json& row : report["benchmarks"]) {
    const std::string name = row["name"];
    EXPECT_FALSE (row.contains ("error_occurred")) << name;
    EXPECT_GT (row["items_per_second"], 0.) << name;
    if (name.find ("_points/") == std::string::npos) {
      EXPECT_EQ (row["iterations"].get<int>() % 2, 0) << name << ": frames count alike";
      const int side = name.find ("/qqvga") != std::string::npos  ? 4
                       : name.find ("/qvga") != std::string::npos ? 2
                                                                  : 1;
      EXPECT_EQ (row["points"], 320 * 240 / (side * side)) << name;
    }
    measured.insert (name);
  }
  EXPECT_EQ (measured, names (arguments));
}

TEST_F (Benchmark, BadUsage)
{
  saveWall ("wall.pcd", 320, 240);
  saveWall ("small.pcd", 159, 240);
  saveWall ("large.pcd", 640, 480);
  expectRefused ("nowhere.pcd", "nowhere.pcd");
  expectRefused ("small.pcd", "160");
  expectRefused ("wall.pcd large.pcd", "large.pcd");
  expectRefused ("--no-such-option", "no-such-option");
  expectRefused ("wall.pcd --resolution qvga", "--benchmark_filter");
  expectRefused ("wall.pcd --benchmark_out=wall.pcd", "wall.pcd: is an input");
}
