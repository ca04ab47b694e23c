// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "noisy_clouds.h"

#include <gtest/gtest.h>

using namespace noisy_clouds;
using pcl::DepthNoiseEstimation;
using synthetic::tiltedPlane;

// No part is negative: neither makes up for the other.
TEST (DepthNoiseEstimation, NoiseThatGrowsFasterThanSquaresOrFallsHasOnePart)
{
  const auto wallsWith = [] (float at_1m, float at_2m) {
    DepthNoiseEstimation estimation;
    estimation.addFrame (renderNoisy ({tiltedPlane (1.f, 0.f, 0.f)}, {at_1m, 0.f}));
    estimation.addFrame (renderNoisy ({tiltedPlane (2.f, 0.f, 0.f)}, {at_2m, 0.f}));
    return estimate (estimation);
  };
  // Least squares of relative errors of 1 and 8 mm, and of 4 and 1 mm.
  EXPECT_NEAR (wallsWith (0.001f, 0.008f).quadratic, 2.f * 0.0012f, 0.0006f);
  EXPECT_NEAR (wallsWith (0.004f, 0.001f).constant, 2.f * 0.0012f, 0.0006f);
}

TEST (DepthNoiseEstimation, Beyond100MetresUnitsAreOthers)
{
  Cloud cloud = renderNoisy ({tiltedPlane (2.f, 0.f, 10.f)}, {0.001f, 0.002f});
  for (auto& point : cloud)
    point.getVector3fMap() *= 1000.f; // millimetres
  DepthNoiseEstimation estimation;
  EXPECT_TRUE (estimation.addFrame (cloud));
  EXPECT_TRUE (estimation.getLevels().empty());
}
