// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "point_sample.h"
#include <hwy/targets.h>

#include <pcl/segmentation/impl/ground_rectangle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace pcl::rgbd_planes;

TEST (TrimmedRange, EndsAreThoseOfSortedValues)
{
  std::mt19937 random (1);
  std::uniform_real_distribution<float> value (-1.f, 1.f);
  for (const bool is_baseline : {false, true}) {
    hwy::SetSupportedTargetsForTest (is_baseline ? HWY_STATIC_TARGET : 0);
    for (std::size_t size = 1; size <= max_points_of_thing; ++size) {
      std::vector<float> values (size);
      std::generate (values.begin(), values.end(), [&] {
        return size % 3 == 0 ? 0.25f : value (random);
      });
      const CoordinateRange range = trimmedRange (values);
      std::sort (values.begin(), values.end());
      const auto few =
          static_cast<std::size_t> (trimmed_part * static_cast<float> (size));
      EXPECT_EQ (range.low, values[few]) << size;
      EXPECT_EQ (range.high, values[size - 1 - few]) << size;
    }
  }
  hwy::SetSupportedTargetsForTest (0);
}
