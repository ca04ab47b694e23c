// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "table_objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

using namespace table_objects;

namespace {

constexpr float platform_height = 0.12f;
const Box platform{{2.f, 0.f, 0.f}, {0.8f, 1.2f, platform_height}};

Box
onPlatform (float x, float y, const Vector3f& size)
{
  return {{x, y, platform_height}, size};
}

Box
onFloor (float x, float y, const Vector3f& size)
{
  return {{x, y, 0.f}, size};
}

/** Two things on the platform, and two beside it, as near as an overhang may be, that are higher
 * than it. */
View
platformAmongThings (float noise)
{
  return look ({floor_slab,
                platform,
                onPlatform (1.9f, 0.3f, {0.1f, 0.1f, 0.15f}),
                onPlatform (2.1f, -0.3f, {0.15f, 0.15f, 0.1f}),
                onFloor (1.4f, -0.2f, {0.12f, 0.12f, 0.2f}),
                onFloor (2.f, -0.75f, {0.12f, 0.12f, 0.25f})},
               {},
               noise);
}

/** What a segmentation makes of the tops of two boxes that are as high as each other. */
void
joinTops (View& view, int box, int other)
{
  auto& inliers = view.inliers[view.top.at (box)].indices;
  const std::size_t joined = view.top.at (other);
  const auto& more = view.inliers[joined].indices;
  inliers.insert (inliers.end(), more.begin(), more.end());
  std::sort (inliers.begin(), inliers.end());
  const auto at = static_cast<std::ptrdiff_t> (joined);
  view.inliers.erase (view.inliers.begin() + at);
  view.models.erase (view.models.begin() + at);
  for (auto& top : view.top)
    top.second -= top.second > joined;
}

} // namespace

TEST (Platforms, ThingsOnAndBesideOneAreObjectsAndItIsNone)
{
  for (const float noise : {0.f, 1.f}) {
    const View view = platformAmongThings (noise);
    const Objects objects = extract (view);
    EXPECT_EQ (objects.size(), 4u) << noise;
    for (const int box : {2, 3, 4, 5})
      EXPECT_GT (bestIou (objects, view, box), 0.8) << noise << " " << box;
    for (const auto& object : objects) {
      const bool is_on_platform = iou (object, view, 2) + iou (object, view, 3) > 0.5;
      EXPECT_EQ (object.support, view.top.at (is_on_platform ? 1 : 0)) << noise;
    }
  }
}

TEST (Platforms, WhatSticksOutOfOneIsOnIt)
{
  for (const float noise : {0.f, 1.f}) {
    const Box thing = onPlatform (1.65f, 0.1f, {0.2f, 0.15f, 0.1f});
    const View view = look ({floor_slab, platform, thing}, {}, noise);
    const Objects objects = extract (view);
    ASSERT_EQ (objects.size(), 1u) << noise;
    EXPECT_EQ (objects.front().support, view.top.at (1)) << noise;
    EXPECT_GT (iou (objects.front(), view, 2), 0.9) << noise;
    EXPECT_NEAR (objects.front().box_size.z(), 0.1f, 0.02f) << noise;
  }
}

TEST (Platforms, TheirSidesAreOfNoObjectOnThem)
{
  for (const float noise : {0.f, 1.f}) {
    const Box thing = onPlatform (1.65f, 0.1f, {0.1f, 0.1f, 0.15f});
    const View view = look ({floor_slab, platform, thing}, {}, noise);
    EXPECT_GT (bestIou (extract (view), view, 2), 0.85) << noise;
  }
}

TEST (Platforms, ThingsAsHighAsOneElsewhereDoNotWidenIt)
{
  View view = look ({floor_slab,
                     platform,
                     onFloor (2.f, -0.8f, {0.12f, 0.12f, 0.25f}),
                     onFloor (1.7f, -1.05f, {0.3f, 0.3f, platform_height})});
  joinTops (view, 1, 3);
  const Objects objects = extract (view);
  EXPECT_EQ (objects.size(), 2u);
  for (const int box : {2, 3})
    EXPECT_GT (bestIou (objects, view, box), 0.8) << box;
}

TEST (Platforms, InliersInAnotherOrderDoNoHarm)
{
  View view = platformAmongThings (0.f);
  auto& inliers = view.inliers[view.top.at (1)].indices;
  std::reverse (inliers.begin(), inliers.end());
  EXPECT_EQ (extract (view).size(), 4u);
}

TEST (Platforms, TopsOfLargeBoxesAreNone)
{
  const Box large{{1.8f, 0.f, table_height}, {0.5f, 0.5f, 0.15f}};
  const Box mug{{1.8f, 0.f, table_height + 0.15f}, {0.08f, 0.08f, 0.1f}};
  const View view = look ({floor_slab, deep_table, large, mug});
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_GT (iou (objects.front(), view, 2), 0.8);
}

TEST (Platforms, TopsOfManyEqualBoxesAreNone)
{
  std::vector<Box> boxes{floor_slab, deep_table};
  for (const float x : {1.5f, 1.85f})
    for (const float y : {-0.525f, -0.175f, 0.175f, 0.525f})
      boxes.push_back (onTable (x, y, {0.25f, 0.25f, 0.1f}));
  View view = look (boxes);
  for (int box = 3; box < 10; ++box)
    joinTops (view, 2, box);
  const Objects objects = extract (view);
  EXPECT_EQ (objects.size(), 8u);
  for (int box = 2; box < 10; ++box)
    EXPECT_GT (bestIou (objects, view, box), 0.8) << box;
}

TEST (Platforms, AreLargeForTheHeightOfObjects)
{
  const View view = platformAmongThings (0.f);
  for (const bool is_platform : {true, false}) {
    Extraction extraction;
    extraction.setMaxObjectHeight (is_platform ? 0.3 : 0.6);
    extract (extraction, view);
    const auto& supports = extraction.getSupportPlanes();
    const auto top =
        std::find_if (supports.begin(), supports.end(), [&] (const auto& support) {
          return support.index == view.top.at (1);
        });
    ASSERT_NE (top, supports.end());
    EXPECT_EQ (top->is_platform, is_platform);
    EXPECT_EQ (top->is_on_object, !is_platform);
  }
}
