// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "link_kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

using namespace pcl::rgbd_planes;

/** The kernel and LinkLimit::allows() are one rule. */
TEST (LinkKernels, RowsAreLinkedAsSinglePointsAre)
{
  std::mt19937 random (1);
  const auto between = [&random] (float low, float high) {
    return std::uniform_real_distribution<float> (low, high) (random);
  };
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  std::size_t links = 0, all = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const int width = 1 + static_cast<int> (random() % 70);
    const float range = between (0.3f, 4.f), step = between (0.f, 0.02f) * range;
    std::vector<float> xyz;
    for (int v = 0; v < 2; ++v)
      for (int u = 0; u < width; ++u) {
        const bool is_missing = random() % 8 == 0;
        const float z = is_missing ? nan : range + between (-step, step);
        const auto at = [z] (int pixel, int of) {
          return z * static_cast<float> (2 * pixel - of) / 1050.f;
        };
        xyz.insert (xyz.end(), {at (u, width), at (v + trial, 100), z, 1.f});
      }
    const OrganizedPoints points{xyz.data(), 4, width, 2};
    LinkLimit limit;
    limit.slope = between (0.f, 0.01f);
    limit.sigmas = between (0.f, 4.f);
    limit.known_slope = between (0.f, 0.006f);
    if (trial % 4 > 0)
      limit.up = Eigen::Vector3f (between (-0.3f, 0.3f), -1.f, between (-1.f, 1.f))
                     .normalized();
    PointRow above, row;
    above.load (points, 0);
    row.load (points, 1);
    const std::vector<std::uint8_t> blocks (row.blocks(), 1);
    std::vector<std::uint8_t> to_left (row.size()), to_above (row.size());
    linkRow (row, above, limit, blocks.data(), to_left.data(), to_above.data());
    for (std::size_t u = 0; u < static_cast<std::size_t> (width); ++u) {
      const std::size_t i = static_cast<std::size_t> (width) + u;
      const bool is_close_above = limit.allows (points[i], points[u]);
      EXPECT_EQ (to_above[u] != 0, is_close_above) << trial << ' ' << u;
      links += is_close_above;
      ++all;
      if (u > 0) {
        EXPECT_EQ (to_left[u] != 0, limit.allows (points[i], points[i - 1]))
            << trial << ' ' << u;
      }
    }
  }
  EXPECT_GT (links, all / 10);
  EXPECT_LT (links, all / 10 * 9);
}
