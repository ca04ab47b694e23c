// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "table_objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace table_objects;

namespace {

constexpr float side = 0.1f; // half the width of the thing
const Box thing = onTable (1.1f, 0.f, {0.16f, 2.f * side, 0.22f});

Camera
largeCamera ()
{
  Camera camera;
  camera.width = 640;
  camera.image_height = 480;
  return camera;
}

/** Box 2 is the thing, box 3 the part. Where the part ends, no depth is measured. */
View
lookAt (const Box& part)
{
  const Camera camera = largeCamera();
  View view = look ({floor_slab, table, thing, part}, camera);
  const int width = static_cast<int> (camera.width);
  for (const auto i : view.pixelsOf (3))
    for (const int step : {-width, -1, 1, width})
      if (const auto at = static_cast<std::size_t> (i + step); view.box[at] == 2)
        (*view.cloud)[at].getVector3fMap().setConstant (
            std::numeric_limits<float>::quiet_NaN());
  return view;
}

/** At the side of the thing, flush with its front. */
Box
beside (float width, float bottom, float height, float gap = 0.f)
{
  return {{1.04f, side + gap + 0.5f * width, table_height + bottom},
          {0.04f, width, height}};
}

void
expectWhole (const View& view, bool split = false)
{
  Extraction extraction;
  extraction.setSplitAtConcaveEdges (split);
  const Objects objects = extract (extraction, view);
  ASSERT_EQ (objects.size(), 1u);
  const pcl::Indices& indices = objects.front().indices.indices;
  for (const int box : {2, 3}) {
    const auto seen = view.pixelsOf (box);
    const auto found = std::count_if (
        indices.begin(), indices.end(), [&] (auto i) { return seen.count (i) != 0; });
    EXPECT_GT (static_cast<double> (found), 0.8 * static_cast<double> (seen.size()))
        << box;
  }
}

void
expectTwo (const View& view)
{
  const Objects objects = extract (view);
  EXPECT_EQ (objects.size(), 2u);
  for (const int box : {2, 3})
    EXPECT_GT (bestIou (objects, view, box), 0.8) << box;
}

} // namespace

TEST (AttachedParts, AHandleBehindASeamIsPartOfItsThing)
{
  expectWhole (lookAt (beside (0.03f, 0.08f, 0.08f)));
}

TEST (AttachedParts, AHandleIsNotSplitOff)
{
  // Set back, so that it meets the thing at a concave edge.
  const Box handle{{1.06f, side + 0.015f, table_height + 0.08f}, {0.06f, 0.03f, 0.08f}};
  expectWhole (look ({floor_slab, table, thing, handle}, largeCamera()), true);
}

TEST (AttachedParts, WhatIsOnASteepFaceIsNotSplitOff)
{
  // Part of it is higher than the thing, but it stands out in front of it.
  const Box cap{{1.03f, 0.f, table_height + 0.2f}, {0.04f, 0.05f, 0.06f}};
  expectWhole (look ({floor_slab, table, thing, cap}, largeCamera()), true);
}

TEST (AttachedParts, AFootHardlyHigherThanNoiseIsPartOfItsThing)
{
  expectWhole (lookAt (beside (0.05f, 0.f, 0.025f)));
}

TEST (AttachedParts, WhatStandsBesideAThingIsAnother)
{
  expectTwo (lookAt (beside (0.03f, 0.f, 0.06f)));
}

TEST (AttachedParts, WhatRestsOnAThingIsAnother)
{
  expectTwo (lookAt ({{1.08f, 0.f, table_height + 0.22f}, {0.06f, 0.06f, 0.04f}}));
}

TEST (AttachedParts, WhatIsTooFlatToRestOnAThingIsPartOfIt)
{
  View view = lookAt ({{1.08f, 0.f, table_height + 0.22f}, {0.06f, 0.06f, 0.006f}});
  const auto top = static_cast<std::ptrdiff_t> (view.top.at (2)); // as if not found
  view.models.erase (view.models.begin() + top);
  view.inliers.erase (view.inliers.begin() + top);
  expectWhole (view);
}

TEST (AttachedParts, WhatIsTooFarFromAThingIsAnother)
{
  expectTwo (lookAt (beside (0.03f, 0.08f, 0.08f, 0.03f)));
  expectTwo (
      lookAt ({{1.09f, side + 0.015f, table_height + 0.08f}, {0.04f, 0.03f, 0.08f}}));
}

TEST (AttachedParts, LargePartsAreThingsOfTheirOwn)
{
  expectTwo (lookAt (beside (0.08f, 0.04f, 0.15f)));
}
