// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "segment_planes_test.h"

#include <pcl/apps/pictures.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace pcl::rgbd_planes;
using nlohmann::json;

namespace {

class SegmentObjects : public SegmentPlanesTest {};

} // namespace

TEST_F (SegmentObjects, FindsTheObjectOfASimulatedTable)
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
             (plane == 1 ? points : 0) + 500)
      << "the hull";
  EXPECT_GT (pixels (planeColour (1)), points * 8 / 10) << "the object";
}

TEST_F (SegmentObjects, ListOfObjectsAndJsonSayTheSame)
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

TEST_F (SegmentObjects, RefusesABadBaseTransform)
{
  expectRefused ("sim:table_single --base-transform 0,0,1.2,0,30",
                 "x,y,z,roll,pitch,yaw");
  expectRefused ("sim:table_single --base-transform 0,0,1.2,0,30,nan", "finite");
}
