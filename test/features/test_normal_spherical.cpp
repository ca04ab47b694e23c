// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/common/io.h>
#include <pcl/features/normal_spherical.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using Eigen::Vector3f;
using pcl::NormalSpherical;
using pcl::toSpherical;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float pi = 3.14159265f;

void
expectSpherical (const NormalSpherical& result, float r, float phi, float theta)
{
  EXPECT_NEAR (result.r, r, 1e-6f);
  EXPECT_NEAR (result.phi, phi, 1e-6f);
  EXPECT_NEAR (result.theta, theta, 1e-6f);
}

} // namespace

TEST (NormalSpherical, SurfacesOfARoomInTheBaseFrame)
{
  // x forward, y left, z up.
  expectSpherical (
      toSpherical ({2.f, 1.f, 0.75f}, {0.f, 0.f, 1.f}), -0.75f, 0.f, pi / 2.f); // table
  expectSpherical (toSpherical ({2.f, 1.f, 2.5f}, {0.f, 0.f, -1.f}),
                   2.5f,
                   0.f,
                   -pi / 2.f); // ceiling
  expectSpherical (
      toSpherical ({4.f, 1.f, 0.5f}, {-1.f, 0.f, 0.f}), 4.f, pi, 0.f); // wall ahead
  expectSpherical (toSpherical ({4.f, 3.f, 0.5f}, {0.f, -1.f, 0.f}),
                   3.f,
                   -pi / 2.f,
                   0.f); // left wall
  expectSpherical (toSpherical ({4.f, -2.f, 1.f}, {0.f, 1.f, 0.f}),
                   2.f,
                   pi / 2.f,
                   0.f); // right wall
}

TEST (NormalSpherical, ATiltedPlaneByHand)
{
  // cos (60 deg) = 0.5 of the normal is horizontal, at 45 deg between x and y.
  const Vector3f normal (
      0.5f * std::sqrt (0.5f), 0.5f * std::sqrt (0.5f), std::sqrt (0.75f));
  expectSpherical (toSpherical ({0.f, 0.f, 2.f}, normal),
                   -2.f * std::sqrt (0.75f),
                   pi / 4.f,
                   pi / 3.f);
}

TEST (NormalSpherical, PhiIsZeroAtThePolesWhateverTheSignOfZero)
{
  for (const float x : {0.f, -0.f})
    for (const float y : {0.f, -0.f})
      for (const float z : {1.f, -1.f})
        EXPECT_EQ (toSpherical ({1.f, 1.f, 1.f}, {x, y, z}).phi, 0.f);
  EXPECT_FLOAT_EQ (toSpherical ({1.f, 1.f, 1.f}, {-1.f, -0.f, 0.f}).phi, pi);
}

TEST (NormalSpherical, ThetaIsExactNearThePoles)
{
  const float tilt = 1e-5f; // the arc sine of z, 1 in floats, would say 0
  const NormalSpherical result = toSpherical ({0.f, 0.f, 1.f}, {tilt, 0.f, 1.f});
  EXPECT_NEAR (pi / 2.f - result.theta, tilt, 3e-7f);
}

TEST (NormalSpherical, RoundTrips)
{
  std::mt19937 generator (3);
  std::normal_distribution<float> gauss;
  for (int i = 0; i < 1000; ++i) {
    Vector3f normal (gauss (generator), gauss (generator), gauss (generator));
    normal.normalize();
    if (i < 6) // the axes, both ways
      normal = (i % 2 ? 1.f : -1.f) * Vector3f::Unit (i / 2);
    const Vector3f point (gauss (generator), gauss (generator), gauss (generator));
    const Eigen::Vector4f plane = pcl::toPlane (toSpherical (point, normal));
    EXPECT_LE ((plane.head<3>() - normal).norm(), 1e-6f);
    EXPECT_NEAR (plane.dot (point.homogeneous()), 0.f, 1e-5f) << "the point lies on it";
  }
}

TEST (NormalSpherical, AllOfACloud)
{
  pcl::PointCloud<pcl::PointXYZRGB> cloud (
      3, 2, pcl::PointXYZRGB (1.f, 2.f, 3.f, 0, 0, 0));
  pcl::PointCloud<pcl::Normal> normals (6, 1, pcl::Normal (0.f, 0.f, -1.f));
  cloud.header.frame_id = "base";
  cloud.sensor_origin_ = {1.f, 2.f, 3.f, 0.f};
  pcl::PointCloud<NormalSpherical> spherical;
  ASSERT_TRUE (pcl::computeNormalsSpherical (cloud, normals, spherical));
  EXPECT_TRUE (spherical.is_dense);
  ASSERT_EQ (spherical.width, 3u);
  ASSERT_EQ (spherical.height, 2u);
  EXPECT_EQ (spherical.header.frame_id, "base");
  EXPECT_EQ (spherical.sensor_origin_, cloud.sensor_origin_);
  for (const auto& point : spherical)
    expectSpherical (point, 3.f, 0.f, -pi / 2.f);

  cloud[1].y = not_a_number;
  cloud[2].getVector3fMap().setZero();
  normals[3].normal_x = not_a_number;
  normals[4].getNormalVector3fMap().setZero();
  normals[5].normal_z = std::numeric_limits<float>::infinity();
  ASSERT_TRUE (pcl::computeNormalsSpherical (cloud, normals, spherical));
  EXPECT_FALSE (spherical.is_dense);
  EXPECT_EQ (spherical[0].r, 3.f);
  for (std::size_t i = 1; i < 6; ++i) {
    EXPECT_TRUE (std::isnan (spherical[i].r)) << i;
    EXPECT_TRUE (std::isnan (spherical[i].phi)) << i;
    EXPECT_TRUE (std::isnan (spherical[i].theta)) << i;
  }
}

TEST (NormalSpherical, SizesThatDifferAreAnError)
{
  const pcl::PointCloud<pcl::PointXYZ> cloud (3, 2);
  const pcl::PointCloud<pcl::Normal> normals (5, 1);
  pcl::PointCloud<NormalSpherical> spherical (4, 4);
  EXPECT_FALSE (pcl::computeNormalsSpherical (cloud, normals, spherical));
  EXPECT_TRUE (spherical.empty());
  const pcl::PointCloud<pcl::Normal> upright (2, 3);
  EXPECT_FALSE (pcl::computeNormalsSpherical (cloud, upright, spherical));
  ASSERT_TRUE (pcl::computeNormalsSpherical (
      pcl::PointCloud<pcl::PointXYZ>(), pcl::PointCloud<pcl::Normal>(), spherical));
  EXPECT_TRUE (spherical.empty());
}

TEST (NormalSpherical, IsAPointTypeOfPcl)
{
  const pcl::PointCloud<NormalSpherical> cloud (2, 1);
  EXPECT_EQ (pcl::getFieldsList (cloud), "r phi theta");
  pcl::PointCloud<pcl::PointNormal> both (1, 1);
  both[0].getVector3fMap() = Vector3f (0.f, 0.f, 2.f);
  both[0].getNormalVector3fMap() = Vector3f (0.f, 0.f, -1.f);
  pcl::PointCloud<NormalSpherical> spherical;
  ASSERT_TRUE (pcl::computeNormalsSpherical (both, both, spherical));
  EXPECT_EQ (spherical[0].r, 2.f);
}
