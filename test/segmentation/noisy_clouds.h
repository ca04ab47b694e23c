// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "synthetic_clouds.h"

#include <pcl/segmentation/depth_noise_estimation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace noisy_clouds {

using pcl::rgbd_planes::DepthNoise;
using synthetic::Cloud;
using synthetic::Surface;

/** What a camera sees whose ranges have Gaussian noise. */
inline Cloud
renderNoisy (const std::vector<Surface>& surfaces,
             const DepthNoise& noise,
             int width = 640,
             int height = 480)
{
  Cloud cloud = *render (surfaces, width, height).cloud;
  std::mt19937 generator (1);
  std::normal_distribution<float> gauss;
  for (auto& point : cloud) {
    const float squares = point.getVector3fMap().squaredNorm();
    point.getVector3fMap() *=
        1.f + gauss (generator) * noise.sigmaAtSquare (squares) / std::sqrt (squares);
  }
  return cloud;
}

inline DepthNoise
estimate (const pcl::DepthNoiseEstimation& estimation)
{
  DepthNoise noise;
  EXPECT_TRUE (estimation.estimate (noise));
  return noise;
}

} // namespace noisy_clouds
