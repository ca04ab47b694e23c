// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/impl/frame_noise.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

using pcl::rgbd_planes::DepthNoise;

namespace {

/** A tilted wall 1 to 3 m away, with \a factor times the noise of a Kinect; one point in
 * \a measured is measured. */
std::vector<float>
tiltedWall (int width, int height, float factor, int measured = 1)
{
  std::mt19937 random (1);
  std::normal_distribution<float> error;
  std::vector<float> points;
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const float x = static_cast<float> (2 * u - width) / static_cast<float> (width),
                  y = static_cast<float> (2 * v - height) / static_cast<float> (width);
      const float true_z = 1.5f / (1.f - 0.5f * x - 0.3f * y);
      const float range = true_z * std::sqrt (1.f + x * x + y * y);
      const float noise =
          factor * DepthNoise().sigmaAtSquare (range * range) * error (random);
      const float z = true_z * (1.f + noise / range);
      const bool is_measured = (u + v) % measured == 0;
      for (const float value : {x * z, y * z, z})
        points.push_back (is_measured ? value
                                      : std::numeric_limits<float>::quiet_NaN());
    }
  return points;
}

float
noiseOf (const std::vector<float>& points,
         int width,
         int height,
         const DepthNoise& noise)
{
  return noiseIn ({points.data(), 3, width, height}, {}, noise).sigmaAtSquare (1.f);
}

/** The preset is at most \a smaller below and \a larger above a published curve, in metres,
 * from 0.5 m to \a end. */
void
expectNear (const DepthNoise& noise,
            const std::function<float (float)>& published,
            float end,
            float smaller,
            float larger)
{
  for (float z = 0.5f; z <= end; z += 0.1f) {
    EXPECT_GE (noise.sigmaAtSquare (z * z), published (z) - smaller) << z;
    EXPECT_LE (noise.sigmaAtSquare (z * z), published (z) + larger) << z;
  }
}

} // namespace

TEST (DepthNoise, TheDefaultIsAKinectOfTheFirstKind)
{
  for (const DepthNoise& noise : {DepthNoise(), DepthNoise::kinectV1()}) {
    EXPECT_EQ (noise.constant, 0.001f);
    EXPECT_EQ (noise.quadratic, 0.002f);
    EXPECT_EQ (noise.max_range, INFINITY);
    EXPECT_FLOAT_EQ (noise.sigmaAtSquare (9.f), 0.019f);
  }
  // Nguyen et al. 2012, table of axial noise.
  expectNear (
      DepthNoise::kinectV1(),
      [] (float z) { return 0.0012f + 0.0019f * (z - 0.4f) * (z - 0.4f); },
      4.f,
      0.f,
      0.008f);
}

TEST (DepthNoise, PresetsFollowTheirPublications)
{
  // Khoshelham and Elberink 2012: 1.425e-5 z^2, in centimetres.
  expectNear (
      DepthNoise::structuredLight(),
      [] (float z) { return 1.425e-3f * z * z; },
      DepthNoise::structuredLight().max_range,
      0.f,
      0.0015f);
  // Fankhauser et al. 2015, at normal incidence.
  expectNear (
      DepthNoise::timeOfFlight(),
      [] (float z) { return 1e-3f * (1.5f - 0.5f * z + 0.3f * z * z); },
      4.5f,
      0.0004f,
      0.0004f);
  // Ahn et al. 2019.
  expectNear (
      DepthNoise::activeStereo(),
      [] (float z) { return 0.000611f + 0.003587f * (z - 0.3515f) * (z - 0.3515f); },
      4.f,
      0.f,
      0.0025f);
}

TEST (DepthNoise, PresetsEndWhereTheirSensorsDo)
{
  EXPECT_EQ (DepthNoise::structuredLight().max_range, 3.5f);
  EXPECT_EQ (DepthNoise::timeOfFlight().max_range, 5.5f);
  EXPECT_EQ (DepthNoise::activeStereo().max_range, 5.f);
}

TEST (DepthNoise, FramesMayHaveMoreThanTheLeast)
{
  const float usual = DepthNoise().sigmaAtSquare (1.f);
  for (const auto& [width, height] : {std::pair{640, 480}, {120, 160}}) {
    const std::vector<float> noisy = tiltedWall (width, height, 2.5f);
    EXPECT_NEAR (noiseOf (noisy, width, height, DepthNoise::kinectV1()),
                 2.5f * usual,
                 0.15f * usual);
    EXPECT_EQ (noiseOf (noisy, width, height, DepthNoise()), usual);
    const std::vector<float> precise = tiltedWall (width, height, 0.5f);
    EXPECT_EQ (noiseOf (precise, width, height, DepthNoise::kinectV1()), usual);
  }
  const std::vector<float> wall = tiltedWall (640, 480, 4.f);
  EXPECT_EQ (noiseIn ({wall.data(), 3, 640, 480}, {}, DepthNoise::activeStereo())
                 .normal_scatter,
             2.5f);
  // Its points spread farther, as it says.
  EXPECT_FALSE (DepthNoise::kinectV1Corrected().is_least);
}

/** A fence in front of a wall: most rectangles have a corner on a wire. */
TEST (DepthNoise, FineStructureIsHardlyTakenForNoise)
{
  std::vector<float> points = tiltedWall (640, 480, 1.f);
  for (int v = 0; v < 480; ++v)
    for (int u = 0; u < 640; ++u)
      if ((u + v) % 16 < 2 || (u - v + 480) % 16 < 2)
        std::for_each_n (
            &points[3 * (v * 640 + u)], 3, [] (float& value) { value *= 0.5f; });
  const float usual = DepthNoise().sigmaAtSquare (1.f);
  EXPECT_LE (noiseOf (points, 640, 480, DepthNoise::kinectV1()), 4.f * usual);
}

TEST (DepthNoise, MissingPointsSayNothingOfTheNoiseOfAFrame)
{
  const float usual = DepthNoise().sigmaAtSquare (1.f);
  for (const float missing : {0.f,
                              std::numeric_limits<float>::quiet_NaN(),
                              std::numeric_limits<float>::infinity()}) {
    std::vector<float> points = tiltedWall (640, 480, 2.5f);
    std::mt19937 random (1);
    for (std::size_t i = 0; i < points.size(); i += 3)
      if (random() % 3 == 0)
        std::fill_n (&points[i], 3, missing);
    EXPECT_NEAR (
        noiseOf (points, 640, 480, DepthNoise::kinectV1()), 2.5f * usual, 0.15f * usual)
        << missing;
  }
}

/** Where fewer than a hundred rectangles of the first choice had all their corners, the noise was
 * taken for the least: half of the pixels missing, every second column, a small cut, or a laser
 * scanner of few rows. */
TEST (DepthNoise, FewMeasuredPointsTellTheNoiseOfAFrame)
{
  const float usual = DepthNoise().sigmaAtSquare (1.f);
  const auto expectNoise = [&] (int width, int height, const auto& is_measured) {
    std::vector<float> points = tiltedWall (width, height, 2.5f);
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < width; ++u)
        if (!is_measured (u, v))
          std::fill_n (&points[3 * (v * width + u)], 3, 0.f);
    EXPECT_NEAR (noiseOf (points, width, height, DepthNoise::kinectV1()),
                 2.5f * usual,
                 0.5f * usual)
        << width << " x " << height;
  };
  std::mt19937 random (1);
  for (const auto& [width, height] : {std::pair{640, 480}, {320, 240}, {160, 120}}) {
    expectNoise (width, height, [&] (int, int) { return random() % 2 == 0; });
    expectNoise (width, height, [] (int u, int) { return u % 2 == 1; });
    expectNoise (width, height, [] (int, int v) { return v % 2 == 1; });
    expectNoise (width, height, [side = width / 4] (int u, int v) {
      return u < side && v < side;
    });
  }
  for (const int rows : {16, 32, 64})
    expectNoise (1024, rows, [] (int, int) { return true; });
}

TEST (DepthNoise, PointsThatAreNotSelectedSayNothingOfTheNoiseOfAFrame)
{
  std::vector<float> points = tiltedWall (640, 480, 0.5f);
  const std::vector<float> noisy = tiltedWall (640, 480, 9.f);
  std::vector<std::uint8_t> selected (640 * 480, 1);
  for (std::size_t i = 0; i < selected.size(); ++i)
    if (i % 640 > 200) {
      selected[i] = 0;
      std::copy_n (&noisy[3 * i], 3, &points[3 * i]);
    }
  const DepthNoise least = DepthNoise::kinectV1();
  const pcl::rgbd_planes::OrganizedPoints image{points.data(), 3, 640, 480};
  EXPECT_EQ (noiseIn (image, selected, least).sigmaAtSquare (1.f),
             least.sigmaAtSquare (1.f));
  EXPECT_GT (noiseIn (image, {}, least).sigmaAtSquare (1.f),
             3.f * least.sigmaAtSquare (1.f));
}

TEST (DepthNoise, PointsBeyondTheRangeSayNothingOfTheNoiseOfAFrame)
{
  const DepthNoise preset = DepthNoise::timeOfFlight();
  std::vector<float> points = tiltedWall (640, 480, 0.f);
  std::mt19937 random (1);
  std::uniform_real_distribution<float> factor (6.f, 7.f);
  for (std::size_t i = 0; i < points.size(); i += 3)
    if (i / 3 % 640 < 400) {
      const float far = factor (random);
      std::for_each_n (&points[i], 3, [far] (float& value) { value *= far; });
    }
  EXPECT_EQ (noiseOf (points, 640, 480, preset), preset.sigmaAtSquare (1.f));
}

TEST (DepthNoise, WhatSaysNothingOfNoiseLeavesTheLeast)
{
  const float usual = DepthNoise().sigmaAtSquare (1.f);
  const auto noiseOfWall = [] (int width, int height, int measured) {
    return noiseOf (tiltedWall (width, height, 5.f, measured),
                    width,
                    height,
                    DepthNoise::kinectV1());
  };
  EXPECT_EQ (noiseOfWall (0, 0, 1), usual);
  EXPECT_EQ (noiseOfWall (1, 1, 1), usual);
  EXPECT_EQ (noiseOfWall (1000, 1, 1), usual);
  EXPECT_EQ (noiseOfWall (10, 10, 1), usual);
  EXPECT_EQ (noiseOfWall (640, 480, 1000), usual);
  const std::vector<float> zeros (3 * 640 * 480, 0.f),
      huge (3 * 640 * 480, std::numeric_limits<float>::max());
  EXPECT_EQ (noiseOf (zeros, 640, 480, DepthNoise::kinectV1()), usual);
  EXPECT_EQ (noiseOf (huge, 640, 480, DepthNoise::kinectV1()), usual);
}
