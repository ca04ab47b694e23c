// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "table_objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace table_objects;

TEST (SupportedObjectExtraction, EmptyScene)
{
  EXPECT_TRUE (extract (look ({})).empty());
}

TEST (SupportedObjectExtraction, TableWithoutObjects)
{
  EXPECT_TRUE (extract (look ({floor_slab, table})).empty());
  for (const float noise : {0.5f, 1.f})
    EXPECT_TRUE (extract (look ({floor_slab, table}, {}, noise)).empty());
}

TEST (SupportedObjectExtraction, KnowsABox)
{
  const Box box = onTable (1.1f, 0.1f, {0.1f, 0.06f, 0.12f}, 0.5f);
  const View view = look ({floor_slab, table, box});
  Extraction extraction;
  const Objects objects = extract (extraction, view);
  ASSERT_EQ (objects.size(), 1u);
  const auto& object = objects.front();
  // Its lowest 5 mm and what noise explains are left out.
  EXPECT_GT (iou (object, view, 2), 0.9);
  EXPECT_LT ((sorted (object.box_size) - sorted (box.size)).cwiseAbs().maxCoeff(),
             0.006f)
      << object.box_size.transpose();
  const Vector3f center = view.camera_to_base * object.box_center;
  EXPECT_LT ((center - box.bottom_center - Vector3f (0.f, 0.f, 0.06f)).norm(), 0.006f);
  const Eigen::Matrix3f axes = view.camera_to_base.linear() * object.box_axes;
  EXPECT_GT (axes (2, 2), 0.9999f);
  EXPECT_NEAR (object.box_axes.determinant(), 1.f, 1e-4f);
  // The side that is 10 cm long, up to its sign.
  const Vector3f longest = axes.col (object.box_size.x() > object.box_size.y() ? 0 : 1);
  EXPECT_GT (std::fabs (longest.dot (Vector3f (std::cos (0.5f), std::sin (0.5f), 0.f))),
             0.995f);
  EXPECT_EQ (object.support, view.top.at (1));
  EXPECT_TRUE (object.graspable);
  EXPECT_TRUE (
      std::is_sorted (object.indices.indices.begin(), object.indices.indices.end()));

  Vector3f mean = Vector3f::Zero();
  for (const auto i : object.indices.indices)
    mean += (*view.cloud)[i].getVector3fMap() / object.indices.indices.size();
  EXPECT_LT ((mean - object.centroid).norm(), 1e-4f);

  // The hull of the table, as far as the camera sees it; its edge noise-free.
  const auto& supports = extraction.getSupportPlanes();
  ASSERT_GE (supports.size(), 2u);
  for (const auto& support : supports)
    if (support.index == view.top.at (1)) {
      EXPECT_GE (support.hull.size(), 4u);
      for (const auto& corner : support.hull) {
        const Vector3f p = view.camera_to_base * corner;
        EXPECT_NEAR (p.z(), table_height, 1e-3f);
        EXPECT_LT (std::fabs (p.x() - 1.2f), 0.401f);
        EXPECT_LT (std::fabs (p.y()), 0.501f);
      }
    }
}

TEST (SupportedObjectExtraction, GraspableBySmallestSide)
{
  const View view =
      look ({floor_slab, table, onTable (1.1f, 0.f, {0.13f, 0.14f, 0.15f})});
  Extraction extraction;
  Objects objects = extract (extraction, view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_FALSE (objects.front().graspable);
  extraction.setGraspableSides (0.1, 0.15);
  objects = extract (extraction, view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_TRUE (objects.front().graspable);
  extraction.setGraspableSides (0.14, 0.2);
  EXPECT_FALSE (extract (extraction, view).front().graspable);
}

TEST (SupportedObjectExtraction, FrontOfALargeThingIsNotGraspable)
{
  // The top does not show, and noise makes the front as deep as what fits into a hand.
  for (const float noise : {0.5f, 1.f}) {
    const View view =
        look ({floor_slab, deep_table, onTable (1.7f, 0.f, {0.3f, 0.3f, 0.25f})},
              Camera{table_height + 0.2f, 0.1f},
              noise);
    const Objects objects = extract (view);
    ASSERT_EQ (objects.size(), 1u) << noise;
    EXPECT_GT (objects.front().box_size.minCoeff(), 0.01f) << noise;
    EXPECT_FALSE (objects.front().graspable) << noise;
  }
}

TEST (SupportedObjectExtraction, TiltedCameraAndNoise)
{
  Camera camera;
  camera.roll = 0.3f;
  camera.pitch_down = 0.8f;
  const Box box = onTable (1.1f, 0.1f, {0.1f, 0.06f, 0.12f}, 1.f);
  const View view = look ({floor_slab, table, box}, camera, 0.5f);
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_GT (iou (objects.front(), view, 2), 0.8);
  EXPECT_LT (
      (sorted (objects.front().box_size) - sorted (box.size)).cwiseAbs().maxCoeff(),
      0.01f);
  // Who believes the camera to be level, sees no horizontal plane.
  View wrong = view;
  wrong.camera_to_base = Camera{1.4f, 0.f, 0.f}.toBase();
  EXPECT_TRUE (extract (wrong).empty());
}

TEST (SupportedObjectExtraction, LowThingsAreNoise)
{
  Extraction extraction;
  for (const float height : {0.004f, 0.008f})
    EXPECT_TRUE (
        extract (extraction,
                 look ({floor_slab, table, onTable (0.95f, 0.f, {0.1f, 0.1f, height})}))
            .empty());
  const View view =
      look ({floor_slab, table, onTable (0.95f, 0.f, {0.1f, 0.1f, 0.014f})});
  EXPECT_EQ (extract (extraction, view).size(), 1u);
  extraction.setMinObjectHeight (0.02);
  EXPECT_TRUE (extract (extraction, view).empty());
  // At 2.9 m, three standard deviations of depth are 5 cm, of which half points up.
  const Box far_table{{2.5f, 0.f, 0.f}, {1.f, 1.f, 0.1f}};
  const auto far = [&] (float height) {
    return look ({far_table, {{2.5f, 0.f, 0.1f}, {0.2f, 0.2f, height}}},
                 Camera{1.5f, 0.5f});
  };
  extraction.setMinObjectHeight (0.01);
  EXPECT_TRUE (extract (extraction, far (0.02f)).empty());
  EXPECT_EQ (extract (extraction, far (0.05f)).size(), 1u);
}

TEST (SupportedObjectExtraction, OtherSensorsSeeLowerThingsAndLessFar)
{
  const Box far_table{{2.5f, 0.f, 0.f}, {1.f, 1.f, 0.1f}};
  const View view =
      look ({far_table, {{2.5f, 0.f, 0.1f}, {0.2f, 0.2f, 0.02f}}}, Camera{1.5f, 0.5f});
  Extraction extraction;
  EXPECT_TRUE (extract (extraction, view).empty());
  extraction.setDepthNoise (pcl::rgbd_planes::DepthNoise::timeOfFlight());
  EXPECT_EQ (extraction.getDepthNoise().max_range, 5.5f);
  EXPECT_EQ (extract (extraction, view).size(), 1u);
  extraction.setDepthNoise ({0.001f, 0.0002f, 2.f});
  EXPECT_TRUE (extract (extraction, view).empty());
}

TEST (SupportedObjectExtraction, ObjectsHaveClearPoints)
{
  // A sheet is lower than an object; a tower on it is not.
  const auto sheetAndTower = [] (float sheet, float tower) {
    return look ({floor_slab,
                  table,
                  onTable (0.95f, 0.f, {sheet, sheet, 0.008f}),
                  {{0.95f, 0.f, table_height + 0.008f}, {tower, tower, 0.03f}}});
  };
  const auto found = [] (const View& view, unsigned min_points) {
    Extraction extraction;
    extraction.setMinPoints (min_points);
    return extract (extraction, view);
  };
  // A quarter of the points must be clear.
  EXPECT_EQ (found (sheetAndTower (0.03f, 0.03f), 50).size(), 1u);
  EXPECT_TRUE (found (sheetAndTower (0.15f, 0.03f), 50).empty());
  // And 0.6 of the smallest number of points.
  const View view = sheetAndTower (0.06f, 0.03f);
  const Objects objects = found (view, 50);
  ASSERT_EQ (objects.size(), 1u);
  const auto points = static_cast<unsigned> (objects.front().indices.indices.size());
  EXPECT_EQ (found (view, points / 2).size(), 1u);
  EXPECT_TRUE (found (view, points).empty());
}

TEST (SupportedObjectExtraction, MinPoints)
{
  const View view =
      look ({floor_slab, table, onTable (1.1f, 0.f, {0.05f, 0.05f, 0.05f})});
  Extraction extraction;
  const Objects objects = extract (extraction, view);
  ASSERT_EQ (objects.size(), 1u);
  const auto points = static_cast<unsigned> (objects.front().indices.indices.size());
  extraction.setMinPoints (points);
  EXPECT_EQ (extract (extraction, view).size(), 1u);
  extraction.setMinPoints (points + 1);
  EXPECT_TRUE (extract (extraction, view).empty());
}

TEST (SupportedObjectExtraction, ThingsOnTheFloorAreObjects)
{
  const View view = look ({floor_slab, {{1.5f, 0.f, 0.f}, {0.2f, 0.2f, 0.2f}}});
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_GT (iou (objects.front(), view, 1), 0.85);
}
