// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "segment_planes_test.h"
#include "synthetic_clouds.h"

#include <pcl/apps/labelled_point.h>
#include <pcl/apps/pictures.h>
#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/impl/plane_extraction.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <sstream>

using namespace pcl::rgbd_planes;
using nlohmann::json;

namespace {

class SegmentPlanes : public SegmentPlanesTest {};

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

TEST_F (SegmentPlanes, FrameWithoutDepthHasNoPlanes)
{
  writePng (folder_ / "dark.png", 160, std::vector<std::uint16_t> (160 * 120));
  const Outcome result = run ("dark.png --output out" + camera_);
  ASSERT_EQ (result.code, 0) << result.err;
  EXPECT_NE (result.out.find (" 0 points measured, 0.0 %"), std::string::npos);
  expectConsistent (folder_ / "out");
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
