// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "table_objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

using namespace table_objects;

namespace {

/** As a segmentation of connected parts has it: a plane in two, left and right of y = 0 in the
 * base frame. */
void
cutInTwo (View& view, std::size_t plane)
{
  const auto& cloud = *view.cloud;
  auto& left = view.inliers[plane].indices;
  const auto right = std::stable_partition (left.begin(), left.end(), [&] (auto i) {
    return (view.camera_to_base * cloud[i].getVector3fMap()).y() > 0.f;
  });
  pcl::PointIndices other;
  other.indices.assign (right, left.end());
  left.erase (right, left.end());
  view.inliers.push_back (other);
  view.models.push_back (view.models[plane]);
}

} // namespace

TEST (ObjectBases, BesideAHigherTable)
{
  for (const float gap : {0.002f, 0.01f, 0.02f})
    for (const float step : {0.02f, 0.1f}) {
      const Box low{{1.2f, 0.3f, 0.66f}, {0.8f, 0.6f, 0.04f}};
      const Box high{{1.2f, -0.3f, 0.66f}, {0.8f, 0.6f, 0.04f + step}};
      const Box thing = onTable (1.1f, gap + 0.04f, {0.08f, 0.08f, 0.2f});
      const View view = look ({floor_slab, low, high, thing});
      const Objects objects = extract (view);
      ASSERT_EQ (objects.size(), 1u) << gap << " " << step;
      EXPECT_EQ (objects.front().support, view.top.at (1)) << gap << " " << step;
      EXPECT_NEAR (objects.front().box_size.z(), 0.2f, 0.01f) << gap << " " << step;
    }
}

TEST (ObjectBases, AcrossTwoPlanesOfOneTable)
{
  View view = look ({floor_slab, table, onTable (1.f, 0.f, {0.1f, 0.15f, 0.2f})});
  cutInTwo (view, view.top.at (1));
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_GT (iou (objects.front(), view, 2), 0.85);
}

TEST (ObjectBases, OverALowerTable)
{
  // The thing stands on the higher table, and 4 cm of it are over the lower one.
  for (const float side : {1.f, -1.f})
    for (const float step : {0.02f, 0.1f}) {
      const Box low{{1.2f, side * 0.3f, 0.66f}, {0.8f, 0.6f, 0.04f}};
      const Box high{{1.2f, side * -0.3f, 0.66f}, {0.8f, 0.6f, 0.04f + step}};
      Box thing = onTable (1.1f, side * -0.01f, {0.1f, 0.1f, 0.2f});
      thing.bottom_center.z() += step;
      const View view = look ({floor_slab, low, high, thing});
      const Objects objects = extract (view);
      ASSERT_EQ (objects.size(), 1u) << side << " " << step;
      EXPECT_EQ (objects.front().support, view.top.at (2)) << side << " " << step;
      EXPECT_NEAR (objects.front().box_size.z(), 0.2f, 0.01f) << side << " " << step;
    }
}
