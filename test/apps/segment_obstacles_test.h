// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "app_test.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <sstream>
#include <string>
#include <vector>

namespace obstacle_outputs {

using Rows = std::vector<std::vector<std::string>>;

inline Rows
readCsv (const std::filesystem::path& file, const std::string& header)
{
  std::istringstream lines (readFile (file));
  std::string line;
  std::getline (lines, line);
  EXPECT_EQ (line, header);
  Rows rows;
  while (std::getline (lines, line)) {
    rows.emplace_back();
    std::istringstream fields (line);
    for (std::string field; std::getline (fields, field, ',');)
      rows.back().push_back (field);
  }
  return rows;
}

inline Rows
readObstacles (const std::filesystem::path& file)
{
  return readCsv (file,
                  "frame,obstacle,kind,points,distance_m,direction_rad,nearest_x_m,"
                  "nearest_y_m,nearest_z_m,centroid_x_m,centroid_y_m,centroid_z_m,"
                  "min_height_m,max_height_m");
}

/** What the colours of a picture of obstacles mean. */
enum class Meaning { unmeasured, floor, obstacle, drop_off, speck, nothing };

inline Meaning
meaningOf (const RgbImage& picture, std::size_t pixel)
{
  const std::uint8_t* colour = &picture.samples[3 * pixel];
  const int r = colour[0], g = colour[1], b = colour[2];
  return r == 0 && g == 0 && b == 0         ? Meaning::unmeasured
         : r == 255 && g == 255 && b == 255 ? Meaning::speck
         : g > r && g > b                   ? Meaning::floor
         : r > g && b == 0                  ? Meaning::obstacle
         : b > g && b > r                   ? Meaning::drop_off
                                            : Meaning::nothing;
}

/** The share of the pixels of which \a is_part is true that mean what is expected. */
template <typename IsPart>
double
share (const RgbImage& picture, Meaning expected, const IsPart& is_part)
{
  std::size_t part = 0, right = 0;
  for (std::size_t i = 0; i < picture.samples.size() / 3; ++i)
    if (is_part (i)) {
      ++part;
      right += meaningOf (picture, i) == expected;
    }
  EXPECT_GT (part, 0u);
  return static_cast<double> (right) / static_cast<double> (part);
}

} // namespace obstacle_outputs

/** A test that runs pcl_segment_planes. */
class SegmentObstaclesTest : public AppTest {
protected:
  SegmentObstaclesTest() : AppTest (SEGMENT_PLANES) {}

  nlohmann::json
  readFrame (const std::string& folder) const
  {
    return nlohmann::json::parse (
        readFile (folder_ / (folder + "/result.json")))["frames"][0];
  }
};
