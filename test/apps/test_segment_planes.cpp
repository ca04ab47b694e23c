// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "app_test.h"
#include "synthetic_clouds.h"

#include <pcl/apps/labelled_point.h>
#include <pcl/apps/pictures.h>
#include <pcl/common/transforms.h>
#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/plane_extraction.h>
#include <pcl/simulation/simulate.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

using namespace pcl::rgbd_planes;
using nlohmann::json;

namespace {

class SegmentPlanes : public AppTest {
protected:
  SegmentPlanes() : AppTest (SEGMENT_PLANES) {}

  /** A depth image of 160 x 120, 1 mm units: a wall at 1 m left, one at 1.5 m right,
   * the four top rows missing. */
  void
  writeTwoWalls (const std::string& name) const
  {
    std::vector<std::uint16_t> depth (160 * 120);
    for (std::size_t i = 4 * 160; i < depth.size(); ++i)
      depth[i] = i % 160 < 80 ? 1000 : 1500;
    writePng (folder_ / name, 160, depth);
  }

  const std::string camera_ = " --intrinsics 131,131,79.5,59.5 --depth-scale 1000 ";
};

struct CsvPlane {
  std::string frame;
  std::vector<double> numbers;
};

std::vector<CsvPlane>
readCsv (const std::filesystem::path& file)
{
  std::istringstream lines (readFile (file));
  std::string line;
  std::getline (lines, line);
  EXPECT_EQ (line, "frame,plane,a,b,c,d,points,rms_m,class");
  std::vector<CsvPlane> planes;
  while (std::getline (lines, line)) {
    CsvPlane plane;
    std::istringstream fields (line);
    std::getline (fields, plane.frame, ',');
    for (std::string field;
         plane.numbers.size() < 7 && std::getline (fields, field, ',');)
      plane.numbers.push_back (std::stod (field));
    planes.push_back (plane);
  }
  return planes;
}

/** Everything that is written about one frame says the same. */
void
expectConsistent (const std::filesystem::path& folder, const json& frame)
{
  const std::string name = frame["frame"];
  pcl::PointCloud<LabelledPoint> cloud;
  ASSERT_EQ (pcl::io::loadPCDFile (folder / (name + "_labels.pcd"), cloud), 0);
  ASSERT_EQ (cloud.width, frame["width"]);
  ASSERT_EQ (cloud.height, frame["height"]);
  const RgbImage planes = readRgbPng (folder / (name + "_planes.png"));
  const RgbImage normals = readRgbPng (folder / (name + "_normals.png"));
  const RgbImage depth = readRgbPng (folder / (name + "_depth.png"));
  std::map<std::uint32_t, std::size_t> points;
  std::map<std::uint32_t, double> squares;
  std::size_t measured = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto& p = cloud[i];
    const auto colour = [i] (const RgbImage& image) {
      return std::vector<int> (
          image.samples.begin() + static_cast<std::ptrdiff_t> (3 * i),
          image.samples.begin() + static_cast<std::ptrdiff_t> (3 * i + 3));
    };
    const std::vector<int> black{0, 0, 0}, grey{128, 128, 128};
    const bool missing = std::isnan (p.z);
    measured += !missing;
    ASSERT_EQ (colour (depth) == black, missing) << i;
    ASSERT_EQ (colour (normals) == black, std::isnan (p.normal_x)) << i;
    ASSERT_EQ (colour (planes) == black, missing) << i;
    if (p.label == unlabelled) {
      ASSERT_TRUE (missing || colour (planes) == grey) << i;
      continue;
    }
    ASSERT_FALSE (missing) << i;
    const pcl::RGB expected = planeColour (p.label);
    ASSERT_EQ (colour (planes), (std::vector<int>{expected.r, expected.g, expected.b}));
    ++points[p.label];
    const json& plane = frame["planes"].at (p.label);
    const double distance = plane["normal"][0].get<double>() * p.x +
                            plane["normal"][1].get<double>() * p.y +
                            plane["normal"][2].get<double>() * p.z +
                            plane["distance_m"].get<double>();
    squares[p.label] += distance * distance;
  }
  EXPECT_EQ (measured, frame["measured_points"]);
  ASSERT_EQ (points.size(), frame["planes"].size());
  std::size_t labelled = 0;
  for (const auto& [id, count] : points) {
    const json& plane = frame["planes"].at (id);
    EXPECT_EQ (plane["id"], id);
    EXPECT_EQ (plane["points"], count);
    EXPECT_GE (count, frame["min_inliers"]);
    EXPECT_NEAR (
        plane["rms_m"], std::sqrt (squares[id] / static_cast<double> (count)), 1e-6);
    EXPECT_GE (plane["distance_m"], 0.);
    labelled += count;
  }
  EXPECT_EQ (labelled, frame["labelled_points"]);
}

void
expectConsistent (const std::filesystem::path& folder)
{
  const json result = json::parse (readFile (folder / "result.json"));
  const auto csv = readCsv (folder / "planes.csv");
  std::size_t row = 0;
  for (const auto& frame : result["frames"]) {
    expectConsistent (folder, frame);
    for (const auto& plane : frame["planes"]) {
      ASSERT_LT (row, csv.size());
      EXPECT_EQ (csv[row].frame, frame["frame"]);
      const auto& numbers = csv[row].numbers;
      ASSERT_EQ (numbers.size(), 7u);
      EXPECT_EQ (numbers[0], plane["id"]);
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR (numbers[1 + i], plane["normal"][i], 1e-8);
      EXPECT_NEAR (numbers[4], plane["distance_m"], 1e-7);
      EXPECT_EQ (numbers[5], plane["points"]);
      EXPECT_NEAR (numbers[6], plane["rms_m"], 1e-8);
      ++row;
    }
  }
  EXPECT_EQ (row, csv.size());
}

} // namespace

TEST_F (SegmentPlanes, FindsTwoWallsInADepthImage)
{
  writeTwoWalls ("walls.png");
  const Outcome result =
      run ("walls.png --output out/deep --json result.json" + camera_);
  ASSERT_EQ (result.code, 0) << result.err;
  EXPECT_EQ (result.err, "");
  EXPECT_NE (result.out.find ("refinement"), std::string::npos) << result.out;
  EXPECT_EQ (listFolder (folder_ / "out/deep"),
             (std::vector<std::string>{"planes.csv",
                                       "result.json",
                                       "walls_depth.png",
                                       "walls_labels.pcd",
                                       "walls_normals.png",
                                       "walls_planes.png"}));
  expectConsistent (folder_ / "out/deep");
  EXPECT_EQ (readFile (folder_ / "out/deep/result.json"),
             readFile (folder_ / "result.json"));

  const json frame = json::parse (readFile (folder_ / "result.json"))["frames"][0];
  EXPECT_EQ (frame["measured_points"], 160 * 116);
  ASSERT_EQ (frame["planes"].size(), 2u);
  double near = frame["planes"][0]["distance_m"],
         far = frame["planes"][1]["distance_m"];
  if (near > far)
    std::swap (near, far);
  EXPECT_NEAR (near, 1., 1e-4);
  EXPECT_NEAR (far, 1.5, 1e-4);
  for (const auto& plane : frame["planes"]) {
    EXPECT_NEAR (plane["normal"][2], -1., 1e-6);
    EXPECT_EQ (plane["class"], "unknown");
  }
}

TEST_F (SegmentPlanes, TellsWhyCandidatesAreNoPlanes)
{
  writeTwoWalls ("walls.png");
  for (const std::size_t walls : {0, 2}) {
    const std::string min_inliers = walls == 0 ? "12000" : "1000";
    ASSERT_EQ (
        run ("walls.png --json found.json --min-inliers " + min_inliers + camera_).code,
        0);
    const json frame = json::parse (readFile (folder_ / "found.json"))["frames"][0];
    EXPECT_EQ (frame["planes"].size(), walls);
    const json& rejections = frame["rejections"];
    EXPECT_EQ (rejections.size(), 3u);
    EXPECT_GE (rejections["too_few_points"].get<std::size_t>() + walls, 2u);
    EXPECT_EQ (rejections["curved"], 0);
    EXPECT_EQ (rejections["claimed_by_larger"], 0);
  }
}

TEST_F (SegmentPlanes, SimulatedTableAtAllResolutions)
{
  std::string inliers;
  for (const std::string resolution : {"vga", "qvga", "qqvga"}) {
    const Outcome result =
        run ("sim:table_single --resolution " + resolution + " --output " + resolution);
    ASSERT_EQ (result.code, 0) << result.err;
    expectConsistent (folder_ / resolution);
    const json found = json::parse (readFile (folder_ / (resolution + "/result.json")));
    EXPECT_GE (found["frames"][0]["planes"].size(), 2u);
    inliers += found["frames"][0]["min_inliers"].dump() + ' ';
  }
  EXPECT_EQ (inliers, "1000 250 62 ");
}

TEST_F (SegmentPlanes, SequenceGivesOneResultForEachFrame)
{
  std::filesystem::create_directory (folder_ / "in");
  for (const std::string name : {"in/1.png", "in/2.png", "in/10, \"last\".png"})
    writeTwoWalls (name);
  const Outcome result = run ("in --output out --min-inliers 9000" + camera_);
  ASSERT_EQ (result.code, 0) << result.err;
  EXPECT_EQ (result.err, "");
  const json found = json::parse (readFile (folder_ / "out/result.json"));
  ASSERT_EQ (found["frames"].size(), 3u);
  EXPECT_EQ (found["frames"][2]["frame"], "10, \"last\"");
  EXPECT_EQ (found["frames"][2]["min_inliers"], 9000);
  EXPECT_EQ (found["frames"][0]["planes"], found["frames"][2]["planes"]);
  const std::string csv = readFile (folder_ / "out/planes.csv");
  EXPECT_NE (csv.find ("\n\"10, \"\"last\"\"\",0,"), std::string::npos) << csv;
  const auto& times = found["stage_times_ms"];
  for (const std::string stage : {"normals",
                                  "normal_space_clustering",
                                  "distance_space_clustering",
                                  "refinement",
                                  "total"}) {
    EXPECT_LE (times[stage]["min"], times[stage]["median"]) << stage;
    EXPECT_LE (times[stage]["median"], times[stage]["max"]) << stage;
  }
}

TEST_F (SegmentPlanes, ProgressIsShownOnATerminal)
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

TEST_F (SegmentPlanes, SensorsSeeAsFarAsTheirNoiseSays)
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

TEST_F (SegmentPlanes, MillimetresAreToldOnce)
{
  std::filesystem::create_directory (folder_ / "in");
  writeTwoWalls ("in/1.png");
  writeTwoWalls ("in/2.png");
  for (const std::string more : {"", " --corrected frame", " --objects --obstacles"}) {
    const Outcome result =
        run ("in --intrinsics 131,131,79.5,59.5 --depth-scale 1" + more);
    EXPECT_EQ (result.code, 0) << result.err;
    EXPECT_NE (result.err.find ("millimetres"), std::string::npos) << result.err;
    const bool guessed = more.find ("--objects") != std::string::npos;
    EXPECT_EQ (std::count (result.err.begin(), result.err.end(), '\n'),
               guessed ? 2 : 1) // the pose
        << result.err;
  }
}

TEST_F (SegmentPlanes, CloudsInOtherFramesThanTheCamerasAreTold)
{
  const auto scene = simulate ("room", 1, Sensor::kinect);
  Eigen::Matrix3f mirror = Eigen::Vector3f (1.f, -1.f, -1.f).asDiagonal(), to_forward;
  to_forward << 0.f, 0.f, 1.f, -1.f, 0.f, 0.f, 0.f, -1.f, 0.f;
  const std::map<std::string, Eigen::Affine3f> frames{
      {"camera", Eigen::Affine3f::Identity()},
      {"opengl", Eigen::Affine3f (mirror)},
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

TEST_F (SegmentPlanes, FrameWithoutDepthHasNoPlanes)
{
  writePng (folder_ / "dark.png", 160, std::vector<std::uint16_t> (160 * 120));
  const Outcome result = run ("dark.png --output out" + camera_);
  ASSERT_EQ (result.code, 0) << result.err;
  EXPECT_NE (result.out.find (" 0 points measured, 0.0 %"), std::string::npos);
  expectConsistent (folder_ / "out");
}

TEST_F (SegmentPlanes, BadInputIsRefused)
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
  writeFile (folder_ / "empty.pcd", "");
  expectRefused ("empty.pcd" + output, "empty.pcd: not a PCD file");
}

TEST_F (SegmentPlanes, BadFrameAmongGoodOnesLeavesNothing)
{
  std::filesystem::create_directory (folder_ / "in");
  writeTwoWalls ("in/1.png");
  writeTwoWalls ("in/2.png");
  writeFile (folder_ / "in/3.png", readFile (folder_ / "in/1.png").substr (0, 100));
  expectRefused ("in --output out --json out.json" + camera_, "in/3.png: the PNG file");
}

TEST_F (SegmentPlanes, BadUsageIsRefused)
{
  writeTwoWalls ("walls.png");
  const std::string input = "walls.png --output out ";
  expectRefused ("", "no INPUT given; see --help");
  expectRefused ("walls.png walls.png", "see --help");
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

TEST_F (SegmentPlanes, UnwritablePlacesAreRefused)
{
  writeTwoWalls ("walls.png");
  const std::string input = "walls.png" + camera_;
  expectRefused (input + "--output walls.png", "walls.png: cannot create this folder");
  expectRefused (input + "--output walls.png/out", "cannot create this folder");
  expectRefused (input + "--output /proc/out", "/proc/out: cannot create this folder");
  expectRefused (input + "--output ''", "cannot create this folder");
  expectRefused (input + "--output out --json nowhere/out.json",
                 "cannot write this file");
  expectRefused (input + "--json .", "no regular file");
  expectRefused (input + "--json /dev/full", "no regular file");
  std::filesystem::create_directories (folder_ / "taken/walls_planes.png");
  expectRefused (input + "--output taken", "no regular file");
  EXPECT_EQ (listFolder (folder_ / "taken"),
             std::vector<std::string>{"walls_planes.png"});
  std::filesystem::create_directory (folder_ / "in");
  writeTwoWalls ("in/walls.png");
  expectRefused ("in --output in/../in" + camera_, "is the INPUT folder");
}

TEST_F (SegmentPlanes, TwoResultsInOneFileAreRefused)
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

TEST_F (SegmentPlanes, InputsAreNotReplaced)
{
  std::filesystem::create_directory (folder_ / "in");
  for (const std::string name : {"walls.png", "in/1.png", "in/2.png"})
    writeTwoWalls (name);
  expectRefused ("walls.png --json walls.png" + camera_, "walls.png: is an input");
  expectRefused ("in --frames 1 --json in/2.png" + camera_, "in/2.png: is an input");
  expectRefused ("walls.png --output ." + camera_, "is the folder of INPUT");
  expectRefused ("in/1.png --output in" + camera_, "is the folder of INPUT");
  EXPECT_EQ (run ("in/1.png --output ." + camera_).code, 0);
  writeFile (folder_ / "warp.pcd", asciiPcd ("intensity", 2, 2, "0\n0\n0\n0\n"));
  expectRefused ("sim:room --corrected warp.pcd --json warp.pcd",
                 "warp.pcd: is an input");
}

TEST_F (SegmentPlanes, HelpIsNoError)
{
  const Outcome result = run ("--help");
  EXPECT_EQ (result.code, 0);
  EXPECT_EQ (result.err, "");
  EXPECT_NE (result.out.find ("INPUT"), std::string::npos);
  EXPECT_EQ (run ("-h").out, result.out);
  EXPECT_EQ (run ("--version").out.rfind ("pcl_rgbd_planes 0.", 0), 0u);
  for (const auto& scene : sceneNames())
    EXPECT_NE (result.out.find (scene), std::string::npos) << scene;
}

TEST_F (SegmentPlanes, RealFrames)
{
  SKIP_WITHOUT_RECORDINGS();
  const std::filesystem::path data = synthetic::dataFolder();
  const std::string inputs[] = {
      (data / "kinect/office1.pcd").string(),
      (data / "mosd_learn/learn20.pcd").string(),
      (data / "tum_fr3_structure_notexture_far").string() + " --frames 2",
      (data / "icsl_corridor/depth").string() +
          " --frames 2 --depth-scale 1000 --intrinsics 537.60,539.03,316.15,245.52"};
  for (const auto& input : inputs) {
    const Outcome result = run (input + " --resolution qvga --output out");
    ASSERT_EQ (result.code, 0) << result.err;
    EXPECT_EQ (result.err, "");
    expectConsistent (folder_ / "out");
    const json found = json::parse (readFile (folder_ / "out/result.json"));
    for (const auto& frame : found["frames"])
      EXPECT_GE (frame["planes"].size(), 2u) << input;
  }
}

TEST_F (SegmentPlanes, FindsTheObjectOfASimulatedTable)
{
  const Outcome result = run ("sim:table_single --objects --output out");
  ASSERT_EQ (result.code, 0) << result.err;
  const json frame = json::parse (readFile (folder_ / "out/result.json"))["frames"][0];
  ASSERT_EQ (frame["objects"].size(), 1u);
  const std::size_t plane = frame["objects"][0]["plane"];
  EXPECT_EQ (frame["planes"][plane]["class"], "table");
  const std::string csv = readFile (folder_ / "out/objects.csv");
  EXPECT_EQ (std::count (csv.begin(), csv.end(), '\n'), 2);

  const RgbImage picture = readRgbPng (folder_ / "out/table_single_1_objects.png");
  const auto pixels = [&] (const pcl::RGB& colour) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < picture.samples.size(); i += 3)
      count += picture.samples[i] == colour.r && picture.samples[i + 1] == colour.g &&
               picture.samples[i + 2] == colour.b;
    return count;
  };
  // The edges of the box take some of its pixels; the hull has the colour of the table.
  const std::size_t points = frame["objects"][0]["points"];
  EXPECT_TRUE (frame["objects"][0]["graspable"]);
  EXPECT_GT (pixels (pcl::RGB (255, 255, 255)), 200u) << "the box";
  EXPECT_GT (pixels (planeColour (static_cast<std::uint32_t> (plane))),
             (plane == 0 ? points : 0) + 500)
      << "the hull";
  EXPECT_GT (pixels (planeColour (0)), points * 8 / 10) << "the object";
}

TEST_F (SegmentPlanes, ListOfObjectsAndJsonSayTheSame)
{
  const Outcome result =
      run ("sim:table_cluttered --resolution qvga --objects --output out");
  ASSERT_EQ (result.code, 0) << result.err;
  const json frame = json::parse (readFile (folder_ / "out/result.json"))["frames"][0];
  std::istringstream lines (readFile (folder_ / "out/objects.csv"));
  std::string line;
  std::getline (lines, line);
  EXPECT_EQ (
      line,
      "frame,object,plane,points,graspable,centroid_x_m,centroid_y_m,centroid_z_m,"
      "box_x_m,box_y_m,box_z_m,size_1_m,size_2_m,height_m,axis_1_x,axis_1_y,"
      "axis_1_z,up_x,up_y,up_z,truncated");
  std::size_t id = 0;
  for (; std::getline (lines, line); ++id) {
    const json& object = frame["objects"].at (id);
    std::vector<double> expected{static_cast<double> (id),
                                 object["plane"],
                                 object["points"],
                                 object["graspable"] ? 1. : 0.};
    for (const json& vector : {object["centroid_m"],
                               object["box_center_m"],
                               object["box_size_m"],
                               object["box_axes"][0],
                               object["box_axes"][2]})
      expected.insert (expected.end(), vector.begin(), vector.end());
    expected.push_back (object["truncated"] ? 1. : 0.);
    std::istringstream fields (line);
    std::string field;
    std::getline (fields, field, ',');
    EXPECT_EQ (field, "table_cluttered_1");
    for (const double value : expected) {
      ASSERT_TRUE (std::getline (fields, field, ','));
      EXPECT_NEAR (std::stod (field), value, 1e-5 * std::max (1., std::fabs (value)));
    }
    EXPECT_FALSE (std::getline (fields, field));
  }
  EXPECT_EQ (id, frame["objects"].size());
  EXPECT_GT (id, 20u);
}

TEST_F (SegmentPlanes, RefusesABadBaseTransform)
{
  expectRefused ("sim:table_single --base-transform 0,0,1.2,0,30",
                 "x,y,z,roll,pitch,yaw");
  expectRefused ("sim:table_single --base-transform 0,0,1.2,0,30,nan", "finite");
}

TEST_F (SegmentPlanes, CorrectsWithTheWarpOfAnEarlierRun)
{
  const auto planes = [&] (const std::string& file) {
    return json::parse (readFile (folder_ / file))["frames"][0]["planes"];
  };
  const Outcome learned =
      run ("sim:corridor:1:2 --corrected camera --output camera --obstacles");
  ASSERT_EQ (learned.code, 0) << learned.err;
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

TEST_F (SegmentPlanes, WarpsOfOddSizesFitAllResolutions)
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

TEST_F (SegmentPlanes, RefusesWhatIsNoWarpOfTheCamera)
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
