// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/depth_noise.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using pcl::rgbd_planes::DepthNoise;

namespace {

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
    EXPECT_GE (noise.sigma (z * z), published (z) - smaller) << z;
    EXPECT_LE (noise.sigma (z * z), published (z) + larger) << z;
  }
}

} // namespace

TEST (DepthNoise, TheDefaultIsAKinectOfTheFirstKind)
{
  for (const DepthNoise& noise : {DepthNoise(), DepthNoise::kinectV1()}) {
    EXPECT_EQ (noise.constant, 0.001f);
    EXPECT_EQ (noise.quadratic, 0.002f);
    EXPECT_EQ (noise.max_range, INFINITY);
    EXPECT_FLOAT_EQ (noise.sigma (9.f), 0.019f);
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
