// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "files.h"

#include <pcl/apps/pictures.h>
#include <pcl/segmentation/impl/plane_extraction.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace pcl::rgbd_planes;

namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();
const pcl::RGB black (0, 0, 0);
const pcl::RGB grey (128, 128, 128);

/** CIE 1976 L*a*b* of an sRGB colour, white point D65. */
Eigen::Vector3d
toLab (const pcl::RGB& colour)
{
  const auto linear = [] (std::uint8_t channel) {
    const double c = channel / 255.;
    return c <= 0.04045 ? c / 12.92 : std::pow ((c + 0.055) / 1.055, 2.4);
  };
  const Eigen::Vector3d rgb (linear (colour.r), linear (colour.g), linear (colour.b));
  Eigen::Matrix3d to_xyz;
  to_xyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
  const Eigen::Vector3d xyz =
      (to_xyz * rgb).cwiseQuotient (Eigen::Vector3d (0.9505, 1., 1.089));
  const Eigen::Vector3d f = xyz.unaryExpr ([] (double t) {
    return t > 216. / 24389. ? std::cbrt (t) : (24389. / 27. * t + 16.) / 116.;
  });
  return {116. * f.y() - 16., 500. * (f.x() - f.y()), 200. * (f.y() - f.z())};
}

double
difference (const pcl::RGB& a, const pcl::RGB& b)
{
  return (toLab (a) - toLab (b)).norm();
}

bool
same (const pcl::RGB& a, const pcl::RGB& b)
{
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

} // namespace

// A difference of 10 is said to be seen at a glance.
TEST (Pictures, ColoursOfTheFirst20PlanesDiffer)
{
  for (std::uint32_t i = 0; i < 20; ++i) {
    EXPECT_GT (difference (planeColour (i), black), 20.) << i;
    EXPECT_GT (difference (planeColour (i), grey), 20.) << i;
    for (std::uint32_t j = 0; j < i; ++j)
      EXPECT_GT (difference (planeColour (i), planeColour (j)), 10.) << i << ", " << j;
  }
}

TEST (Pictures, NoPlaneLooksLikeNone)
{
  for (std::uint32_t i = 0; i < 1000; ++i) {
    EXPECT_GT (difference (planeColour (i), black), 20.) << i;
    EXPECT_GT (difference (planeColour (i), grey), 20.) << i;
  }
}

TEST (Pictures, PlanesAreColouredMissingBlackOthersGrey)
{
  pcl::PointCloud<pcl::PointXYZRGB> cloud (2, 2);
  pcl::PointCloud<pcl::Label> labels (2, 2);
  for (auto& point : cloud)
    point.x = point.y = point.z = 1.f;
  cloud[1].x = cloud[1].y = cloud[1].z = missing;
  labels[0].label = 3;
  labels[1].label = labels[2].label = unlabelled;
  labels[3].label = 0;
  const Picture picture = planesPicture (cloud, labels);
  EXPECT_TRUE (same (picture[0], planeColour (3)));
  EXPECT_TRUE (same (picture[1], black));
  EXPECT_TRUE (same (picture[2], grey));
  EXPECT_TRUE (same (picture[3], planeColour (0)));
}

TEST (Pictures, NormalsBecomeColours)
{
  pcl::PointCloud<pcl::Normal> normals (2, 2);
  normals[0] = pcl::Normal (1.f, 0.f, 0.f);
  normals[1] = pcl::Normal (0.f, 0.f, -1.f);
  normals[2] = pcl::Normal (missing, missing, missing);
  normals[3] = pcl::Normal (0.28f, -0.96f, 0.f);
  const Picture picture = normalsPicture (normals);
  EXPECT_TRUE (same (picture[0], {255, 128, 128}));
  EXPECT_TRUE (same (picture[1], {128, 128, 0}));
  EXPECT_TRUE (same (picture[2], black));
  EXPECT_TRUE (same (picture[3], {163, 5, 128})); // 127.5 * 1.28, 127.5 * 0.04
}

TEST (Pictures, DepthGetsDarkerWithRange)
{
  pcl::PointCloud<pcl::PointXYZRGB> cloud (100, 2);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    cloud[i].z = 1.f + 0.01f * static_cast<float> (i);
  cloud[50].z = missing;
  const Picture picture = depthPicture (cloud);
  EXPECT_TRUE (same (picture[50], black));
  double last = 101.;
  for (std::size_t i = 0; i < cloud.size(); i += 10)
    if (i != 50) {
      const double lightness = toLab (picture[i]).x();
      EXPECT_LT (lightness, last) << i;
      EXPECT_GT (difference (picture[i], black), 20.) << i;
      last = lightness;
    }
  for (auto& point : cloud)
    point.z = missing;
  EXPECT_TRUE (same (depthPicture (cloud)[0], black));
  for (auto& point : cloud)
    point.z = 2.f;
  EXPECT_FALSE (same (depthPicture (cloud)[0], black));
}

TEST (Pictures, PngHoldsThePixels)
{
  Picture picture (5, 3);
  for (std::size_t i = 0; i < picture.size(); ++i)
    picture[i] = pcl::RGB (static_cast<std::uint8_t> (i),
                           static_cast<std::uint8_t> (100 + i),
                           static_cast<std::uint8_t> (255 - i));
  const TemporaryFolder folder;
  writeFile (folder / "picture.png", encodePng (picture));
  const RgbImage image = readRgbPng (folder / "picture.png");
  ASSERT_EQ (image.width, 5u);
  ASSERT_EQ (image.height, 3u);
  for (std::size_t i = 0; i < picture.size(); ++i)
    EXPECT_TRUE (same (
        picture[i],
        {image.samples[3 * i], image.samples[3 * i + 1], image.samples[3 * i + 2]}))
        << i;
}

TEST (Pictures, WarpIsRedWhereDepthIsTooSmall)
{
  pcl::PointCloud<pcl::Intensity> warp (5, 1);
  const float values[] = {0.f, 0.005f, -0.005f, 1.f, -1.f};
  for (std::size_t i = 0; i < 5; ++i)
    warp[i].intensity = values[i];
  const Picture picture = warpPicture (warp);
  ASSERT_EQ (picture.width, 5u);
  const int expected[][3] = {
      {255, 255, 255}, {255, 127, 127}, {127, 127, 255}, {255, 0, 0}, {0, 0, 255}};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ (picture[i].r, expected[i][0]) << i;
    EXPECT_EQ (picture[i].g, expected[i][1]) << i;
    EXPECT_EQ (picture[i].b, expected[i][2]) << i;
  }
}
