// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_noise.h"
#include "random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using pcl::rgbd_planes::measurePlaneNoise;
using pcl::rgbd_planes::Random;

namespace {

constexpr int width = 320;
constexpr int height = 240;
constexpr float missing = std::numeric_limits<float>::quiet_NaN();

/** A tilted plane, seen by a pinhole camera: one over its depth is linear. */
float
planeDepth (int u, int v)
{
  return 1.f / (0.5f + 1e-4f * static_cast<float> (u) + 4e-4f * static_cast<float> (v));
}

template <typename Depth>
std::vector<float>
depthImage (const Depth& depth)
{
  std::vector<float> image;
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      image.push_back (depth (u, v));
  return image;
}

} // namespace

TEST (PlaneNoise, WhiteNoiseHasItsSizeAndNoCorrelation)
{
  Random random (1);
  const auto noise = measurePlaneNoise (
      depthImage ([&] (int u, int v) {
        return u < 20 ? missing : planeDepth (u, v) + 0.003f * random.normal();
      }),
      width);
  EXPECT_EQ (noise.points, std::size_t{(width - 20) * height});
  EXPECT_NEAR (noise.plane[0], 1e-4, 1e-6);
  EXPECT_NEAR (noise.plane[1], 4e-4, 1e-6);
  EXPECT_NEAR (noise.plane[2], 0.5, 1e-3);
  EXPECT_NEAR (noise.local_rms_m, 0.003, 0.003 * 0.02);
  EXPECT_NEAR (noise.global_rms_m, 0.003, 0.003 * 0.02);
  for (std::size_t i = 0; i < noise.lags.size(); ++i) {
    EXPECT_NEAR (noise.correlation_right[i], 0., 0.03);
    EXPECT_NEAR (noise.correlation_down[i], 0., 0.03);
  }
}

TEST (PlaneNoise, NoiseSharedByPairsOfColumnsCorrelatesByOneHalf)
{
  Random random (2);
  float last = 0.f;
  const auto noise = measurePlaneNoise (depthImage ([&] (int u, int v) {
                                          if (u % 2 == 0)
                                            last = 0.003f * random.normal();
                                          return planeDepth (u, v) + last;
                                        }),
                                        width);
  EXPECT_NEAR (noise.correlation_right[0], 0.5, 0.03);
  EXPECT_NEAR (noise.correlation_right[1], 0., 0.03);
  EXPECT_NEAR (noise.correlation_down[0], 0., 0.03);
}

TEST (PlaneNoise, ABendIsGlobalButNotLocal)
{
  // Of the variance 1/2 of whole periods of a sine, a line explains 12 / length^2.
  constexpr double length = 4. * 3.14159265;
  const auto noise = measurePlaneNoise (
      depthImage ([] (int u, int v) {
        const double phase = length * u / width;
        return planeDepth (u, v) + 0.01f * static_cast<float> (std::sin (phase));
      }),
      width);
  EXPECT_NEAR (
      noise.global_rms_m, 0.01 * std::sqrt (0.5 - 12. / (length * length)), 1e-4);
  EXPECT_LT (noise.local_rms_m, 0.001);
}

TEST (PlaneNoise, TheStepIsThatOfTheDisparity)
{
  constexpr float step = 0.0029f;
  const auto noise = measurePlaneNoise (
      depthImage ([&] (int u, int v) {
        return 1.f / (step * std::round (1.f / planeDepth (u, v) / step));
      }),
      width);
  EXPECT_NEAR (noise.step_m / (noise.depth_m * noise.depth_m), step, 1e-5);
  EXPECT_NEAR (noise.local_rms_m, noise.step_m / std::sqrt (12.), 0.1 * noise.step_m);
}

TEST (PlaneNoise, APlaneSmallerThanATileIsRefused)
{
  const auto image = depthImage (
      [] (int u, int v) { return u < 20 && v < 20 ? planeDepth (u, v) : missing; });
  EXPECT_THROW (measurePlaneNoise (image, width), std::invalid_argument);
}
