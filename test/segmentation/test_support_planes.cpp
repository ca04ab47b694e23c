// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "table_objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

using namespace table_objects;

TEST (SupportPlanes, HeightsOfPlanes)
{
  const View view = look ({floor_slab, table, onTable (1.1f, 0.f, {0.1f, 0.1f, 0.1f})});
  Extraction extraction;
  const auto& rejections = extraction.getSupportRejections();
  extraction.setPlaneHeights (0.65, 0.75);
  EXPECT_EQ (extract (extraction, view).size(), 1u);
  const std::size_t not_level = rejections.not_level;
  EXPECT_EQ (rejections.too_low, 1u) << "the floor";
  EXPECT_EQ (rejections.too_high, 0u);
  extraction.setPlaneHeights (0.72, 1.2);
  EXPECT_TRUE (extract (extraction, view).empty());
  EXPECT_EQ (rejections.too_low, 2u);
  EXPECT_EQ (rejections.too_high, 0u);
  extraction.setPlaneHeights (0.1, 0.68);
  EXPECT_TRUE (extract (extraction, view).empty());
  EXPECT_EQ (rejections.too_low, 1u);
  EXPECT_EQ (rejections.too_high, 1u) << "the table";
  EXPECT_EQ (rejections.not_level, not_level);
}

TEST (SupportPlanes, HeightsAreAsUncertainAsDepth)
{
  const View view = look ({floor_slab, table, onTable (1.1f, 0.f, {0.1f, 0.1f, 0.1f})});
  Extraction extraction;
  extraction.setPlaneHeights (0.1, table_height - 0.005);
  EXPECT_EQ (extract (extraction, view).size(), 1u);
  extraction.setPlaneHeights (table_height + 0.005, 1.2);
  EXPECT_EQ (extract (extraction, view).size(), 1u);
}

TEST (SupportPlanes, TheFloorMayBeLowerThanThePoseSays)
{
  View view = look ({floor_slab, {{1.2f, 0.f, 0.f}, {0.1f, 0.1f, 0.1f}}});
  const Eigen::Affine3f pose = view.camera_to_base;
  const auto countObjects = [&] (float height, float lowest) {
    view.camera_to_base = Eigen::Translation3f (0.f, 0.f, height) * pose;
    Extraction extraction;
    extraction.setDepthNoise ({0.001f, 0.f});
    extraction.setPlaneHeights (lowest, 1.2);
    return extract (extraction, view).size();
  };
  for (const float height : {0.04f, 0.f, -0.02f, -0.04f})
    EXPECT_EQ (countObjects (height, 0.f), 1u) << height;
  EXPECT_EQ (countObjects (-0.1f, 0.f), 0u);
  EXPECT_EQ (countObjects (-0.1f, -0.1f), 1u);
  EXPECT_EQ (countObjects (0.f, 0.04f), 0u) << "a range that leaves the floor out";
}

/** As in a bin on a table, where z = 0 is the bottom of the bin. */
TEST (SupportPlanes, WhatIsLowerThanAPlaneAtZeroSupportsNothing)
{
  View view = look ({{{1.2f, 0.f, -0.13f}, {3.f, 3.f, 0.1f}},
                     {{1.2f, 0.f, -0.03f}, {0.5f, 0.5f, 0.03f}},
                     {{1.2f, 0.f, 0.f}, {0.1f, 0.1f, 0.1f}}});
  Extraction extraction;
  extraction.setDepthNoise ({0.001f, 0.f});
  EXPECT_EQ (extract (extraction, view).size(), 1u);
  EXPECT_FALSE (extraction.getSupportPlanes().empty());
  for (const auto& support : extraction.getSupportPlanes())
    EXPECT_GT (support.height, -0.01f);
}

TEST (SupportPlanes, HorizontalTolerance)
{
  View view = look ({floor_slab, table, onTable (1.f, 0.1f, {0.06f, 0.06f, 0.1f})});
  Camera wrong;
  wrong.pitch_down += 0.1f;
  view.camera_to_base = wrong.toBase();
  Extraction extraction;
  extraction.setPlaneHeights (0.4, 1.2);
  extraction.setHorizontalTolerance (0.12);
  EXPECT_EQ (extract (extraction, view).size(), 1u);
  extraction.setHorizontalTolerance (0.08);
  EXPECT_TRUE (extract (extraction, view).empty());
}

TEST (SupportPlanes, HullTolerance)
{
  // Things hang over the edge of the table on the left, by 2 cm and by 8 cm.
  const auto overhanging = [] (float by) {
    return look (
        {floor_slab, table, onTable (1.1f, 0.5f + by - 0.05f, {0.1f, 0.1f, 0.1f})});
  };
  Extraction extraction;
  extraction.setMaxOverhang (0.);
  const View little = overhanging (0.02f), much = overhanging (0.08f);
  EXPECT_GT (bestIou (extract (extraction, little), little, 2), 0.85);
  EXPECT_LT (bestIou (extract (extraction, much), much, 2), 0.7);
  extraction.setHullTolerance (0.1);
  EXPECT_GT (bestIou (extract (extraction, much), much, 2), 0.85);
}

TEST (SupportPlanes, MaxOverhang)
{
  const auto stickingOut = [] (float by, double max_overhang) {
    const View view = look (
        {floor_slab, table, onTable (1.1f, 0.42f + by, {0.16f, 0.16f, 0.1f})}, {}, 1.f);
    Extraction extraction;
    extraction.setMaxOverhang (max_overhang);
    return bestIou (extract (extraction, view), view, 2);
  };
  EXPECT_GT (stickingOut (0.f, 0.2), 0.8);
  EXPECT_GT (stickingOut (0.08f, 0.2), 0.8);
  EXPECT_LT (stickingOut (0.08f, 0.), 0.7);
  EXPECT_EQ (stickingOut (0.4f, 0.2), 0.); // it is over the floor
}

TEST (SupportPlanes, WhatTheImageCutsSticksOutOfNoTable)
{
  // At x = 1.3 m the image ends 0.84 m to the side.
  const auto objectsAtEdge = [] (float y) {
    const Box shifted{{1.2f, y - 0.5f, 0.66f}, {0.8f, 1.f, 0.04f}};
    const Box thing = onTable (1.3f, y + 0.04f, {0.16f, 0.16f, 0.1f});
    return extract (look ({floor_slab, shifted, thing})).size();
  };
  EXPECT_EQ (objectsAtEdge (0.5f), 1u);
  EXPECT_EQ (objectsAtEdge (0.74f), 0u);
}

TEST (SupportPlanes, SeveralTables)
{
  const Box low_table{{1.2f, 0.45f, 0.46f}, {0.6f, 0.5f, 0.04f}};
  const Box high_table{{1.2f, -0.35f, 0.66f}, {0.6f, 0.6f, 0.04f}};
  const View view = look ({floor_slab,
                           low_table,
                           high_table,
                           {{1.2f, 0.4f, 0.5f}, {0.1f, 0.1f, 0.1f}},
                           {{1.2f, -0.3f, 0.7f}, {0.1f, 0.1f, 0.1f}}});
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 2u);
  for (const auto& object : objects) {
    const bool is_low = iou (object, view, 3) > 0.5;
    EXPECT_GT (iou (object, view, is_low ? 3 : 4), 0.85);
    EXPECT_EQ (object.support, view.top.at (is_low ? 1 : 2));
    EXPECT_NEAR (object.box_size.z(), 0.1f, 0.005f);
  }
}

TEST (SupportPlanes, TableCutByTheImage)
{
  const Box large_table{{1.2f, 0.f, 0.66f}, {3.f, 4.f, 0.04f}};
  const View view = look ({large_table,
                           onTable (1.f, 0.1f, {0.1f, 0.1f, 0.1f}),
                           onTable (1.f, 0.55f, {0.1f, 0.1f, 0.1f})});
  ASSERT_LT (*std::min_element (view.box.begin(), view.box.end()), 1);
  const Objects objects = extract (view);
  EXPECT_EQ (objects.size(), 2u);
  for (const int box : {1, 2})
    EXPECT_GT (bestIou (objects, view, box), 0.85) << box;
}

/** What is seen of the table has a hull without the corner that the thing hides. */
TEST (SupportPlanes, ThingsAtACornerOfATableAreObjects)
{
  for (const float yaw : {0.f, 0.4f, 0.8f})
    for (const float width : {0.06f, 0.1f, 0.2f})
      for (const float noise : {0.f, 1.f}) {
        const float half = 0.5f * width * (std::cos (yaw) + std::sin (yaw)) + 0.005f;
        const Box thing = onTable (1.6f - half, 0.5f - half, {width, width, 0.1f}, yaw);
        const View view = look ({floor_slab, table, thing}, {}, noise);
        const Objects objects = extract (view);
        EXPECT_EQ (objects.size(), 1u) << yaw << " " << width << " " << noise;
        EXPECT_GT (bestIou (objects, view, 2), 0.8)
            << yaw << " " << width << " " << noise;
      }
}

TEST (SupportPlanes, ThingsBesideATurnedTableAreNotOnIt)
{
  // One in front of an edge, on nothing; a box around the table along x and y holds it.
  const Box turned{{1.2f, 0.f, 0.66f}, {0.6f, 0.6f, 0.04f}, 0.785f};
  const Box in_the_air = onTable (0.9f, 0.3f, {0.08f, 0.08f, 0.1f}, 0.785f);
  const Box on_it = onTable (1.2f, 0.f, {0.08f, 0.08f, 0.1f});
  const View view = look ({floor_slab, turned, in_the_air, on_it});
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_GT (iou (objects.front(), view, 3), 0.85);
}

TEST (SupportPlanes, WhatStandsBesideATableIsNoObjectOfIt)
{
  for (const float gap : {0.f, 0.01f, 0.05f, 0.15f}) {
    const Box chair{{1.2f, 0.6f + gap, 0.f}, {0.2f, 0.2f, 0.9f}};
    const View view = look ({floor_slab, table, chair});
    EXPECT_GT (view.pixelsOf (2).size(), 500u);
    EXPECT_TRUE (extract (view).empty()) << gap;
  }
}

TEST (SupportPlanes, LabelsThatLeak)
{
  View view = look ({floor_slab, table, onTable (1.1f, 0.f, {0.1f, 0.1f, 0.1f})});
  auto& table_inliers = view.inliers[view.top.at (1)].indices;
  const std::size_t before = table_inliers.size();
  for (const auto i : view.pixelsOf (2)) // its lowest 3 cm
    if ((view.camera_to_base * (*view.cloud)[i].getVector3fMap()).z() <
        table_height + 0.03f)
      table_inliers.push_back (i);
  ASSERT_GT (table_inliers.size(), before + 100);
  std::sort (table_inliers.begin(), table_inliers.end());
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_GT (iou (objects.front(), view, 2), 0.85);
}

TEST (SupportPlanes, TiltIsThatOfThePointsNotOfTheModel)
{
  View view = look ({floor_slab, table});
  view.camera_to_base.prerotate (Eigen::AngleAxisf (0.2f, Vector3f::UnitX()));
  for (auto& model : view.models) {
    const Vector3f up = view.camera_to_base.linear().row (2);
    std::copy_n (up.data(), 3, model.values.begin());
  }
  Extraction extraction;
  extraction.setPlaneHeights (-1., 2.);
  extract (extraction, view);
  EXPECT_EQ (extraction.getSupportPlanes().size(), 2u);
  extraction.setHorizontalTolerance (0.15);
  extract (extraction, view);
  EXPECT_TRUE (extraction.getSupportPlanes().empty());
}

TEST (SupportPlanes, HullsLeaveOutPointsThatAreOffTheirPlane)
{
  View view = look ({floor_slab, table});
  const auto on_floor = view.pixelsOf (0);
  const pcl::index_t outlier = *on_floor.begin();
  auto& inliers = view.inliers[view.top.at (1)].indices;
  inliers.insert (inliers.begin(), outlier);
  ASSERT_TRUE (std::is_sorted (inliers.begin(), inliers.end()));
  Extraction extraction;
  extract (extraction, view);
  const auto& supports = extraction.getSupportPlanes();
  ASSERT_EQ (supports.size(), 2u);
  ASSERT_EQ (supports[0].index, view.top.at (1));
  const auto isOnTable = [&] (const Vector3f& p) {
    const Vector3f in_base = view.camera_to_base * p;
    return std::fabs (in_base.x() - 1.2f) < 0.401f && std::fabs (in_base.y()) < 0.501f;
  };
  ASSERT_FALSE (
      isOnTable ((*view.cloud)[static_cast<std::size_t> (outlier)].getVector3fMap()));
  EXPECT_GE (supports[0].hull.size(), 4u);
  for (const auto& corner : supports[0].hull)
    EXPECT_TRUE (isOnTable (corner)) << corner.transpose();
}

TEST (SupportPlanes, OptimisesAModelThatOutliersSpoilt)
{
  View view =
      look ({floor_slab, table, onTable (1.1f, 0.f, {0.1f, 0.1f, 0.1f})}, {}, 0.3f);
  auto& model = view.models[view.top.at (1)].values;
  const float true_d = model[3];
  model[3] += 0.012f;
  Extraction extraction;
  EXPECT_EQ (extract (extraction, view).size(), 1u);
  const auto& supports = extraction.getSupportPlanes();
  const auto table_top =
      std::find_if (supports.begin(), supports.end(), [&] (const auto& support) {
        return support.index == view.top.at (1);
      });
  ASSERT_NE (table_top, supports.end());
  EXPECT_NEAR (table_top->coefficients.values[3], true_d, 0.001f);
}

TEST (SupportPlanes, ThingsCutByAMarginBelowTheImageAreTruncated)
{
  const Box near_table{{0.9f, 0.f, 0.66f}, {1.2f, 1.f, 0.04f}};
  const auto isTruncated = [&] (float x) {
    const View view =
        look ({floor_slab, near_table, onTable (x, 0.f, {0.1f, 0.1f, 0.1f})});
    for (std::uint32_t v = 233; v < 240; ++v)
      for (std::uint32_t u = 0; u < 320; ++u)
        view.cloud->at (u, v).getVector3fMap().setConstant (
            std::numeric_limits<float>::quiet_NaN());
    const Objects objects = extract (view);
    EXPECT_EQ (objects.size(), 1u) << x;
    return objects.front().truncated;
  };
  EXPECT_TRUE (isTruncated (0.42f));
  EXPECT_FALSE (isTruncated (0.6f));
}

TEST (SupportPlanes, ThingsAtAWallThatIndicesLeaveOutAreObjects)
{
  const Box wall{{1.65f, 0.f, 0.f}, {0.1f, 4.f, 2.f}};
  const View view =
      look ({floor_slab, table, wall, onTable (1.55f, 0.f, {0.1f, 0.1f, 0.15f})});
  const auto without_wall = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < view.box.size(); ++i)
    if (view.box[i] != 2)
      without_wall->push_back (static_cast<pcl::index_t> (i));
  Extraction extraction;
  EXPECT_GT (bestIou (extract (extraction, view), view, 3), 0.8);
  extraction.setIndices (without_wall);
  EXPECT_GT (bestIou (extract (extraction, view), view, 3), 0.8);
}
