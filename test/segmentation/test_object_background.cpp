// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "table_objects.h"

#include <pcl/common/transforms.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

using namespace table_objects;

namespace {

/** The same in a frame with other axes. */
View
turned (View view)
{
  const Eigen::Affine3f turn (
      Eigen::AngleAxisf (2.f, Vector3f (1.f, -2.f, 3.f).normalized()));
  const auto cloud = pcl::make_shared<table_scenes::Cloud>();
  pcl::transformPointCloud (*view.cloud, *cloud, turn);
  view.cloud = cloud;
  for (auto& model : view.models) {
    const Vector3f normal = turn.linear() * Vector3f (model.values.data());
    std::copy_n (normal.data(), 3, model.values.begin());
  }
  view.camera_to_base = view.camera_to_base * turn.inverse();
  return view;
}

/** Gives those faces that lie in one plane to the first of them. */
void
joinFaces (View& view)
{
  std::map<std::vector<float>, std::size_t> first;
  std::size_t count = 0;
  for (std::size_t k = 0; k < view.models.size(); ++k) {
    std::vector<float> rounded = view.models[k].values;
    for (float& value : rounded)
      value = std::round (1000.f * value);
    const auto [plane, is_new] = first.emplace (rounded, count);
    if (is_new) {
      view.models[count] = view.models[k];
      view.inliers[count++] = view.inliers[k];
      continue;
    }
    auto& all = view.inliers[plane->second].indices;
    const auto& more = view.inliers[k].indices;
    all.insert (all.end(), more.begin(), more.end());
    std::sort (all.begin(), all.end());
  }
  view.models.resize (count);
  view.inliers.resize (count);
}

/** These boxes are the objects of a view with \a noise. */
void
expectBoxes (const View& view, const std::vector<int>& boxes, float noise)
{
  const Objects objects = extract (view);
  EXPECT_EQ (objects.size(), boxes.size()) << noise;
  for (const int box : boxes)
    EXPECT_GT (bestIou (objects, view, box), 0.8) << noise << " " << box;
}

/** These boxes of \a scene are its objects, without noise and with some. */
void
expectBoxesInNoise (const std::vector<Box>& scene,
                    const Camera& camera,
                    const std::vector<int>& boxes)
{
  for (const float noise : {0.f, 0.5f, 1.f})
    expectBoxes (look (scene, camera, noise), boxes, noise);
}

} // namespace

TEST (ObjectBackground, WallBehindATableIsNoObject)
{
  const View view = wallBehindATable();
  const Objects objects = extract (view);
  EXPECT_GT (bestIou (objects, view, 6), 0.9);
  const auto of_wall = view.pixelsOf (2);
  for (const auto& object : objects)
    EXPECT_EQ (of_wall.count (object.indices.indices.front()), 0u);
}

TEST (ObjectBackground, AThingThatReachesALowPanelBehindItsTableIsAnObject)
{
  const Box panel{{1.665f, 0.f, table_height}, {0.02f, 1.f, 0.2f}};
  const Box sticking_out = onTable (1.6f, 0.f, {0.1f, 0.1f, 0.15f});
  expectBoxesInNoise ({floor_slab, table, panel, sticking_out}, {}, {3});
}

TEST (ObjectBackground, WallsAndLegsOfTheTableAreNoObjects)
{
  const Box wall{{1.65f, 0.f, 0.f}, {0.1f, 4.f, 2.f}};
  const Box leg{{0.9f, 0.3f, 0.f}, {0.06f, 0.06f, 0.66f}};
  Camera camera;
  camera.height = 1.3f;
  const View view = look (
      {floor_slab, table, wall, leg, onTable (1.3f, 0.f, {0.1f, 0.1f, 0.1f})}, camera);
  ASSERT_GT (view.pixelsOf (2).size(), 1000u);
  ASSERT_GT (view.pixelsOf (3).size(), 100u);
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_GT (iou (objects.front(), view, 4), 0.85);
}

TEST (ObjectBackground, ThingsOnAllBoardsOfAShelfAreObjects)
{
  const Vector3f size (0.1f, 0.1f, 0.15f);
  const auto board = [] (float height) {
    return Box{{1.3f, 0.f, height - 0.02f}, {0.35f, 1.f, 0.02f}};
  };
  for (const float noise : {0.f, 1.f}) {
    const View view = look ({floor_slab,
                             board (0.4f),
                             board (0.8f),
                             {{1.25f, -0.2f, 0.4f}, size},
                             {{1.25f, 0.2f, 0.4f}, size},
                             {{1.3f, 0.f, 0.8f}, size}},
                            {},
                            noise);
    expectBoxes (view, {3, 4, 5}, noise);
  }
}

/** Its top is in the middle of the thing, but elsewhere. */
TEST (ObjectBackground, AHigherTableDoesNotCutThingsOnALowerOne)
{
  const Box lower{{1.2f, 0.6f, 0.46f}, {0.6f, 0.6f, 0.04f}};
  const Box higher{{1.2f, -0.6f, 0.6f}, {0.6f, 0.6f, 0.04f}};
  const Box bottle{{1.2f, 0.6f, 0.5f}, {0.08f, 0.08f, 0.28f}};
  const View view = look ({floor_slab, lower, higher, bottle});
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_GT (iou (objects.front(), view, 3), 0.85);
}

TEST (ObjectBackground, ThingsAtAWallAreObjects)
{
  const Box wall{{1.65f, 0.f, 0.f}, {0.1f, 4.f, 2.f}};
  const Vector3f size (0.1f, 0.1f, 0.15f);
  expectBoxesInNoise ({floor_slab,
                       table,
                       wall,
                       onTable (1.55f, 0.3f, size),
                       onTable (1.545f, 0.f, size),
                       onTable (1.53f, -0.3f, size)},
                      {},
                      {3, 4, 5});
}

/** The front of the table, in one plane with theirs, is no wall behind them. */
TEST (ObjectBackground, ThingsAtTheNearEdgeOfATableAreObjects)
{
  const Vector3f size (0.07f, 0.1f, 0.1f);
  const Box chest{{1.2f, 0.f, 0.3f}, {0.8f, 1.f, 0.4f}};
  for (const Box& with_front : {table, chest})
    for (const float noise : {0.f, 0.5f, 1.f})
      for (const float inset : {0.f, 0.005f}) {
        const float x = 0.8f + inset + 0.5f * size.x();
        View view = look (
            {floor_slab, with_front, onTable (x, 0.2f, size), onTable (x, -0.2f, size)},
            {},
            noise);
        joinFaces (view);
        SCOPED_TRACE (inset);
        expectBoxes (view, {2, 3}, noise);
      }
}

/** The image ends less than 30 cm above the table. At its left there may be a band without depth,
 * as in images of stereo cameras. */
TEST (ObjectBackground, ThingsAtAWallOfWhichLittleIsSeenAreObjects)
{
  const Camera looks_down{1.3f, 0.7f};
  const Box wide_table{{0.9f, 0.f, 0.66f}, {0.8f, 4.f, 0.04f}};
  const Box wall{{1.35f, 0.f, 0.f}, {0.1f, 4.f, 2.f}};
  const Vector3f size (0.1f, 0.1f, 0.1f);
  for (const float noise : {0.f, 0.5f, 1.f})
    for (const std::uint32_t band : {0, 30, 60, 90}) {
      View view = look ({floor_slab,
                         wide_table,
                         wall,
                         onTable (1.25f, 0.2f, size),
                         onTable (1.25f, -0.2f, size)},
                        looks_down,
                        noise);
      for (std::uint32_t v = 0; v < view.cloud->height; ++v)
        for (std::uint32_t u = 0; u < band; ++u)
          view.cloud->at (u, v).x = std::numeric_limits<float>::quiet_NaN();
      SCOPED_TRACE (band);
      expectBoxes (view, {3, 4}, noise);
    }
}

/** Faces in one plane are one, from one side of the image to the other, with gaps. */
TEST (ObjectBackground, FacesInARowAreNoWall)
{
  std::vector<Box> boxes{floor_slab, deep_table};
  for (int i = -6; i <= 6; ++i)
    boxes.push_back (
        onTable (1.3f, 0.2f * static_cast<float> (i), {0.1f, 0.15f, 0.1f}));
  View view = look (boxes);
  joinFaces (view);
  const Objects objects = extract (view);
  for (const int in_the_middle : {7, 8, 9})
    EXPECT_GT (bestIou (objects, view, in_the_middle), 0.9);
}

TEST (ObjectBackground, ThingsInACornerOfWallsAreObjects)
{
  const Box wall{{1.65f, 0.f, 0.f}, {0.1f, 4.f, 2.f}};
  const Box side{{1.2f, 0.55f, 0.f}, {0.8f, 0.1f, 2.f}};
  for (const float width : {0.1f, 0.2f})
    for (const float noise : {0.f, 0.5f, 1.f}) {
      const Box thing =
          onTable (1.59f - 0.5f * width, 0.49f - 0.5f * width, {width, width, 0.25f});
      const View view = look ({floor_slab, table, wall, side, thing}, {}, noise);
      const Objects objects = extract (view);
      EXPECT_EQ (objects.size(), 1u) << width << " " << noise;
      EXPECT_GT (bestIou (objects, view, 4), 0.8) << width << " " << noise;
    }
}

TEST (ObjectBackground, WhatHardlyStandsOutFromAWallIsNoObject)
{
  const Box wall{{1.65f, 0.f, 0.f}, {0.1f, 4.f, 2.f}};
  const auto atWall = [&] (float thickness) {
    const Box panel{{1.6f - 0.5f * thickness, 0.f, table_height + 0.02f},
                    {thickness, 0.3f, 0.15f}};
    const View view = look ({floor_slab, table, wall, panel});
    EXPECT_GT (view.pixelsOf (3).size(), 1000u);
    return extract (view).size();
  };
  EXPECT_EQ (atWall (0.01f), 0u);
  EXPECT_EQ (atWall (0.08f), 1u);
}

TEST (ObjectBackground, WhatGoesOnBehindSomethingNearerIsNoObject)
{
  const Box post{{2.f, 0.f, 0.f}, {0.08f, 0.08f, 1.f}};
  const Box stump{{2.f, 0.f, 0.f}, {0.08f, 0.08f, 0.2f}};
  // It hides what is higher than 25 cm at the post.
  const Box beam{{1.5f, 0.f, 0.54f}, {0.05f, 0.6f, 0.6f}};
  for (const float roll : {0.f, 0.1f, 0.2f, 0.5f, 1.f, 1.5f, 1.9f}) {
    Camera camera;
    camera.roll = roll * static_cast<float> (M_PI);
    const View hidden = look ({floor_slab, post, beam}, camera);
    ASSERT_GT (hidden.pixelsOf (1).size(), 200u);
    const View seen = look ({floor_slab, stump, beam}, camera);
    EXPECT_TRUE (extract (hidden).empty()) << roll;
    EXPECT_TRUE (extract (turned (hidden)).empty()) << roll;
    EXPECT_EQ (extract (seen).size(), 1u) << roll;
    EXPECT_EQ (extract (turned (seen)).size(), 1u) << roll;
  }
}

TEST (ObjectBackground, SpecksAboveAThingHideNothing)
{
  View view = look ({floor_slab, table, onTable (1.1f, 0.f, {0.1f, 0.1f, 0.1f})});
  const auto width = static_cast<pcl::index_t> (view.cloud->width);
  const auto pixels = view.pixelsOf (2);
  for (const pcl::index_t i : pixels)
    if (!pixels.count (i - width)) {
      // Nearer than the thing, and far from each other.
      const auto speck = static_cast<std::size_t> (i - 2 * width);
      (*view.cloud)[speck].getVector3fMap() *= 0.3f + 0.1f * static_cast<float> (i % 3);
      (*view.cloud)[speck + view.cloud->width].x =
          std::numeric_limits<float>::quiet_NaN();
    }
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_GT (iou (objects[0], view, 2), 0.9);
}

TEST (ObjectBackground, TallThingsAreNoObjects)
{
  const auto withHeight = [] (float height) {
    return look ({floor_slab, table, onTable (1.3f, 0.f, {0.1f, 0.1f, height})});
  };
  Extraction extraction;
  EXPECT_EQ (extract (extraction, withHeight (0.295f)).size(), 1u);
  for (const float height : {0.32f, 0.34f, 0.4f})
    EXPECT_TRUE (extract (extraction, withHeight (height)).empty()) << height;
  extraction.setMaxObjectHeight (0.45);
  EXPECT_EQ (extract (extraction, withHeight (0.4f)).size(), 1u);
}

/** The top of a crate is level with where what is too high begins. */
TEST (ObjectBackground, TallThingsBesideACrateAreNoObjects)
{
  const Box post{{2.6f, -0.3f, 0.f}, {0.25f, 0.25f, 1.7f}};
  for (const float height : {0.305f, 0.31f, 0.315f, 0.32f}) {
    const Box crate{{2.f, 0.7f, 0.f}, {0.4f, 0.5f, height}};
    View view = look ({floor_slab, crate, post}, {1.2f, 0.45f}, 0.5f);
    const std::size_t floor = view.top.at (0), top = view.top.at (1);
    // What is tall may be no plane, as a person.
    view.models = {view.models[floor], view.models[top]};
    view.inliers = {view.inliers[floor], view.inliers[top]};
    EXPECT_TRUE (extract (view).empty()) << height;
  }
}

/** However few pixels wide they are. */
TEST (ObjectBackground, PolesAreNoObjects)
{
  Camera camera;
  camera.width = 640;
  camera.image_height = 480;
  camera.pitch_down = 0.45f;
  for (const float width : {0.012f, 0.02f, 0.03f, 0.08f})
    for (const float x : {1.5f, 2.f, 2.5f})
      for (const float noise : {0.f, 1.f}) {
        const auto objects = [&] (float height) {
          const Box pole{{x, 0.f, 0.f}, {width, width, height}};
          return extract (look ({floor_slab, pole}, camera, noise)).size();
        };
        EXPECT_EQ (objects (1.f), 0u) << width << " " << x << " " << noise;
        // What noise parts is more than one.
        if (width > 0.015f) {
          EXPECT_GE (objects (0.28f), 1u) << width << " " << x << " " << noise;
        }
      }
}

TEST (ObjectBackground, WhatTheImageCutsIsTruncatedAndNotGraspable)
{
  // At x = 1.2 m the image ends 0.8 m to the side. Cameras have margins without depth.
  const auto isTruncated = [] (float y, std::uint32_t margin) {
    const View view =
        look ({floor_slab, deep_table, onTable (1.2f, y, {0.08f, 0.08f, 0.15f})});
    for (std::uint32_t i = 0; i < view.cloud->size(); ++i)
      if (const std::uint32_t u = i % 320; u < margin || u + margin >= 320)
        (*view.cloud)[i].getVector3fMap().setConstant (
            std::numeric_limits<float>::quiet_NaN());
    const Objects objects = extract (view);
    EXPECT_EQ (objects.size(), 1u) << y << " " << margin;
    EXPECT_NE (objects.front().truncated, objects.front().graspable);
    return objects.front().truncated;
  };
  EXPECT_FALSE (isTruncated (0.f, 0));
  EXPECT_FALSE (isTruncated (0.f, 10));
  for (const float side : {1.f, -1.f}) {
    EXPECT_TRUE (isTruncated (side * 0.8f, 0));
    EXPECT_TRUE (isTruncated (side * 0.75f, 10));
    EXPECT_TRUE (isTruncated (side * 0.65f, 30));
    EXPECT_FALSE (isTruncated (side * 0.4f, 30));
  }
}

/** Nothing is measured but the table and these, as in a hall. */
TEST (ObjectBackground, WhatStandsBeforeNoBackgroundIsNotTruncated)
{
  for (const float height : {0.05f, 0.12f, 0.25f})
    for (const float x : {0.9f, 1.2f, 1.5f})
      for (const float y : {-0.3f, 0.f, 0.3f}) {
        const View view = look ({table, onTable (x, y, {0.08f, 0.08f, height})});
        const Objects objects = extract (view);
        ASSERT_EQ (objects.size(), 1u) << height << ' ' << x << ' ' << y;
        EXPECT_FALSE (objects.front().truncated) << height << ' ' << x << ' ' << y;
        EXPECT_TRUE (objects.front().graspable) << height << ' ' << x << ' ' << y;
      }
}

TEST (ObjectBackground, WallsThatTheImageCutsAreNoObjects)
{
  // The image ends less than 30 cm above the floor, at a wall and at a box of 29 cm.
  const Camera looks_down{1.4f, 0.85f};
  const Box wall{{2.7f, 0.f, 0.f}, {0.2f, 6.f, 2.f}};
  const Box corner{{0.f, 1.1f, 0.f}, {6.f, 0.2f, 2.f}};
  const Box box{{2.7f, 0.3f, 0.f}, {0.1f, 0.2f, 0.29f}};
  for (const float noise : {0.f, 1.f}) {
    EXPECT_TRUE (extract (look ({floor_slab, wall}, looks_down, noise)).empty());
    EXPECT_TRUE (
        extract (look ({floor_slab, wall, corner}, looks_down, noise)).empty());
    const Objects objects = extract (look ({floor_slab, box}, looks_down, noise));
    ASSERT_EQ (objects.size(), 1u);
    EXPECT_TRUE (objects.front().truncated);
  }
}
