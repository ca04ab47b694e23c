// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "tangent_images.h"
#include <hwy/targets.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <string>

using namespace tangent_images;

namespace {

/** What the library falls back to where it knows no better instructions: scalar ones, or those
 * that every processor of this kind has. */
constexpr std::int64_t fallback = HWY_STATIC_TARGET;

enum class Mode { plain, edge_aware, by_depth, scales };

ImageNormals
computeWith (std::int64_t target,
             const Image& image,
             Mode mode,
             const pcl::rgbd_planes::DepthNoise& noise = {})
{
  TangentNormalParameters parameters;
  parameters.edge_aware = mode != Mode::plain;
  parameters.depth_dependent_smoothing = mode == Mode::by_depth;
  parameters.scale_selection = mode == Mode::scales;
  parameters.noise = noise;
  hwy::SetSupportedTargetsForTest (target);
  ImageNormals normals = compute (image, parameters);
  hwy::SetSupportedTargetsForTest (0);
  return normals;
}

/** The share of points with a normal or a curvature that is off by more than 1e-4, or missing
 * on one side. */
double
shareOfDifferences (const ImageNormals& normals, const ImageNormals& expected)
{
  std::size_t differ = 0;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Eigen::Vector4f &n = normals[i], &m = expected[i];
    const bool both_missing = n.array().isNaN().all() && m.array().isNaN().all();
    differ += !both_missing && !((n - m).array().abs() <= 1e-4f).all();
  }
  return static_cast<double> (differ) / static_cast<double> (normals.size());
}

/** As computeWith, in plain mode, into normals of eight floats; what is to be 0 must be. */
ImageNormals
computePadded (std::int64_t target, const Image& image)
{
  TangentNormalParameters parameters;
  parameters.edge_aware = false;
  std::vector<std::array<float, 8>> padded (image.points.size());
  for (auto& normal : padded)
    normal.fill (7.f);
  hwy::SetSupportedTargetsForTest (target);
  pcl::rgbd_planes::TangentNormals().compute (
      {image.points[0].data(), 3, image.width, image.height},
      parameters,
      {padded[0].data(), padded[0].data() + 4, 8, true});
  hwy::SetSupportedTargetsForTest (0);
  ImageNormals normals;
  for (const auto& n : padded) {
    normals.emplace_back (n[0], n[1], n[2], n[4]);
    // 7 where it was not touched.
    for (const float padding : {n[3], n[5], n[6], n[7]})
      EXPECT_TRUE (padding == 0.f || padding == 7.f) << padding;
  }
  return normals;
}

/** The share of points that may differ in each mode, 0 where nothing is said. */
using Shares = std::map<Mode, double>;

/** Every set of instructions gives the normals of the fallback. */
void
expectSameNormals (const Image& image,
                   const std::string& name,
                   const Shares& shares = {},
                   const pcl::rgbd_planes::DepthNoise& noise = {})
{
  for (const Mode mode :
       {Mode::plain, Mode::edge_aware, Mode::by_depth, Mode::scales}) {
    const auto share = shares.find (mode);
    const ImageNormals expected = computeWith (fallback, image, mode, noise);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
      EXPECT_LE (
          shareOfDifferences (computeWith (target, image, mode, noise), expected),
          share != shares.end() ? share->second : 0.)
          << name << ", mode " << static_cast<int> (mode) << ", "
          << hwy::TargetName (target);
  }
}

/** A room with a floor, a wall and a box, as a Kinect measures it: disparities in eighths
 * of a pixel with noise, and nothing behind edges. */
Image
kinectImage (int width, int height)
{
  Image image (width, height);
  std::mt19937 generator (9);
  std::normal_distribution<float> gauss;
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const Eigen::Vector3f r = ray (image, u, v);
      const bool is_box = std::abs (r.x() + 0.1f) < 0.15f && r.y() > 0.f;
      const float floor = r.y() > 0.f ? 0.9f / r.y() : 20.f;
      const float depth = is_box ? 1.1f / (1.f + r.x()) : std::min (floor, 4.f - r.x());
      const float disparity = 0.075f * 580.f / depth + 0.1f * gauss (generator);
      const bool is_shadow = std::abs (r.x() - 0.06f) < 0.01f && r.y() > 0.f;
      image (u, v) = is_shadow ? Eigen::Vector3f::Constant (std::nanf (""))
                               : Eigen::Vector3f (0.075f * 580.f * 8.f /
                                                  std::round (disparity * 8.f) * r);
    }
  return image;
}

} // namespace

TEST (VectorInstructions, FallbackIsAmongThem)
{
  const auto targets = hwy::SupportedAndGeneratedTargets();
  EXPECT_NE (std::find (targets.begin(), targets.end(), fallback), targets.end());
  for (const std::int64_t target : targets)
    std::printf ("%s\n", hwy::TargetName (target));
}

TEST (VectorInstructions, OddSizes)
{
  for (int width = 1; width <= 67; width += width < 20 ? 1 : 11)
    for (const int height : {1, 2, 3, 8, 31, 67})
      expectSameNormals (roughImage (width, height, 7),
                         std::to_string (width) + " x " + std::to_string (height));
}

/** Normals of whole rows are written in vectors where they are eight floats each. */
TEST (VectorInstructions, PaddedNormals)
{
  for (const int width : {16, 33, 64, 160, 480, 500, 512}) {
    const Image image = roughImage (width, 96, 13);
    const ImageNormals expected = computeWith (fallback, image, Mode::plain);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
      EXPECT_EQ (shareOfDifferences (computePadded (target, image), expected), 0.)
          << width << ", " << hwy::TargetName (target);
  }
}

TEST (VectorInstructions, CellsOfFourPixels)
{
  expectSameNormals (roughImage (481, 97, 8), "481 x 97");
  expectSameNormals (roughImage (500, 96, 9), "500 x 96");
}

/** With several sizes to choose from, a point between two of them may get either: rounding
 * decides, and the means around it follow. */
TEST (VectorInstructions, KinectAtTwoResolutions)
{
  expectSameNormals (kinectImage (640, 120), "640 x 120", {{Mode::scales, 0.0005}});
  expectSameNormals (kinectImage (320, 120), "320 x 120", {{Mode::scales, 0.0005}});
}

TEST (VectorInstructions, TinyAndHugeCoordinates)
{
  for (const float unit : {1e-12f, 1e-3f, 0.03f, 30.f, 1e4f, 1e12f}) {
    expectSameNormals (roughImage (67, 41, 10, unit), "unit " + std::to_string (unit));
    expectSameNormals (roughImage (481, 96, 11, unit), "unit " + std::to_string (unit));
  }
}

/** Tangents then span all steps, as those of points at random. */
TEST (VectorInstructions, HugeNoise)
{
  const Shares shares{
      {Mode::edge_aware, 0.01}, {Mode::by_depth, 0.01}, {Mode::scales, 0.01}};
  const pcl::rgbd_planes::DepthNoise noises[] = {
      {0.f, 3e38f}, {3e38f, 0.f}, {1e38f, 1e38f}};
  for (const float unit : {1e-2f, 1.f, 1e12f})
    for (const auto& noise : noises) {
      const std::string name = "unit " + std::to_string (unit) + ", noise " +
                               std::to_string (noise.constant) + ", " +
                               std::to_string (noise.quadratic);
      for (const Image& image :
           {roughImage (67, 41, 10, unit), roughImage (481, 96, 11, unit)})
        expectSameNormals (image, name, shares, noise);
    }
}

/** Neighbours anywhere, no surface at all. Means of planes in all directions may nearly
 * cancel out, which leaves their rounding: the share of points that differ by more than d
 * falls as 1 / d, so that differences of three roundings, 3.6e-7, leave 0.36 % of the points
 * with more than 1e-4. Tangents that are nearly parallel do so far less often. */
TEST (VectorInstructions, PointsAtRandom)
{
  std::mt19937 generator (12);
  std::uniform_real_distribution<float> random (-1.f, 1.f);
  for (const float size : {0.001f, 0.1f, 1.f, 10.f}) {
    Image image (320, 240);
    for (auto& p : image.points)
      p = size *
          Eigen::Vector3f (random (generator), random (generator), random (generator));
    expectSameNormals (image,
                       "at random, " + std::to_string (size),
                       {{Mode::plain, 0.0001},
                        {Mode::edge_aware, 0.0036},
                        {Mode::by_depth, 0.0036},
                        {Mode::scales, 0.0036}});
  }
}
