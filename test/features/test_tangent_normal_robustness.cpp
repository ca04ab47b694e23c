// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "tangent_images.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <string>

using namespace tangent_images;

namespace {

std::vector<TangentNormalParameters>
allModes ()
{
  std::vector<TangentNormalParameters> modes (4);
  modes[0].edge_aware = false;
  modes[1].depth_dependent_smoothing = true;
  modes[2].scale_selection = true;
  return modes;
}

/** For pixels and for cells of four. */
std::vector<Image>
images ()
{
  return {Image (37, 23), Image (481, 97)};
}

/** \return how many points have a normal; all others must be NaN */
int
expectUnitLengthOrNan (const ImageNormals& normals, const std::string& name)
{
  int valid = 0;
  for (const Eigen::Vector4f& n : normals) {
    const bool is_nan = n.array().isNaN().all();
    const bool is_normal = std::abs (n.head<3>().norm() - 1.f) <= 1e-4f &&
                           n[3] >= 0.f && n[3] <= 1.f / 3.f;
    EXPECT_TRUE (is_nan || is_normal) << name << ": " << n.transpose();
    valid += is_normal;
  }
  return valid;
}

/** In all modes together. */
int
expectUnitLengthOrNan (const Image& image, const std::string& name)
{
  int valid = 0;
  for (const auto& mode : allModes())
    valid += expectUnitLengthOrNan (compute (image, mode), name);
  return valid;
}

} // namespace

TEST (TangentNormalRobustness, EqualPointsSpanNoSurface)
{
  for (Image image : images()) {
    for (auto& p : image.points)
      p = {0.1f, 0.2f, 1.f};
    EXPECT_EQ (expectUnitLengthOrNan (image, "equal"), 0);
  }
}

TEST (TangentNormalRobustness, PointsOnALineSpanNoSurface)
{
  for (Image image : images()) {
    for (int v = 0; v < image.height; ++v)
      for (int u = 0; u < image.width; ++u)
        // Exact in floats, in steps of 1/1024 and 1/512.
        image (u, v) = {static_cast<float> (u + v) / 1024.f, 0.5f, 1.f};
    EXPECT_EQ (expectUnitLengthOrNan (image, "along x"), 0);
    for (auto& p : image.points)
      p.z() += p.x();
    EXPECT_EQ (expectUnitLengthOrNan (image, "oblique"), 0);
    for (auto& p : image.points)
      p *= p.z() / 3.f;
    expectUnitLengthOrNan (image, "bent");
  }
}

TEST (TangentNormalRobustness, AnyMagnitudeIsSafe)
{
  for (const float unit : {1e-45f, 1e-42f, 1e-38f, 1e-30f, 1e-20f, 1e-15f, 1e-12f,
                           1e-9f,  1e-6f,  1e-4f,  1e-3f,  1e-2f,  1e2f,   1e3f,
                           1e6f,   1e9f,   1e14f,  1e15f,  1e18f,  1e30f,  1e38f})
    for (const auto& size : images()) {
      const Image image = roughImage (size.width, size.height, 3, unit);
      expectUnitLengthOrNan (image, "unit " + std::to_string (unit));
    }
}

TEST (TangentNormalRobustness, AnyNoiseIsSafe)
{
  const pcl::rgbd_planes::DepthNoise noises[] = {
      {0.f, 1e-45f}, {1e-45f, 0.f}, {0.f, 3e38f}, {3e38f, 0.f}, {1e38f, 1e38f}};
  for (const float unit : {1e-12f, 1e-3f, 1.f, 1e3f, 1e14f})
    for (const auto& size : images())
      for (const auto& noise : noises) {
        const Image image = roughImage (size.width, size.height, 3, unit);
        for (auto mode : allModes()) {
          mode.noise = noise;
          expectUnitLengthOrNan (compute (image, mode),
                                 "unit " + std::to_string (unit) + ", noise " +
                                     std::to_string (noise.constant) + ", " +
                                     std::to_string (noise.quadratic));
        }
      }
}

/** A cloud in millimetres, and objects of millimetres. */
TEST (TangentNormalRobustness, OtherUnitsAndTinyObjects)
{
  const Eigen::Vector3f truth = Eigen::Vector3f (0.3f, 0.2f, -1.f).normalized();
  for (const float unit : {1000.f, 0.01f, 0.001f})
    for (Image image : images()) {
      for (int v = 0; v < image.height; ++v)
        for (int u = 0; u < image.width; ++u) {
          const Eigen::Vector3f r = ray (image, u, v);
          image (u, v) = unit * truth.z() / truth.dot (r) * r;
        }
      EXPECT_EQ (expectUnitLengthOrNan (image, "plane"), 4 * image.width * image.height)
          << "unit " << unit;
      for (const auto& mode : allModes())
        for (const Eigen::Vector4f& n : compute (image, mode))
          ASSERT_LE ((n.head<3>() - truth).norm(), 2e-3f) << "unit " << unit;
    }
}

/** The viewpoint may be anywhere, also next to a point: tangents there are many times as
 * long as the range, by which they are divided. (On which side of the plane it lies is beyond
 * the precision of coordinates at 1e-6 m.) */
TEST (TangentNormalRobustness, ViewpointNextToASurface)
{
  const Eigen::Vector3f truth = Eigen::Vector3f (0.4f, 0.3f, -1.f).normalized();
  for (const float distance : {0.1f, 1e-3f, 1e-4f, 1e-5f})
    for (Image image : images()) {
      for (int v = 0; v < image.height; ++v)
        for (int u = 0; u < image.width; ++u) {
          const float x = 0.002f * static_cast<float> (u);
          const float y = 0.002f * static_cast<float> (v);
          image (u, v) = {x, y, 0.5f + 0.4f * x + 0.3f * y};
        }
      const Eigen::Vector3f viewpoint = image (18, 4) + distance * truth;
      TangentNormalParameters mode;
      mode.sensor_origin = {{viewpoint.x(), viewpoint.y(), viewpoint.z()}};
      const ImageNormals normals = compute (image, mode);
      const auto off =
          std::count_if (normals.begin(), normals.end(), [&] (const auto& n) {
            return !((n.template head<3>() - truth).norm() <= 2e-3f);
          });
      EXPECT_EQ (off, 0) << "of " << normals.size() << " normals, viewpoint "
                         << distance << " m off the plane";
    }
}

/** Some points of a good image are somewhere else. */
TEST (TangentNormalRobustness, WildPointsAmongOthers)
{
  const float wild[] = {1e-40f, 1e-20f, 1e-4f, 1e4f, 1e14f, 1e20f, 1e38f};
  for (const auto& size : images()) {
    Image image = roughImage (size.width, size.height, 4);
    std::mt19937 generator (4);
    for (auto& p : image.points)
      if (generator() % 9 == 0)
        p[static_cast<int> (generator() % 3)] = wild[generator() % 7];
      else if (generator() % 20 == 0)
        p *= wild[generator() % 7];
    EXPECT_GT (expectUnitLengthOrNan (image, "wild"), 0);
  }
}

TEST (TangentNormalRobustness, SameBitsForAnyNumberOfBands)
{
  // Bands have at least 16 rows of cells.
  for (const auto& image : {roughImage (67, 100, 5), roughImage (483, 181, 5)})
    for (auto mode : allModes()) {
      const ImageNormals one = compute (image, mode);
      for (const unsigned threads : {2u, 3u, 4u, 5u, 64u}) {
        mode.threads = threads;
        const ImageNormals normals = compute (image, mode);
        EXPECT_EQ (std::memcmp (one.data(),
                                normals.data(),
                                one.size() * sizeof (Eigen::Vector4f)),
                   0)
            << image.width << " columns, " << threads << " threads";
      }
    }
}

TEST (TangentNormalRobustness, FramesLeaveNothingBehind)
{
  // Rows of these widths are filled up to the same lengths.
  const Image images[] = {roughImage (160, 60, 1),
                          roughImage (151, 60, 2),
                          roughImage (160, 47, 3),
                          roughImage (640, 96, 4),
                          roughImage (627, 96, 5)};
  for (const auto& mode : allModes()) {
    pcl::rgbd_planes::TangentNormals used;
    for (const Image& image : images) {
      const ImageNormals normals = compute (used, image, mode),
                         first = compute (image, mode);
      EXPECT_EQ (std::memcmp (normals.data(),
                              first.data(),
                              first.size() * sizeof (Eigen::Vector4f)),
                 0)
          << image.width << " x " << image.height;
    }
  }
}
