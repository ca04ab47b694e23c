// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "segment_planes_test.h"
#include "synthetic_clouds.h"

#include <pcl/common/transforms.h>
#include <pcl/features/depth_noise.h>
#include <pcl/io/pcd_io.h>
#include <pcl/simulation/simulate.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <regex>

using namespace pcl::rgbd_planes;
using nlohmann::json;

namespace {

class SegmentUsage : public SegmentPlanesTest {};

} // namespace

TEST_F (SegmentUsage, HelpIsNoError)
{
  const Outcome result = run ("--help");
  EXPECT_EQ (result.code, 0);
  EXPECT_EQ (result.err, "");
  EXPECT_NE (result.out.find ("INPUT"), std::string::npos);
  EXPECT_EQ (run ("-h").out, result.out);
  EXPECT_EQ (run ("--version").out.rfind ("pcl_rgbd_planes 0.", 0), 0u);
  for (const auto& scene : sceneNames())
    EXPECT_NE (result.out.find (scene), std::string::npos) << scene;
  EXPECT_FALSE (std::regex_search (result.out, std::regex ("\n *:"))) << result.out;
}

TEST_F (SegmentUsage, SpacesMayFollowCommas)
{
  writeTwoWalls ("walls.png");
  const Outcome result = run ("walls.png --intrinsics '131, 131, 79.5, 59.5' "
                              "--depth-scale 1000 --depth-noise '0.001, 0.002, 2.5'");
  EXPECT_EQ (result.code, 0) << result.err;
}

TEST_F (SegmentUsage, ProgressIsShownOnATerminal)
{
  std::filesystem::create_directory (folder_ / "frames");
  writeTwoWalls ("frames/1.png");
  writeTwoWalls ("frames/2.png");
  const std::string arguments = "frames" + camera_;
  const Outcome outcome = shell ("script -qec \"" + application_ + " " + arguments +
                                 " >table.txt\" /dev/null </dev/null");
  ASSERT_EQ (outcome.code, 0) << outcome.out;
  EXPECT_NE (outcome.out.find ("\rframe 1 of 2\rframe 2 of 2"), std::string::npos)
      << outcome.out;
  EXPECT_EQ (run (arguments).err, "") << "where there is no terminal";
}

TEST_F (SegmentUsage, MillimetresAreToldOncePerRun)
{
  std::filesystem::create_directory (folder_ / "in");
  writeTwoWalls ("in/1.png");
  writeTwoWalls ("in/2.png");
  for (const std::string more : {"", " --corrected frame", " --objects --obstacles"}) {
    const Outcome result =
        run ("in --intrinsics 131,131,79.5,59.5 --depth-scale 1" + more);
    EXPECT_EQ (result.code, 0) << result.err;
    EXPECT_NE (result.err.find ("millimetres"), std::string::npos) << result.err;
    // By the class, and by the application, which knows the option to set.
    EXPECT_EQ (std::count (result.err.begin(), result.err.end(), '\n'), 2)
        << result.err;
  }
}

TEST_F (SegmentUsage, OtherScalesThanUnitsPerMetreAreTold)
{
  writeTwoWalls ("walls.png");
  const auto noticeAt = [&] (const std::string& scale) {
    return run ("walls.png --intrinsics 131,131,79.5,59.5 --depth-scale " + scale).err;
  };
  for (const std::string scale : {"0.001", "1e6", "1e30"})
    EXPECT_NE (noticeAt (scale).find (
                   "pcl_segment_planes: in 1 of 1 frames most points are more than 100 "
                   "m or less than 1 cm away: --depth-scale is units per metre, 1000 "
                   "for millimetres; .pcd files must be in metres\n"),
               std::string::npos);
  EXPECT_EQ (noticeAt ("100000"), "") << "1 cm and more";
  EXPECT_EQ (noticeAt ("1e-7").find ("inf m"), std::string::npos)
      << "10^10 m, from a sensor without a limit";
}

TEST_F (SegmentUsage, DepthThatOverflowsIsMissing)
{
  writeTwoWalls ("walls.png");
  const Outcome result =
      run ("walls.png --intrinsics 131,131,79.5,59.5 --depth-scale 1e-36");
  EXPECT_EQ (result.code, 0);
  EXPECT_EQ (result.err.find ("--depth-noise"), std::string::npos) << result.err;
}

TEST_F (SegmentUsage, FramesWithoutDepthAreTold)
{
  std::filesystem::create_directory (folder_ / "in");
  writeTwoWalls ("in/1.png");
  writePng (folder_ / "in/2.png", 160, std::vector<std::uint16_t> (160 * 120));
  const Outcome some = run ("in --obstacles --base-transform 0,0,1,0,0,0" + camera_);
  EXPECT_EQ (some.code, 0);
  EXPECT_EQ (some.err,
             "pcl_segment_planes: no measured point in 1 of 2 frames: all depth is "
             "missing there; check the camera or the recording\n");
  EXPECT_NE (some.out.find ("2: 0 obstacles, no measured point: nothing is safe\n"),
             std::string::npos)
      << some.out;
  writeFile (folder_ / "nan.pcd",
             asciiPcd ("x y z", 2, 2, "nan nan nan\nnan nan nan\n0 0 0\n0 0 0\n"));
  EXPECT_NE (run ("nan.pcd").err.find ("no measured point in 1 of 1 frames"),
             std::string::npos);
}

TEST_F (SegmentUsage, CloudsInOtherFramesThanTheCamerasAreTold)
{
  const auto scene = simulate ("room", 1, Sensor::kinect);
  Eigen::Matrix3f mirror = Eigen::Vector3f (1.f, -1.f, -1.f).asDiagonal(), to_forward;
  to_forward << 0.f, 0.f, 1.f, -1.f, 0.f, 0.f, 0.f, -1.f, 0.f;
  const std::map<std::string, Eigen::Affine3f> frames{
      {"camera", Eigen::Affine3f::Identity()},
      {"opengl", Eigen::Affine3f (mirror)},
      {"kinect_v2", Eigen::Affine3f (Eigen::Scaling (-1.f, -1.f, 1.f))},
      {"x_to_the_left", Eigen::Affine3f (Eigen::Scaling (-1.f, 1.f, 1.f))},
      {"forward", Eigen::Affine3f (to_forward)},
      {"robot", scene.camera_to_base}};
  for (const auto& [name, transform] : frames) {
    pcl::PointCloud<pcl::PointXYZRGB> cloud;
    pcl::transformPointCloud (*scene.cloud, cloud, transform);
    pcl::io::savePCDFileBinary (folder_ / (name + ".pcd"), cloud);
    const Outcome result = run (name + ".pcd");
    EXPECT_EQ (result.code, 0) << result.err;
    const std::string notice =
        "pcl_segment_planes: in 1 of 1 frames most points are not where a camera sees";
    EXPECT_EQ (result.err.rfind (notice, 0) == 0, name != "camera")
        << name << ": " << result.err;
    EXPECT_EQ (std::count (result.err.begin(), result.err.end(), '\n'),
               name != "camera")
        << result.err;
  }
}

TEST_F (SegmentUsage, SensorsSeeAsFarAsTheirNoiseSays)
{
  writeTwoWalls ("walls.png"); // at 4 and 6 m, from 25 cm above z = 0 on
  const std::map<std::string, std::size_t> walls_in_range{{"kinect_v1", 2},
                                                          {"structured_light", 0},
                                                          {"time_of_flight", 1},
                                                          {"active_stereo", 1},
                                                          {"0,0.003", 2}};
  for (const auto& [sensor, walls] : walls_in_range) {
    const Outcome result =
        run ("walls.png --intrinsics 131,131,79.5,59.5 --depth-scale 250 --obstacles "
             "--base-transform 0,0,3,0,0,0 --json found.json --depth-noise " +
             sensor);
    ASSERT_EQ (result.code, 0) << result.err;
    const json frame = json::parse (readFile (folder_ / "found.json"))["frames"][0];
    EXPECT_EQ (frame["planes"].size(), walls) << sensor;
    EXPECT_EQ (frame["obstacles"].size(), walls) << sensor;
    const std::string share = walls == 0 ? "--depth-noise: 100 % of the measured points"
                                         : "--depth-noise: 50 % of the measured points";
    EXPECT_EQ (result.err.find (share) != std::string::npos, walls < 2) << result.err;
  }
}

TEST_F (SegmentUsage, NoiseInMillimetresIsTold)
{
  writeTwoWalls ("walls.png");
  for (const std::string figures : {"1,2", "1,0"}) {
    const Outcome result = run (
        "walls.png --intrinsics 131,131,79.5,59.5 --depth-scale 250 --depth-noise " +
        figures);
    EXPECT_EQ (result.code, 0) << result.err;
    EXPECT_EQ (
        result.err,
        "pcl_segment_planes: --depth-noise: 100 % of the measured points have "
        "noise of more than a tenth of their range, which tells nothing; figures "
        "are in metres, 0.001,0.002 for 1 mm + 2 mm z^2\n");
  }
}

TEST_F (SegmentUsage, FramesWithFarMoreNoiseThanTheSensorAreTold)
{
  const auto errorsWith = [this] (float factor) {
    const auto scene = synthetic::render (
        {synthetic::tiltedPlane (1.5f, 0.f, 20.f)}, 640, 480, [factor] (float z) {
          return factor * DepthNoise::kinectV1().sigmaAtSquare (z * z);
        });
    pcl::io::savePCDFileBinary (folder_ / "wall.pcd", *scene.cloud);
    return run ("wall.pcd").err;
  };
  EXPECT_EQ (errorsWith (2.f), "");
  EXPECT_EQ (errorsWith (8.f),
             "pcl_segment_planes: --depth-noise: 1 of 1 frames seem to have four times "
             "the noise of this sensor, or more; pcl_measure_depth_noise measures what "
             "they have\n");
}

TEST_F (SegmentUsage, BadUsageIsRefused)
{
  writeTwoWalls ("walls.png");
  const std::string input = "walls.png --output out ";
  expectRefused ("", "no INPUT given; see --help");
  expectRefused ("walls.png walls.png", "only 1 INPUT may be given");
  expectRefused ("--input walls.png --input walls.png", "only 1 INPUT may be given");
  expectRefused (input + "--depth-scale 1000 --intrinsics 131,131,790,59.5",
                 "walls.png: has 160 x 120 pixels, far from which the principal point");
  EXPECT_EQ (run ("walls.png --depth-scale 1000 --intrinsics 131,131,120,59.5")
                 .err.rfind ("pcl_segment_planes: walls.png: has 160 x 120 pixels, far "
                             "from whose middle",
                             0),
             0u);
  expectRefused (input + camera_ + "--colour", "see --help");
  expectRefused (input + camera_ + "--frames", "see --help");
  expectRefused (input + camera_ + "--frames 0", "--frames");
  expectRefused (input + camera_ + "--frames=-1", "--frames");
  expectRefused (input + camera_ + "--min-inliers 0", "--min-inliers");
  expectRefused (input + camera_ + "--min-inliers many", "--min-inliers");
  expectRefused (input + camera_ + "--resolution xga", "vga, qvga or qqvga");
  expectRefused (input + camera_ + "--depth-noise sonar",
                 "active_stereo or CONSTANT,QUADRATIC");
  for (const std::string noise : {"0.001,",
                                  "0,0",
                                  "-0.001,0.002",
                                  "0.001,0.002,",
                                  "0.001,0.002,0.9",
                                  "0.001,0.002,nan",
                                  "0.001,0.002,3,4"})
    expectRefused (input + camera_ + "--depth-noise=" + noise, "--depth-noise: ");
  expectRefused (input + camera_ + "--depth-noise active_stereo --corrected frame",
                 "leave out --depth-noise or --corrected");
  for (const std::string intrinsics : {"1,2,3",
                                       "1,2,3,4,5",
                                       "1,2,3,x",
                                       "0,1,1,1",
                                       "-1,1,1,1",
                                       "nan,1,1,1",
                                       "1,inf,1,1",
                                       ",,,"})
    expectRefused (input + "--depth-scale 1000 --intrinsics=" + intrinsics,
                   "--intrinsics");
  for (const std::string scale : {"0", "-1000", "nan", "inf", "1000x", "1e99"})
    expectRefused (input + "--intrinsics 131,131,79.5,59.5 --depth-scale=" + scale,
                   "--depth-scale");
  expectRefused ("sim:table_single --output out" + camera_, "leave them out");
}

TEST_F (SegmentUsage, BadInputIsRefused)
{
  const std::string output = " --output out --json out.json ";
  expectRefused ("missing.pcd" + output, "missing.pcd: no such file");
  writeFile (folder_ / "row.pcd", asciiPcd ("x y z", 3, 1, "1 1 1\n1 1 1\n1 1 1\n"));
  expectRefused ("row.pcd" + output, "row.pcd: the cloud is unorganized");
  writePng (
      folder_ / "grey.png", 160, std::vector<std::uint16_t> (1600), {8, 1, false, 0.});
  expectRefused ("grey.png" + output + camera_, "grey.png: not a depth image");
  writeTwoWalls ("walls.png");
  expectRefused ("walls.png" + output, "add --intrinsics");
  expectRefused ("walls.png --intrinsics 131,131,79.5,59.5" + output,
                 "add --depth-scale");
  expectRefused ("sim:nowhere" + output,
                 "unknown scene 'nowhere'; known are table_single");
  expectRefused ("sim:table_single:x" + output, "seed");
  expectRefused ("live:none.oni" + output, "no such file");
  writeFile (folder_ / "part.png", readFile (folder_ / "walls.png").substr (0, 100));
  expectRefused ("part.png" + output + camera_, "part.png: the PNG file is incomplete");
  writeFile (folder_ / "depth.txt", "1.5 walls.png\n");
  expectRefused ("depth.txt" + output,
                 "depth.txt: neither a .pcd nor a .png file; give "
                 "its folder");
  writeFile (folder_ / "empty.pcd", "");
  expectRefused ("empty.pcd" + output, "empty.pcd: not a PCD file");
}

TEST_F (SegmentUsage, BadFrameAmongGoodOnesLeavesNothing)
{
  std::filesystem::create_directory (folder_ / "in");
  writeTwoWalls ("in/1.png");
  writeTwoWalls ("in/2.png");
  writeFile (folder_ / "in/3.png", readFile (folder_ / "in/1.png").substr (0, 100));
  expectRefused ("in --output out --json out.json" + camera_, "in/3.png: the PNG file");
}

TEST_F (SegmentUsage, UnwritablePlacesAreRefused)
{
  writeTwoWalls ("walls.png");
  const std::string input = "walls.png" + camera_;
  expectRefused (input + "--output walls.png", "walls.png: cannot create this folder");
  expectRefused (input + "--output walls.png/out", "cannot create this folder");
  expectRefused (input + "--output /proc/out", "/proc/out: cannot create this folder");
  expectRefused (input + "--output ''", "is no name of a folder");
  expectRefused (input + "--output out --json nowhere/out.json",
                 "cannot write this file");
  expectRefused (input + "--json .", "no regular file");
  expectRefused (input + "--json /dev/full", "no regular file");
  expectRefused (input + "--json /dev/stdout", "standard output has the tables");
  std::filesystem::create_directories (folder_ / "taken/walls_planes.png");
  expectRefused (input + "--output taken", "no regular file");
  EXPECT_EQ (listFolder (folder_ / "taken"),
             std::vector<std::string>{"walls_planes.png"});
  std::filesystem::create_directory (folder_ / "in");
  writeTwoWalls ("in/walls.png");
  expectRefused ("in --output in/../in" + camera_, "is a folder of INPUT");
}

TEST_F (SegmentUsage, TwoResultsInOneFileAreRefused)
{
  writeTwoWalls ("walls.png");
  std::filesystem::create_directory (folder_ / "in");
  writeTwoWalls ("in/walls.png");
  const std::string reason = "two results of this run";
  expectRefused ("walls.png --output out --json out/planes.csv" + camera_, reason);
  expectRefused ("in/walls.png --output . --json result.json" + camera_, reason);
  expectRefused ("walls.png --output out --json out/walls_depth.png" + camera_, reason);
  expectRefused ("walls.png --json ''" + camera_, "no name of a file");
  expectRefused ("walls.png --json -" + camera_, "give the name of a file");
}

TEST_F (SegmentUsage, InputsAreNotReplaced)
{
  std::filesystem::create_directory (folder_ / "in");
  for (const std::string name : {"walls.png", "in/1.png", "in/2.png"})
    writeTwoWalls (name);
  expectRefused ("walls.png --json walls.png" + camera_, "walls.png: is an input");
  expectRefused ("in --frames 1 --json in/2.png" + camera_, "in/2.png: is an input");
  expectRefused ("walls.png --output ." + camera_, "is a folder of INPUT");
  expectRefused ("in/1.png --output in" + camera_, "is a folder of INPUT");
  writeFile (folder_ / "depth.txt", "1.5 in/1.png\n");
  expectRefused (". --output in" + camera_, "in: is a folder of INPUT");
  writeFile (folder_ / "groundtruth.txt", "");
  expectRefused (". --json groundtruth.txt" + camera_, "groundtruth.txt: is an input");
  EXPECT_EQ (run ("in/1.png --output ." + camera_).code, 0);
  writeFile (folder_ / "warp.pcd", asciiPcd ("intensity", 2, 2, "0\n0\n0\n0\n"));
  expectRefused ("sim:room --corrected warp.pcd --json warp.pcd",
                 "warp.pcd: is an input");
}
