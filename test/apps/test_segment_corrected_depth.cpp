// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "segment_planes_test.h"

#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

using nlohmann::json;

namespace {

class SegmentCorrectedDepth : public SegmentPlanesTest {};

} // namespace

TEST_F (SegmentCorrectedDepth, CorrectsWithTheWarpOfAnEarlierRun)
{
  const auto planes = [&] (const std::string& file) {
    return json::parse (readFile (folder_ / file))["frames"][0]["planes"];
  };
  const Outcome learned =
      run ("sim:corridor:1:2 --corrected camera --output camera --obstacles");
  ASSERT_EQ (learned.code, 0) << learned.err;
  EXPECT_EQ (learned.err.find ("no plane told"), std::string::npos) << learned.err;
  EXPECT_TRUE (std::filesystem::exists (folder_ / "camera/warp.png"));
  const std::string warp = " --corrected camera/warp.pcd --output ";
  ASSERT_EQ (run ("sim:corridor:1:2" + warp + "again").code, 0);
  EXPECT_EQ (planes ("again/result.json"), planes ("camera/result.json"));
  EXPECT_FALSE (std::filesystem::exists (folder_ / "again/warp.pcd"));

  // The angle between two walls of the corridor.
  const auto cosine = [&] (const std::string& file) {
    const json found = planes (file);
    double sum = 0.;
    for (int i = 0; i < 3; ++i)
      sum += found[1]["normal"][i].get<double>() * found[2]["normal"][i].get<double>();
    return std::fabs (sum);
  };
  ASSERT_EQ (run ("sim:corridor:1:2 --json measured.json").code, 0);
  EXPECT_GT (cosine ("measured.json"), 0.05);
  EXPECT_LT (cosine ("again/result.json"), 0.02);
  ASSERT_EQ (run ("sim:corridor:1:2 --resolution qvga" + warp + "small").code, 0);
  EXPECT_LT (cosine ("small/result.json"), 0.02);
}

TEST_F (SegmentCorrectedDepth, SaysWhereNothingToldTheWarp)
{
  writePng (folder_ / "dark.png", 160, std::vector<std::uint16_t> (160 * 120));
  const Outcome outcome = run ("dark.png --corrected camera --output dark" + camera_);
  ASSERT_EQ (outcome.code, 0) << outcome.err;
  EXPECT_NE (outcome.err.find ("no plane told the error of depth"), std::string::npos)
      << outcome.err;
}

TEST_F (SegmentCorrectedDepth, WarpsOfOddSizesFitAllResolutions)
{
  writePng (folder_ / "odd.png", 161, std::vector<std::uint16_t> (161 * 121, 1000));
  std::string zeros;
  for (int i = 0; i < 161 * 121; ++i)
    zeros += "0\n";
  writeFile (folder_ / "warp.pcd", asciiPcd ("intensity", 161, 121, zeros));
  for (const std::string resolution : {"vga", "qvga", "qqvga"}) {
    const Outcome outcome =
        run ("odd.png --corrected warp.pcd --resolution " + resolution + camera_);
    EXPECT_EQ (outcome.code, 0) << outcome.err;
  }
}

TEST_F (SegmentCorrectedDepth, FramesOfAPipeTellNoWarpOfTheCamera)
{
  ASSERT_EQ (shell ("mkfifo frame.pcd").code, 0);
  expectRefused ("frame.pcd --corrected camera",
                 "frame.pcd: a pipe can be read only once");
}

TEST_F (SegmentCorrectedDepth, RefusesWhatIsNoWarpOfTheCamera)
{
  ASSERT_EQ (
      run ("sim:corridor --corrected camera --resolution qvga --output camera").code,
      0);
  expectRefused ("sim:corridor --corrected camera/warp.pcd", "320 x 240");
  expectRefused ("sim:corridor --corrected camera/corridor_1_labels.pcd", "intensity");
  expectRefused ("sim:corridor --corrected none.pcd", "none.pcd");
  expectRefused ("sim:corridor --corrected cam", "frame, camera or a .pcd file");
  pcl::PointCloud<pcl::Intensity> broken (640, 480);
  broken[7].intensity = std::numeric_limits<float>::infinity();
  pcl::io::savePCDFileBinary (folder_ / "broken.pcd", broken);
  expectRefused ("sim:corridor --corrected broken.pcd", "no warp");
  for (const float value : {0.3f, -10.f, 100.f}) {
    for (auto& point : broken)
      point.intensity = value;
    pcl::io::savePCDFileBinary (folder_ / "broken.pcd", broken);
    expectRefused ("sim:corridor --corrected broken.pcd", "-0.2 to 0.2 / m");
  }
}
