// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "app_test.h"

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

using nlohmann::json;

namespace {

class MeasureDepthNoise : public AppTest {
protected:
  MeasureDepthNoise() : AppTest (MEASURE_DEPTH_NOISE) {}
};

} // namespace

TEST_F (MeasureDepthNoise, OfASimulatedKinect)
{
  for (const std::string resolution : {"", " --resolution qvga"}) {
    const Outcome outcome = run ("sim:room:1 sim:room:2 sim:table_cluttered:1 "
                                 "sim:table_cluttered:2 --json noise.json" +
                                 resolution);
    ASSERT_EQ (outcome.code, 0) << outcome.err;
    EXPECT_EQ (outcome.err, "");
    const json noise = json::parse (readFile (folder_ / "noise.json"));
    EXPECT_NEAR (noise["constant"], 0.001, 0.001);
    EXPECT_NEAR (noise["quadratic"], 0.002, 0.0004);
    EXPECT_GE (noise["levels"].size(), 5u);
    EXPECT_NEAR (noise["normal_scatter"], 1., 0.3);
    char option[50];
    std::snprintf (option,
                   sizeof (option),
                   "\n--depth-noise %.5f,%.5f,%.1f\n",
                   noise["constant"].get<double>(),
                   noise["quadratic"].get<double>(),
                   noise["normal_scatter"].get<double>());
    EXPECT_NE (outcome.out.find (option), std::string::npos) << outcome.out;
    EXPECT_EQ (outcome.out.find ("at these ranges only"), std::string::npos);
  }
}

TEST_F (MeasureDepthNoise, OneWallTellsTheNoiseThereOnly)
{
  pcl::PointCloud<pcl::PointXYZ> wall (640, 480);
  for (unsigned i = 0; i < wall.size(); ++i)
    wall[i].getVector3fMap() =
        Eigen::Vector3f ((i % 640) / 525.f - 0.3f, (i / 640) / 525.f - 0.2f, 1.f) *
        (i % 3 == 0 ? 4.f : 4.01f);
  pcl::io::savePCDFileBinary (folder_ / "wall.pcd", wall);
  const Outcome outcome = run ("wall.pcd");
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  EXPECT_NE (outcome.out.find ("at these ranges only"), std::string::npos);
}

TEST_F (MeasureDepthNoise, WhereNothingIsSeenItSaysSo)
{
  pcl::io::savePCDFileBinary (folder_ / "dark.pcd",
                              pcl::PointCloud<pcl::PointXYZ> (640, 480));
  expectRefused ("dark.pcd --json noise.json", "no smooth surfaces in any frame");
  expectRefused ("", "no INPUT given");
}

TEST_F (MeasureDepthNoise, FramesThatAreTooSmallAreRefused)
{
  writePng (folder_ / "2x2.png", 2, {1000, 1000, 1000, 1000});
  expectRefused (
      "2x2.png --intrinsics 2,2,0.5,0.5 --depth-scale 1000 --resolution qvga",
      "too small as qvga, 2 x 2 pixels are needed");
}

TEST_F (MeasureDepthNoise, HelpHasNoEmptySection)
{
  EXPECT_EQ (run ("-h").out.find ("\n\n\n"), std::string::npos);
}
