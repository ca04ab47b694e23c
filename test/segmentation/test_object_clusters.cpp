// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "table_objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

using namespace table_objects;

namespace {

/** It sees the tops of things on deep_table at a flat angle. */
const Camera camera_near_tops{1.25f, 0.4f};

Camera
smallCameraNearTops ()
{
  Camera camera = camera_near_tops;
  camera.width = 160;
  camera.image_height = 120;
  return camera;
}

} // namespace

TEST (ObjectClusters, ApartObjects)
{
  const View view = look ({floor_slab,
                           table,
                           onTable (1.f, 0.2f, {0.06f, 0.06f, 0.1f}),
                           onTable (1.f, 0.115f, {0.06f, 0.06f, 0.1f}),
                           onTable (1.25f, -0.2f, {0.1f, 0.1f, 0.03f})});
  const Objects objects = extract (view);
  EXPECT_EQ (objects.size(), 3u);
  for (const int box : {2, 3, 4})
    EXPECT_GT (bestIou (objects, view, box), 0.8) << box;
}

TEST (ObjectClusters, ClusterTolerance)
{
  // One is 3 cm behind the other.
  const View view = look ({floor_slab,
                           table,
                           onTable (1.f, 0.1f, {0.06f, 0.06f, 0.1f}),
                           onTable (1.09f, 0.1f, {0.06f, 0.06f, 0.1f})});
  Extraction extraction;
  EXPECT_EQ (extract (extraction, view).size(), 2u);
  extraction.setClusterTolerance (10.);
  EXPECT_EQ (extract (extraction, view).size(), 1u);
  EXPECT_EQ (extraction.getClusterTolerance(), 10.);
  extraction.setClusterTolerance (-1.);
  EXPECT_EQ (extraction.getClusterTolerance(), 10.);
}

TEST (ObjectClusters, LinesOfPixelsWithoutDepthSplitNothing)
{
  // As in depth that was registered with a camera of more pixels.
  Camera camera;
  camera.width = 640;
  camera.image_height = 480;
  View view =
      look ({floor_slab, table, onTable (1.f, 0.1f, {0.1f, 0.1f, 0.15f})}, camera, 1.f);
  for (std::uint32_t v = 0; v < view.cloud->height; ++v)
    for (std::uint32_t u = 0; u < view.cloud->width; ++u)
      if (u % 8 == 7 || v % 8 == 7)
        view.cloud->at (u, v).getVector3fMap().setConstant (
            std::numeric_limits<float>::quiet_NaN());
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_GT (iou (objects.front(), view, 2), 0.7);
}

TEST (ObjectClusters, TopsSeenAtAFlatAngle)
{
  // Rows of the top are 6 cm apart, which is more than elsewhere on an object.
  const Box box{{1.8f, 0.1f, 0.7f}, {0.2f, 0.25f, 0.12f}};
  const View view = look ({floor_slab, deep_table, box}, smallCameraNearTops());
  Extraction extraction;
  extraction.setMinPoints (20);
  const Objects objects = extract (extraction, view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_GT (iou (objects.front(), view, 2), 0.9);
  EXPECT_LT (
      (sorted (objects.front().box_size) - sorted (box.size)).cwiseAbs().maxCoeff(),
      0.05f)
      << objects.front().box_size.transpose();
}

TEST (ObjectClusters, SidesSeenAtAFlatAngleByPreciseSensors)
{
  // Neighbours on one side are many widths of a pixel apart, which is much without noise.
  Camera camera;
  camera.width = 1280;
  camera.image_height = 960;
  const View view = look (
      {floor_slab, table, onTable (1.f, 0.3f, {0.1f, 0.1f, 0.12f}, 1.4f)}, camera);
  Extraction extraction;
  extraction.setDepthNoise ({0.0001f, 0.f});
  const Objects objects = extract (extraction, view);
  EXPECT_EQ (objects.size(), 1u);
  EXPECT_GT (bestIou (objects, view, 2), 0.97);
}

TEST (ObjectClusters, SidesSeenFromStraightAboveAreNoObjects)
{
  Camera camera{1.3f, 1.57f};
  camera.width = 640;
  camera.image_height = 480;
  std::vector<Box> boxes{floor_slab, {{0.f, 0.f, 0.66f}, {0.8f, 1.f, 0.04f}}};
  for (const float x : {-0.08f, 0.08f})
    for (const float y : {-0.08f, 0.08f})
      boxes.push_back (onTable (x, y, {0.07f, 0.08f, 0.06f}));
  for (const float noise : {0.f, 1.f}) {
    const View view = look (boxes, camera, noise);
    const Objects objects = extract (view);
    EXPECT_EQ (objects.size(), 4u) << noise;
  }
}

TEST (ObjectClusters, TallSidesSeenFromAboveAreOfTheirBoxes)
{
  // Neighbours on one side are up to 5 cm apart.
  for (const float roll : {0.f, 1.57f}) {
    const Camera camera{1.6f, 1.4f, roll};
    std::vector<Box> boxes{floor_slab, {{0.1f, 0.f, 0.66f}, {0.8f, 1.f, 0.04f}}};
    for (const float x : {-0.1f, 0.25f})
      for (const float y : {-0.18f, 0.f, 0.18f})
        boxes.push_back (onTable (x, y, {0.06f, 0.08f, 0.2f}, 0.3f + x));
    const View view = look (boxes, camera, 1.f);
    const Objects objects = extract (view);
    EXPECT_EQ (objects.size(), 6u) << roll;
    for (int box = 2; box < 8; ++box)
      EXPECT_GT (bestIou (objects, view, box), 0.8) << roll << ' ' << box;
  }
}

TEST (ObjectClusters, WhatStandsBehindATopIsAnother)
{
  const Box front{{1.6f, 0.f, 0.7f}, {0.1f, 0.1f, 0.1f}};
  const Box behind{{1.75f, 0.05f, 0.7f}, {0.1f, 0.1f, 0.2f}};
  const View view = look ({floor_slab, deep_table, front, behind}, camera_near_tops);
  const Objects objects = extract (view);
  EXPECT_EQ (objects.size(), 2u);
  for (const int box : {2, 3})
    EXPECT_GT (bestIou (objects, view, box), 0.85) << box;
}

TEST (ObjectClusters, SplitsTouchingObjects)
{
  // The second one is lower and 2 cm further from the camera.
  const View view = look ({floor_slab,
                           table,
                           onTable (1.f, -0.25f, {0.1f, 0.1f, 0.15f}),
                           onTable (1.02f, -0.15f, {0.1f, 0.1f, 0.08f})});
  Extraction extraction;
  EXPECT_EQ (extract (extraction, view).size(), 1u);
  extraction.setSplitAtConcaveEdges (true);
  const Objects objects = extract (extraction, view);
  EXPECT_EQ (objects.size(), 2u);
  for (const int box : {2, 3})
    EXPECT_GT (bestIou (objects, view, box), 0.85) << box;
}

TEST (ObjectClusters, SplitsASmallObjectFromALargeOneBehind)
{
  // Neighbours on the two are as far apart as on their tops; the small one has 48 points.
  const View view = look ({floor_slab,
                           deep_table,
                           Box{{1.9f, 0.1f, 0.7f}, {0.15f, 0.15f, 0.2f}},
                           Box{{1.75f, 0.1f, 0.7f}, {0.09f, 0.09f, 0.09f}}},
                          smallCameraNearTops());
  Extraction extraction;
  extraction.setMinPoints (30);
  extraction.setSplitAtConcaveEdges (true);
  const Objects objects = extract (extraction, view);
  EXPECT_EQ (objects.size(), 2u);
  for (const int box : {2, 3})
    EXPECT_GT (bestIou (objects, view, box), 0.8) << box;
}

TEST (ObjectClusters, SplitKeepsAConvexObjectWhole)
{
  const View view =
      look ({floor_slab, table, onTable (1.f, 0.f, {0.15f, 0.15f, 0.15f}, 0.7f)});
  Extraction extraction;
  extraction.setSplitAtConcaveEdges (true);
  EXPECT_EQ (extract (extraction, view).size(), 1u);
}

TEST (ObjectClusters, SplitKeepsBoxesWholeUnderTheNoiseThatIsSet)
{
  for (const Camera& pose : {Camera{1.4f, 0.7f}, Camera{0.9f, 0.15f}}) {
    Camera camera = pose;
    camera.width = 640;
    camera.image_height = 480;
    const View view = look ({floor_slab,
                             table,
                             onTable (0.95f, 0.2f, {0.08f, 0.06f, 0.1f}, 0.3f),
                             onTable (0.95f, -0.2f, {0.12f, 0.1f, 0.06f}, 0.8f),
                             onTable (1.15f, 0.f, {0.08f, 0.08f, 0.2f})},
                            camera,
                            1.f);
    Extraction extraction;
    extraction.setSplitAtConcaveEdges (true);
    EXPECT_EQ (extract (extraction, view).size(), 3u) << camera.height;
  }
}

/** Cells of such images are large, and few of them have the points of an object. */
TEST (ObjectClusters, SplitKeepsAConvexObjectWholeInLargeImages)
{
  Camera camera;
  camera.width = 1920;
  camera.image_height = 1080;
  const View view =
      look ({floor_slab, table, onTable (1.f, 0.f, {0.15f, 0.15f, 0.15f}, 0.7f)},
            camera,
            1.5f);
  Extraction extraction;
  extraction.setSplitAtConcaveEdges (true);
  EXPECT_EQ (extract (extraction, view).size(), 1u);
}

TEST (ObjectClusters, ObjectOnAnObject)
{
  const View view = look ({floor_slab,
                           table,
                           onTable (1.1f, 0.f, {0.2f, 0.2f, 0.08f}),
                           {{1.1f, 0.f, table_height + 0.08f}, {0.08f, 0.08f, 0.08f}}});
  Extraction extraction;
  Objects objects = extract (extraction, view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_NEAR (objects.front().box_size.z(), 0.16f, 0.005f);
  EXPECT_EQ (objects.front().support, view.top.at (1));

  extraction.setSplitAtConcaveEdges (true);
  objects = extract (extraction, view);
  ASSERT_EQ (objects.size(), 2u);
  for (const auto& object : objects) {
    const bool is_upper = iou (object, view, 3) > iou (object, view, 2);
    EXPECT_GT (iou (object, view, is_upper ? 3 : 2), 0.85);
    EXPECT_EQ (object.support, view.top.at (is_upper ? 2 : 1));
    EXPECT_NEAR (object.box_size.z(), 0.08f, 0.005f);
  }
}

TEST (ObjectClusters, EachOfAStackRestsOnTheOneBelow)
{
  const View view = look ({floor_slab,
                           table,
                           onTable (1.1f, 0.f, {0.26f, 0.26f, 0.07f}),
                           {{1.1f, 0.f, table_height + 0.07f}, {0.18f, 0.18f, 0.07f}},
                           {{1.1f, 0.f, table_height + 0.14f}, {0.08f, 0.08f, 0.07f}}});
  Extraction extraction;
  extraction.setSplitAtConcaveEdges (true);
  const Objects objects = extract (extraction, view);
  ASSERT_EQ (objects.size(), 3u);
  for (const auto& object : objects) {
    int box = 2;
    while (iou (object, view, box) < 0.5 && box < 4)
      ++box;
    EXPECT_EQ (object.support, view.top.at (box - 1));
    EXPECT_NEAR (object.box_size.z(), 0.07f, 0.005f);
  }
}

TEST (ObjectClusters, WhatIsOnAStackHigherThanObjectsIsAnObject)
{
  const View view = look ({floor_slab,
                           {{1.2f, 0.f, 0.f}, {0.5f, 0.5f, 0.2f}},
                           {{1.2f, 0.f, 0.2f}, {0.4f, 0.4f, 0.2f}},
                           {{1.2f, 0.f, 0.4f}, {0.08f, 0.08f, 0.1f}}});
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_GT (iou (objects.front(), view, 3), 0.85);
  EXPECT_EQ (objects.front().support, view.top.at (2));
}

TEST (ObjectClusters, FootOfAnObjectOnAnObject)
{
  // Noise explains the heights of an eighth of the points of the upper box.
  const Box upper{{1.1f, 0.f, table_height + 0.08f}, {0.04f, 0.1f, 0.02f}};
  const View view =
      look ({floor_slab, table, onTable (1.1f, 0.f, {0.2f, 0.2f, 0.08f}), upper},
            Camera(),
            1.f);
  Extraction extraction;
  extraction.setMinPoints (40);
  extraction.setSplitAtConcaveEdges (true);
  const Objects objects = extract (extraction, view);
  ASSERT_EQ (objects.size(), 2u);
  for (const auto& object : objects) {
    const bool is_upper = iou (object, view, 3) > 0.5;
    EXPECT_EQ (object.support, view.top.at (is_upper ? 2 : 1));
    EXPECT_NEAR (object.box_size.z(), is_upper ? 0.02f : 0.08f, 0.006f);
  }
}

TEST (ObjectClusters, WhatStandsBetweenTopsThatAreOnePlaneIsOnNone)
{
  View view = look ({floor_slab,
                     table,
                     onTable (1.1f, 0.2f, {0.15f, 0.15f, 0.02f}),
                     onTable (1.1f, -0.2f, {0.15f, 0.15f, 0.02f}),
                     onTable (1.1f, 0.f, {0.06f, 0.06f, 0.2f})});
  const std::size_t tops = view.top.at (2), other_top = view.top.at (3);
  auto& inliers = view.inliers[tops].indices;
  auto& others = view.inliers[other_top].indices;
  inliers.insert (inliers.end(), others.begin(), others.end());
  std::sort (inliers.begin(), inliers.end());
  others.clear();

  Extraction extraction;
  extraction.setSplitAtConcaveEdges (true);
  const Objects objects = extract (extraction, view);
  ASSERT_EQ (objects.size(), 3u);
  for (const auto& object : objects) {
    EXPECT_EQ (object.support, view.top.at (1));
    EXPECT_NEAR (
        object.box_size.z(), iou (object, view, 4) > 0.5 ? 0.2f : 0.02f, 0.005f);
  }
}

TEST (ObjectClusters, ObjectOnTopsThatAreOnePlane)
{
  View view = look ({floor_slab,
                     table,
                     onTable (1.1f, 0.2f, {0.2f, 0.2f, 0.08f}),
                     onTable (1.1f, -0.2f, {0.2f, 0.2f, 0.08f}),
                     {{1.1f, 0.2f, table_height + 0.08f}, {0.08f, 0.08f, 0.08f}}});
  const std::size_t tops = view.top.at (2), other_top = view.top.at (3);
  auto& inliers = view.inliers[tops].indices;
  inliers.insert (inliers.end(),
                  view.inliers[other_top].indices.begin(),
                  view.inliers[other_top].indices.end());
  std::sort (inliers.begin(), inliers.end());
  view.models[other_top] = view.models[tops];
  view.inliers[other_top].indices.clear();

  Extraction extraction;
  extraction.setSplitAtConcaveEdges (true);
  const Objects objects = extract (extraction, view);
  ASSERT_EQ (objects.size(), 3u);
  for (const auto& object : objects) {
    const bool is_upper = iou (object, view, 4) > 0.5;
    EXPECT_EQ (object.support, is_upper ? tops : view.top.at (1));
    EXPECT_NEAR (object.box_size.z(), 0.08f, 0.005f);
  }
}
