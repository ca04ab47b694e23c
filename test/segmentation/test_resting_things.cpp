// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "table_objects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace table_objects;

namespace {

const Camera camera{1.4f, 0.65f, 0.f, 640, 480};

/** The objects of two things, boxes 2 and 3 of a view, without the planes of their tops: too
 * little of these may be seen. */
Objects
extractSplit (View view)
{
  for (const int box : {3, 2})
    if (const auto top = view.top.find (box); top != view.top.end()) {
      const auto plane = static_cast<std::ptrdiff_t> (top->second);
      view.models.erase (view.models.begin() + plane);
      view.inliers.erase (view.inliers.begin() + plane);
    }
  Extraction extraction;
  extraction.setSplitAtConcaveEdges (true);
  return extract (extraction, view);
}

/** Where the box of the one object with the points of a box begins and ends, above the table. */
std::pair<float, float>
heightsOf (int box, const View& view, const Objects& objects)
{
  std::pair<float, float> heights{-1.f, -1.f};
  int count = 0;
  for (const auto& object : objects)
    if (iou (object, view, box) > 0.7) {
      const float middle = (view.camera_to_base * object.box_center).z() - table_height;
      heights = {middle - 0.5f * object.box_size.z(),
                 middle + 0.5f * object.box_size.z()};
      ++count;
    }
  EXPECT_EQ (count, 1);
  return heights;
}

Box
raised (Box box, float height)
{
  box.bottom_center.z() += height;
  return box;
}

void
expectFrom (float low, float high, const Box& lower, const Box& upper, float roll = 0.f)
{
  for (const float noise : {0.f, 0.5f}) {
    Camera turned = camera;
    turned.roll = roll;
    const View view = look ({floor_slab, table, lower, upper}, turned, noise);
    const auto heights = heightsOf (3, view, extractSplit (view));
    EXPECT_NEAR (heights.first, low, 0.012f) << noise;
    EXPECT_NEAR (heights.second, high, 0.012f) << noise;
  }
}

} // namespace

TEST (RestingThings, WhatSticksOutOverALowerThing)
{
  const Box lower = onTable (1.1f, 0.f, {0.1f, 0.1f, 0.06f});
  const Box upper = raised (onTable (1.1f, 0.f, {0.16f, 0.22f, 0.05f}), 0.06f);
  for (const float roll : {0.f, 1.5f, 3.1f})
    expectFrom (0.06f, 0.11f, lower, upper, roll);
}

TEST (RestingThings, WhatLiesOnALargerThing)
{
  const Box lower = onTable (1.1f, 0.f, {0.22f, 0.3f, 0.06f});
  const Box upper = raised (onTable (1.1f, 0.f, {0.14f, 0.2f, 0.05f}), 0.06f);
  expectFrom (0.06f, 0.11f, lower, upper);
}

TEST (RestingThings, WhatTouchesALowerThingInFrontStandsOnTheTable)
{
  const Box lower = onTable (1.f, 0.f, {0.1f, 0.3f, 0.06f});
  const Box behind = onTable (1.12f, 0.f, {0.14f, 0.14f, 0.2f});
  expectFrom (0.f, 0.2f, lower, behind);
}

TEST (RestingThings, WhatIsHiddenBelowStandsOnTheTable)
{
  const Box lower = onTable (0.95f, 0.f, {0.05f, 0.3f, 0.1f});
  const Box behind = onTable (1.15f, 0.f, {0.14f, 0.14f, 0.15f});
  expectFrom (0.f, 0.15f, lower, behind);
}

TEST (RestingThings, WhatBulgesOverItsFootStandsOnTheTable)
{
  // Seen so steeply, nothing shows below the middle of a lying cylinder.
  const View view = look ({floor_slab,
                           table,
                           onTable (0.95f, 0.f, {0.15f, 0.3f, 0.25f}),
                           raised (onTable (0.95f, 0.f, {0.25f, 0.3f, 0.1f}), 0.075f)},
                          {2.1f, 1.f, 0.f, 640, 480});
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_NEAR (objects.front().box_size.z(), 0.25f, 0.01f);
}

TEST (RestingThings, WhatIsSeenFromAboveStandsOnTheTable)
{
  const Box below_camera{{0.f, 0.f, 0.66f}, {1.f, 1.f, 0.04f}};
  for (const float pitch : {1.57f, 1.4f})
    for (const float noise : {0.f, 0.5f}) {
      const View view =
          look ({below_camera, {{0.05f, 0.f, table_height}, {0.08f, 0.12f, 0.16f}}},
                {1.7f, pitch, 0.f, 640, 480},
                noise);
      const Objects objects = extract (view);
      ASSERT_EQ (objects.size(), 1u) << pitch << ' ' << noise;
      EXPECT_NEAR (objects.front().box_size.z(), 0.16f, 0.012f)
          << pitch << ' ' << noise;
    }
}

TEST (RestingThings, SidesThatAreSeenFlatlyAreNotInMidAir)
{
  std::mt19937 generator (1);
  const auto between = [&generator] (float low, float high) {
    return std::uniform_real_distribution<float> (low, high) (generator);
  };
  int wrong = 0, all = 0;
  for (int k = 0; k < 40; ++k) {
    std::vector<Box> boxes{{{0.f, 0.f, 0.66f}, {2.f, 2.f, 0.04f}}};
    for (const float x : {-0.09f, 0.09f})
      for (const float y : {-0.12f, 0.f, 0.12f})
        boxes.push_back (
            {{x + between (-0.02f, 0.02f), y + between (-0.02f, 0.02f), table_height},
             {between (0.05f, 0.1f), between (0.05f, 0.1f), between (0.03f, 0.07f)},
             between (0.f, 3.f)});
    const float height = table_height + between (0.35f, 0.6f);
    const float pitch = between (1.4f, 1.57f);
    const View view = look (boxes, {height, pitch, 0.f, 640, 480}, between (0.5f, 1.f));
    for (const auto& object : extract (view)) {
      if (object.truncated)
        continue;
      for (int box = 1; box < 7; ++box)
        if (iou (object, view, box) > 0.7) {
          ++all;
          wrong += std::abs (object.box_size.z() - boxes[box].size.z()) > 0.015f;
        }
    }
  }
  EXPECT_GT (all, 150);
  EXPECT_EQ (wrong, 0) << "of " << all;
}

TEST (RestingThings, WhatLacksItsFootStandsOnTheTable)
{
  const Box box = onTable (1.1f, 0.f, {0.14f, 0.2f, 0.12f});
  View view = look ({floor_slab, table, box}, camera);
  for (auto& point : *view.cloud) {
    const Vector3f p = view.camera_to_base * point.getVector3fMap();
    if (p.x() < 1.04f && std::fabs (p.y()) < 0.11f && p.z() > table_height + 0.002f &&
        p.z() < table_height + 0.035f)
      point.x = std::numeric_limits<float>::quiet_NaN();
  }
  const auto heights = heightsOf (2, view, extractSplit (view));
  EXPECT_NEAR (heights.first, 0.f, 0.012f);
  EXPECT_NEAR (heights.second, 0.12f, 0.012f);
}

namespace {

/** How many objects a thing on a post, box 3 on box 2, is, and how high the first of them is. */
std::pair<std::size_t, float>
objectsOfPost (const View& view, bool split)
{
  Extraction extraction;
  extraction.setSplitAtConcaveEdges (split);
  std::size_t count = 0;
  float height = 0.f;
  for (const auto& object : extract (extraction, view))
    if (iou (object, view, 2) > 0.1 || iou (object, view, 3) > 0.1)
      height = count++ == 0 ? object.box_size.z() : height;
  return {count, height};
}

View
lookAtPost (const Box& post, const Box& head, float noise, float roll = 0.f)
{
  return look ({floor_slab, table, post, head}, {1.1f, 0.35f, roll, 640, 480}, noise);
}

void
expectApart (const Box& post, const Box& head, bool split)
{
  for (const float noise : {0.f, 1.f})
    EXPECT_EQ (objectsOfPost (lookAtPost (post, head, noise), split).first, 2u)
        << noise;
}

} // namespace

TEST (RestingThings, WhatAThinPostHoldsIsOneThingWithIt)
{
  const Box post = onTable (1.1f, 0.f, {0.012f, 0.012f, 0.12f});
  const Box head = raised (onTable (1.1f, 0.f, {0.1f, 0.12f, 0.08f}), 0.12f);
  for (const float roll : {0.f, 1.5f, 3.1f})
    for (const float noise : {0.f, 1.f})
      for (const bool split : {false, true}) {
        const auto found = objectsOfPost (lookAtPost (post, head, noise, roll), split);
        EXPECT_EQ (found.first, 1u) << roll << ' ' << noise << ' ' << split;
        EXPECT_NEAR (found.second, 0.2f, 0.012f)
            << roll << ' ' << noise << ' ' << split;
      }
}

TEST (RestingThings, WhatAWidePostHoldsIsAThingOfItsOwn)
{
  const Box post = onTable (1.1f, 0.f, {0.04f, 0.05f, 0.12f});
  const Box head = raised (onTable (1.1f, 0.f, {0.1f, 0.16f, 0.08f}), 0.12f);
  expectApart (post, head, true);
}

TEST (RestingThings, WhatStandsFartherThanAThingInMidAirDoesNotHoldIt)
{
  const Box pen = onTable (1.25f, 0.f, {0.012f, 0.012f, 0.14f});
  const Box head = raised (onTable (1.1f, 0.f, {0.1f, 0.12f, 0.08f}), 0.12f);
  expectApart (pen, head, false);
}

// Steps of depth and pixels without it cut pieces out of large things.
TEST (RestingThings, APieceOfWhatIsTooHighIsNoObject)
{
  const Box panel = onTable (1.3f, 0.f, {0.05f, 0.6f, 0.26f});
  const Box column = onTable (1.3f, 0.35f, {0.05f, 0.1f, 0.5f});
  View view = look ({floor_slab, table, panel, column}, camera);
  ASSERT_TRUE (extract (view).empty());
  for (auto& point : *view.cloud) {
    const Vector3f p = view.camera_to_base * point.getVector3fMap();
    const float off =
        std::max (std::fabs (p.y()) - 0.05f, table_height + 0.18f - p.z());
    if (off > 0.f && off < 0.01f && p.z() > table_height + 0.1f)
      point.x = std::numeric_limits<float>::quiet_NaN();
  }
  EXPECT_TRUE (extract (view).empty());
}
