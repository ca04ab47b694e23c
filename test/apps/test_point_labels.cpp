// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "files.h"

#include <pcl/apps/frame_source.h>
#include <pcl/apps/organized_pcd.h>
#include <pcl/apps/plane_truth.h>
#include <pcl/segmentation/impl/label_runs.h>

#include <gtest/gtest.h>

#include <sstream>

using namespace pcl::rgbd_planes;

namespace {

/** Reads a 4 x 2 cloud of which each point has \a fields besides x, y and z. */
PointLabels
read (const std::string& fields, const std::vector<std::string>& values)
{
  const TemporaryFolder folder;
  std::string points;
  for (const auto& value : values)
    points += value + " 1 2 3\n";
  writeFile (folder / "cloud.pcd", asciiPcd (fields + " x y z", 4, 2, points));
  PointLabels labels;
  readOrganizedPcd (folder / "cloud.pcd", &labels);
  return labels;
}

std::vector<std::uint32_t>
numbers (const PointLabels& labels)
{
  std::vector<std::uint32_t> result;
  for (const auto& point : labels.points)
    result.push_back (point.label);
  return result;
}

} // namespace

TEST (PointLabels, ObjectsComeFromAFieldLabel)
{
  const PointLabels labels =
      read ("label", {"1", "9", "0", "20", "21", "30", "120", "5"});
  EXPECT_EQ (labels.kind, PointLabels::Kind::objects);
  EXPECT_EQ (labels.points.width, 4u);
  EXPECT_EQ (labels.points.height, 2u);
  EXPECT_EQ (numbers (labels),
             (std::vector<std::uint32_t>{1, 9, 0, 20, 21, 30, 120, 5}));
}

TEST (PointLabels, PlanesComeFromAFieldIntensity)
{
  const PointLabels labels =
      read ("intensity", {"3", "3", "3", "19", "19", "0", "0", "0"});
  EXPECT_EQ (labels.kind, PointLabels::Kind::planes);
  EXPECT_EQ (numbers (labels), (std::vector<std::uint32_t>{3, 3, 3, 19, 19, 0, 0, 0}));
}

TEST (PointLabels, OtherFieldsAreNone)
{
  const auto kind = [] (const std::string& fields,
                        const std::vector<std::string>& values) {
    const PointLabels labels = read (fields, values);
    EXPECT_EQ (labels.points.empty(), labels.kind == PointLabels::Kind::none);
    return labels.kind;
  };
  const auto none = PointLabels::Kind::none;
  const std::vector<std::string> same (8, "1"), ones (8, "1 1"), normals (8, "1 0 0 1");
  EXPECT_EQ (kind ("rgba", same), none);
  EXPECT_EQ (kind ("label", {"1", "1", "1", "10", "1", "1", "1", "1"}), none)
      << "no number of mOSD";
  EXPECT_EQ (kind ("label", std::vector<std::string> (8, "20")), none) << "no table";
  EXPECT_EQ (kind ("label normal_x normal_y normal_z", normals), none)
      << "the result of a segmentation";
  EXPECT_EQ (kind ("label intensity", ones), none) << "which of them?";
  EXPECT_EQ (kind ("intensity", same), none) << "one plane or no information?";
  EXPECT_EQ (kind ("intensity", {"1", "1", "1", "1", "1", "2.5", "3", "3"}), none);
  EXPECT_EQ (kind ("intensity", {"1", "1", "1", "1", "1", "-2", "3", "3"}), none);
  EXPECT_EQ (kind ("intensity", {"1", "1", "1", "1", "1", "nan", "3", "3"}), none);
  EXPECT_EQ (kind ("intensity", {"1", "2", "3", "4", "5", "6", "7", "8"}), none)
      << "brightness";
}

// Large areas of a grey image are equally bright, but do not lie on one plane.
TEST (PointLabels, BrightnessIsNoLabel)
{
  const TemporaryFolder folder;
  const auto kind = [&] (float step_m) {
    std::ostringstream
        points; // a wall with a step: its thirds are dark, bright and dark
    for (int v = 0; v < 30; ++v)
      for (int u = 0; u < 30; ++u)
        points << 0.01 * u << ' ' << 0.01 * v << ' ' << (u < 20 ? 1.f : 1.f + step_m)
               << (u >= 10 && u < 20 ? " 200\n" : " 40\n");
    writeFile (folder / "wall.pcd", asciiPcd ("x y z intensity", 30, 30, points.str()));
    PointLabels labels;
    readOrganizedPcd (folder / "wall.pcd", &labels);
    return labels.kind;
  };
  EXPECT_EQ (kind (0.f), PointLabels::Kind::planes);
  EXPECT_EQ (kind (0.3f), PointLabels::Kind::none);
}

TEST (PointLabels, PlanesAreFittedToTheirPoints)
{
  const TemporaryFolder folder;
  // 6 x 4 points: the left half on z = 2, the right one on x = 5, and one missing.
  std::ostringstream points;
  for (int v = 0; v < 4; ++v)
    for (int u = 0; u < 6; ++u)
      if (u < 3)
        points << u << ' ' << v << " 2 7\n";
      else
        points << "5 " << v << ' ' << (u == 5 && v == 3 ? "nan" : std::to_string (u))
               << " 4\n";
  writeFile (folder / "planes.pcd", asciiPcd ("x y z intensity", 6, 4, points.str()));
  InputOptions options;
  options.input = folder / "planes.pcd";
  const Frame frame = FrameSource (options).read (0);
  const auto planes = truePlanes (frame, 1);
  ASSERT_TRUE (planes.has_value());
  ASSERT_EQ (planes->coefficients.size(), 2u);
  ASSERT_EQ (planes->labels.size(), 24u);
  const std::uint32_t left = planes->labels[0], right = planes->labels[5];
  EXPECT_TRUE (
      planes->coefficients[left].isApprox (Eigen::Vector4f (0, 0, -1, 2), 1e-5f));
  EXPECT_TRUE (
      planes->coefficients[right].isApprox (Eigen::Vector4f (-1, 0, 0, 5), 1e-5f));
  for (std::size_t i = 0; i < 24; ++i)
    EXPECT_EQ (planes->labels[i], i % 6 < 3 ? left : right) << i;

  const auto every_second = truePlanes (frame, 2);
  ASSERT_TRUE (every_second.has_value());
  EXPECT_EQ (every_second->labels,
             (std::vector<std::uint32_t>{left, left, right, left, left, right}));
  EXPECT_EQ (minPlanePoints (frame, 500 * 500), 300u);
}

TEST (PointLabels, LabelsAreTakenEveryStepthPixelLikePoints)
{
  const TemporaryFolder folder;
  writeFile (folder / "objects.pcd",
             asciiPcd ("x y z label",
                       4,
                       4,
                       "1 1 1 1\n1 1 1 2\n1 1 1 3\n1 1 1 4\n1 1 1 5\n1 1 1 6\n"
                       "1 1 1 7\n1 1 1 8\n1 1 1 9\n1 1 1 20\n1 1 1 21\n1 1 1 22\n"
                       "1 1 1 23\n1 1 1 24\n1 1 1 25\n1 1 1 26\n"));
  InputOptions options;
  options.input = folder / "objects.pcd";
  options.step = 2;
  const Frame frame = FrameSource (options).read (0);
  EXPECT_EQ (frame.labels.kind, PointLabels::Kind::objects);
  EXPECT_EQ (numbers (frame.labels), (std::vector<std::uint32_t>{1, 3, 9, 21}));
  EXPECT_FALSE (truePlanes (frame, 1).has_value());
  EXPECT_EQ (minPlanePoints (frame, 320 * 240), 250u);
}
