// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "count_allocations.h"
#include "table_scenes.h"

#include <pcl/common/transforms.h>
#include <pcl/segmentation/supported_object_extraction.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using Eigen::Vector3f;
using table_scenes::Box;
using table_scenes::Camera;
using table_scenes::look;
using table_scenes::View;
using Extraction = pcl::SupportedObjectExtraction<pcl::PointXYZ, pcl::Normal>;
using Objects = std::vector<pcl::SupportedObject>;

namespace {

const Box floor_slab{{3.f, 0.f, -0.1f}, {8.f, 8.f, 0.1f}};
const Box table{{1.2f, 0.f, 0.66f}, {0.8f, 1.f, 0.04f}};
constexpr float table_height = 0.7f;

/** It sees the tops of things on deep_table at a flat angle. */
const Camera camera_near_tops{1.25f, 0.4f};
const Box deep_table{{2.f, 0.f, 0.66f}, {2.f, 2.f, 0.04f}};

Box
onTable (float x, float y, const Vector3f& size, float yaw = 0.f)
{
  return {{x, y, table_height}, size, yaw};
}

/** Box 2 is the wall, box 6 a mug on the table. A part of the wall, that a frame in front cuts
 * out, is as high as an object. */
View
wallBehindATable ()
{
  const Box wall{{1.66f, 0.f, 0.f}, {0.1f, 4.f, 2.f}};
  const Box left = onTable (1.5f, 0.25f, {0.05f, 0.1f, 0.25f});
  const Box right = onTable (1.5f, -0.25f, {0.05f, 0.1f, 0.25f});
  const Box beam{{1.5f, 0.f, table_height + 0.25f}, {0.05f, 0.6f, 0.3f}};
  const Box mug = onTable (1.1f, 0.1f, {0.08f, 0.08f, 0.1f});
  return look ({floor_slab, table, wall, left, right, beam, mug});
}

Objects
extract (Extraction& extraction, const View& view)
{
  extraction.setCameraToBase (view.camera_to_base);
  extraction.setInputCloud (view.cloud);
  extraction.setInputNormals (view.normals);
  Objects objects (3); // what is in there must not stay
  extraction.extract (view.models, view.inliers, objects);
  return objects;
}

Objects
extract (const View& view)
{
  Extraction extraction;
  return extract (extraction, view);
}

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

/** Intersection over union of an object and the pixels of a box. */
double
iou (const pcl::SupportedObject& object, const View& view, int box)
{
  const auto truth = view.pixelsOf (box);
  const auto both = std::count_if (object.indices.indices.begin(),
                                   object.indices.indices.end(),
                                   [&] (auto i) { return truth.count (i) != 0; });
  return static_cast<double> (both) /
         static_cast<double> (truth.size() + object.indices.indices.size() - both);
}

/** The best of iou() over the objects. */
double
bestIou (const Objects& objects, const View& view, int box)
{
  double best = 0.;
  for (const auto& object : objects)
    best = std::max (best, iou (object, view, box));
  return best;
}

Vector3f
sorted (Vector3f size)
{
  if (size.x() > size.y())
    std::swap (size.x(), size.y());
  return size;
}

} // namespace

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

TEST (SupportedObjectExtraction, WallBehindATableIsNoObject)
{
  const View view = wallBehindATable();
  const Objects objects = extract (view);
  EXPECT_GT (bestIou (objects, view, 6), 0.9);
  const auto of_wall = view.pixelsOf (2);
  for (const auto& object : objects)
    EXPECT_EQ (of_wall.count (object.indices.indices.front()), 0u);
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
      for (const auto& corner : support.outline.corners()) {
        const Vector3f p = view.camera_to_base * support.unproject (corner);
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

TEST (SupportedObjectExtraction, HeightsOfPlanes)
{
  const View view = look ({floor_slab, table, onTable (1.1f, 0.f, {0.1f, 0.1f, 0.1f})});
  Extraction extraction;
  extraction.setPlaneHeights (0.65, 0.75);
  EXPECT_EQ (extract (extraction, view).size(), 1u);
  extraction.setPlaneHeights (0.72, 1.2);
  EXPECT_TRUE (extract (extraction, view).empty());
  extraction.setPlaneHeights (0.1, 0.68);
  EXPECT_TRUE (extract (extraction, view).empty());
}

TEST (SupportedObjectExtraction, HorizontalTolerance)
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

TEST (SupportedObjectExtraction, TallThingsAreNoObjects)
{
  const View view = look ({floor_slab, table, onTable (1.3f, 0.f, {0.1f, 0.1f, 0.4f})});
  Extraction extraction;
  EXPECT_TRUE (extract (extraction, view).empty());
  extraction.setMaxObjectHeight (0.45);
  EXPECT_EQ (extract (extraction, view).size(), 1u);
}

/** The top of a crate is level with where what is too high begins. */
TEST (SupportedObjectExtraction, TallThingsBesideACrateAreNoObjects)
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

TEST (SupportedObjectExtraction, HullTolerance)
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

TEST (SupportedObjectExtraction, ThingsBesideATurnedTableAreNotOnIt)
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

TEST (SupportedObjectExtraction, DefaultsAreThoseOfThePaper)
{
  const Extraction extraction;
  EXPECT_FLOAT_EQ (extraction.getMinPlaneHeight(), 0.f);
  EXPECT_FLOAT_EQ (extraction.getMaxPlaneHeight(), 1.2f);
  EXPECT_FLOAT_EQ (extraction.getMaxObjectHeight(), 0.3f);
  EXPECT_EQ (extraction.getMinPoints(), 50u);
  EXPECT_FLOAT_EQ (extraction.getMinGraspableSide(), 0.01f);
  EXPECT_FLOAT_EQ (extraction.getMaxGraspableSide(), 0.1f);
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

TEST (SupportedObjectExtraction, TopsSeenAtAFlatAngle)
{
  // Rows of the top are 6 cm apart, which is more than elsewhere on an object.
  Camera camera = camera_near_tops;
  camera.width = 160;
  camera.image_height = 120;
  const Box box{{1.8f, 0.1f, 0.7f}, {0.2f, 0.25f, 0.12f}};
  const View view = look ({floor_slab, deep_table, box}, camera);
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

TEST (SupportedObjectExtraction, SidesSeenAtAFlatAngleByPreciseSensors)
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

TEST (SupportedObjectExtraction, SidesSeenFromStraightAboveAreNoObjects)
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

TEST (SupportedObjectExtraction, WhatStandsBehindATopIsAnother)
{
  const Box front{{1.6f, 0.f, 0.7f}, {0.1f, 0.1f, 0.1f}};
  const Box behind{{1.75f, 0.05f, 0.7f}, {0.1f, 0.1f, 0.2f}};
  const View view = look ({floor_slab, deep_table, front, behind}, camera_near_tops);
  const Objects objects = extract (view);
  EXPECT_EQ (objects.size(), 2u);
  for (const int box : {2, 3})
    EXPECT_GT (bestIou (objects, view, box), 0.85) << box;
}

TEST (SupportedObjectExtraction, ApartObjects)
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

TEST (SupportedObjectExtraction, ClusterTolerance)
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

TEST (SupportedObjectExtraction, SplitsTouchingObjects)
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

TEST (SupportedObjectExtraction, SplitKeepsAConvexObjectWhole)
{
  const View view =
      look ({floor_slab, table, onTable (1.f, 0.f, {0.15f, 0.15f, 0.15f}, 0.7f)});
  Extraction extraction;
  extraction.setSplitAtConcaveEdges (true);
  EXPECT_EQ (extract (extraction, view).size(), 1u);
}

/** Cells of such images are large, and few of them have the points of an object. */
TEST (SupportedObjectExtraction, SplitKeepsAConvexObjectWholeInLargeImages)
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

TEST (SupportedObjectExtraction, ObjectOnAnObject)
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

TEST (SupportedObjectExtraction, FootOfAnObjectOnAnObject)
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

TEST (SupportedObjectExtraction, ObjectOnTopsThatAreOnePlane)
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

TEST (SupportedObjectExtraction, SeveralTables)
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

TEST (SupportedObjectExtraction, TableCutByTheImage)
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

TEST (SupportedObjectExtraction, WallsAndThingsUnderTheTableAreNoObjects)
{
  const Box wall{{1.65f, 0.f, 0.f}, {0.1f, 4.f, 2.f}};
  const Box leg{{0.9f, 0.3f, 0.f}, {0.06f, 0.06f, 0.66f}};
  const Box under{{0.95f, -0.2f, 0.f}, {0.1f, 0.1f, 0.2f}};
  Camera camera;
  camera.height = 1.3f;
  const View view = look (
      {floor_slab, table, wall, leg, under, onTable (1.3f, 0.f, {0.1f, 0.1f, 0.1f})},
      camera);
  ASSERT_GT (view.pixelsOf (2).size(), 1000u);
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_GT (iou (objects.front(), view, 5), 0.85);
}

TEST (SupportedObjectExtraction, ThingsAtAWallAreObjects)
{
  const Box wall{{1.65f, 0.f, 0.f}, {0.1f, 4.f, 2.f}};
  const Vector3f size (0.1f, 0.1f, 0.15f);
  for (const float noise : {0.f, 0.5f, 1.f}) {
    const View view = look ({floor_slab,
                             table,
                             wall,
                             onTable (1.55f, 0.3f, size),
                             onTable (1.545f, 0.f, size),
                             onTable (1.53f, -0.3f, size)},
                            {},
                            noise);
    const Objects objects = extract (view);
    EXPECT_EQ (objects.size(), 3u) << noise;
    for (const int box : {3, 4, 5})
      EXPECT_GT (bestIou (objects, view, box), 0.8) << noise << " " << box;
  }
}

/** What is seen of the table has a hull without the corner that the thing hides. */
TEST (SupportedObjectExtraction, ThingsAtACornerOfATableAreObjects)
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

TEST (SupportedObjectExtraction, ThingsInACornerOfWallsAreObjects)
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

TEST (SupportedObjectExtraction, MaxOverhang)
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

TEST (SupportedObjectExtraction, WhatStandsBesideATableIsNoObjectOfIt)
{
  for (const float gap : {0.f, 0.01f, 0.05f, 0.15f}) {
    const Box chair{{1.2f, 0.6f + gap, 0.f}, {0.2f, 0.2f, 0.9f}};
    const View view = look ({floor_slab, table, chair});
    EXPECT_GT (view.pixelsOf (2).size(), 500u);
    EXPECT_TRUE (extract (view).empty()) << gap;
  }
}

TEST (SupportedObjectExtraction, WhatHardlyStandsOutFromAWallIsNoObject)
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

TEST (SupportedObjectExtraction, WhatGoesOnBehindSomethingNearerIsNoObject)
{
  const Box post{{2.f, 0.f, 0.f}, {0.08f, 0.08f, 1.f}};
  const Box stump{{2.f, 0.f, 0.f}, {0.08f, 0.08f, 0.2f}};
  // It hides what is higher than 25 cm at the post.
  const Box beam{{1.5f, 0.f, 0.54f}, {0.05f, 0.6f, 0.6f}};
  for (const float roll : {0.f, 0.5f, 1.f, 1.5f}) {
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

/** However few pixels wide they are. */
TEST (SupportedObjectExtraction, PolesAreNoObjects)
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

TEST (SupportedObjectExtraction, WhatTheImageCutsIsTruncatedAndNotGraspable)
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
  }
}

TEST (SupportedObjectExtraction, WallsThatTheImageCutsAreNoObjects)
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

TEST (SupportedObjectExtraction, ThingsOnTheFloorAreObjects)
{
  const View view = look ({floor_slab, {{1.5f, 0.f, 0.f}, {0.2f, 0.2f, 0.2f}}});
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_GT (iou (objects.front(), view, 1), 0.85);
}

TEST (SupportedObjectExtraction, MissingPoints)
{
  View view = look ({floor_slab, table, onTable (1.1f, 0.f, {0.1f, 0.1f, 0.1f})});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const float bad[3][3] = {{nan, nan, nan}, {inf, 0.f, inf}, {0.f, 0.f, 0.f}};
  std::mt19937 random (1);
  for (std::size_t i = 0; i < view.cloud->size(); ++i)
    if (random() % 20 == 0) {
      (*view.cloud)[i].getVector3fMap() =
          Eigen::Map<const Vector3f> (bad[random() % 3]);
      (*view.normals)[i].getNormalVector3fMap().setConstant (nan);
      view.box[i] = -1;
    }
  Extraction extraction;
  for (const bool split : {false, true}) {
    extraction.setSplitAtConcaveEdges (split);
    const Objects objects = extract (extraction, view);
    ASSERT_EQ (objects.size(), 1u);
    EXPECT_GT (iou (objects.front(), view, 2), 0.85);
    for (const auto i : objects.front().indices.indices)
      EXPECT_TRUE (pcl::rgbd_planes::isMeasured ((*view.cloud)[i].data));
  }
}

TEST (SupportedObjectExtraction, LabelsThatLeak)
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

TEST (SupportedObjectExtraction, OptimisesAModelThatOutliersSpoilt)
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
  EXPECT_NEAR (table_top->plane.d, true_d, 0.001f);
}

TEST (SupportedObjectExtraction, PlanesMayHaveAnySignAndLength)
{
  View view = look ({floor_slab, table, onTable (1.1f, 0.f, {0.1f, 0.1f, 0.1f})});
  const Objects expected = extract (view);
  ASSERT_EQ (expected.size(), 1u);
  for (auto& model : view.models)
    for (float& value : model.values)
      value *= -2.f;
  const Objects objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_EQ (objects[0].indices.indices, expected[0].indices.indices);
}

TEST (SupportedObjectExtraction, NoAllocationsForFramesLikeThoseBefore)
{
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "allocations are not counted together with the address sanitizer";
#endif
  // With a strip of the wall, which becomes a cluster, but no object.
  const View view = wallBehindATable();
  for (const bool split : {false, true}) {
    Extraction extraction;
    extraction.setSplitAtConcaveEdges (split);
    extraction.setCameraToBase (view.camera_to_base);
    extraction.setInputCloud (view.cloud);
    extraction.setInputNormals (view.normals);
    Objects objects;
    // Planes are sorted, and with them their memory: some frames later each has enough.
    for (int frame = 0; frame < 5; ++frame) {
      const std::size_t before = allocations;
      extraction.extract (view.models, view.inliers, objects);
      const std::size_t count = allocations - before;
      EXPECT_FALSE (objects.empty());
      if (frame == 0) {
        EXPECT_GT (count, 0u) << "the counter sees nothing";
      }
      if (frame == 4) {
        EXPECT_EQ (count, 0u) << (split ? "split" : "whole");
      }
    }
  }
}

TEST (SupportedObjectExtraction, HonoursIndices)
{
  const View view = look ({floor_slab,
                           table,
                           onTable (1.f, 0.2f, {0.1f, 0.1f, 0.1f}),
                           onTable (1.f, -0.2f, {0.1f, 0.1f, 0.1f})});
  const auto kept = view.pixelsOf (3);
  Extraction extraction;
  extraction.setIndices (pcl::make_shared<pcl::Indices> (kept.begin(), kept.end()));
  const Objects objects = extract (extraction, view);
  ASSERT_EQ (objects.size(), 1u);
  EXPECT_GT (iou (objects.front(), view, 3), 0.85);

  extraction.setIndices (pcl::IndicesPtr()); // the whole cloud again
  EXPECT_EQ (extract (extraction, view).size(), 2u);
}

TEST (SupportedObjectExtraction, AnotherSizeAndACopy)
{
  const std::vector<Box> boxes{
      floor_slab, table, onTable (1.1f, 0.f, {0.1f, 0.1f, 0.1f})};
  Camera small;
  small.width = 161;
  small.image_height = 121;
  Extraction extraction;
  extraction.setSplitAtConcaveEdges (true);
  const View large_view = look (boxes), small_view = look (boxes, small);
  const Objects first = extract (extraction, large_view);
  EXPECT_EQ (extract (extraction, small_view).size(), 1u);
  Extraction copy = extraction;
  const Objects again = extract (copy, large_view);
  ASSERT_EQ (first.size(), 1u);
  ASSERT_EQ (again.size(), 1u);
  EXPECT_EQ (first.front().indices.indices, again.front().indices.indices);
  EXPECT_EQ (first.front().box_size, again.front().box_size);
}

TEST (SupportedObjectExtraction, RefusesBadInput)
{
  const View view = look ({floor_slab, table, onTable (1.1f, 0.f, {0.1f, 0.1f, 0.1f})});
  Extraction extraction;
  Objects objects (1);
  extraction.extract (view.models, view.inliers, objects); // no cloud
  EXPECT_TRUE (objects.empty());

  View unorganized = view;
  unorganized.cloud = pcl::make_shared<table_scenes::Cloud> (*view.cloud);
  unorganized.cloud->width = static_cast<std::uint32_t> (view.cloud->size());
  unorganized.cloud->height = 1;
  EXPECT_TRUE (extract (unorganized).empty());

  View fewer_inliers = view;
  fewer_inliers.inliers.pop_back();
  EXPECT_TRUE (extract (fewer_inliers).empty());
  EXPECT_EQ (extract (extraction, view).size(), 1u);
  EXPECT_FALSE (extraction.getSupportPlanes().empty());
  EXPECT_TRUE (extract (extraction, fewer_inliers).empty());
  EXPECT_TRUE (extraction.getSupportPlanes().empty());

  const auto size = static_cast<pcl::index_t> (view.cloud->size());
  for (const pcl::index_t index :
       {size, 1000000, -1, std::numeric_limits<int>::min()}) {
    View other_cloud = view;
    other_cloud.inliers.front().indices.push_back (index);
    EXPECT_TRUE (extract (other_cloud).empty()) << index;
  }

  View short_model = view;
  short_model.models.front().values.pop_back();
  EXPECT_TRUE (extract (short_model).empty());

  View no_normals = view;
  no_normals.normals = nullptr;
  EXPECT_EQ (extract (no_normals).size(), 1u);
  Extraction split;
  split.setSplitAtConcaveEdges (true);
  EXPECT_TRUE (extract (split, no_normals).empty());
}

TEST (SupportedObjectExtraction, RefusesBadParameters)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Extraction extraction;
  extraction.setMaxObjectHeight (0.);
  EXPECT_FLOAT_EQ (extraction.getMaxObjectHeight(), 0.3f);
  extraction.setMinObjectHeight (nan);
  EXPECT_FLOAT_EQ (extraction.getMinObjectHeight(), 0.01f);
  extraction.setHullTolerance (-0.1);
  EXPECT_FLOAT_EQ (extraction.getHullTolerance(), 0.03f);
  extraction.setHullTolerance (0.);
  EXPECT_EQ (extraction.getHullTolerance(), 0.);
  extraction.setMaxOverhang (-0.1);
  EXPECT_FLOAT_EQ (extraction.getMaxOverhang(), 0.2f);
  extraction.setHorizontalTolerance (static_cast<float> (M_PI / 2.)); // above M_PI / 2
  EXPECT_FLOAT_EQ (extraction.getHorizontalTolerance(), static_cast<float> (M_PI / 2.));
  extraction.setHorizontalTolerance (0.26);
  extraction.setHorizontalTolerance (2.);
  EXPECT_FLOAT_EQ (extraction.getHorizontalTolerance(), 0.26f);
  extraction.setPlaneHeights (1., 0.5);
  EXPECT_FLOAT_EQ (extraction.getMaxPlaneHeight(), 1.2f);
  extraction.setGraspableSides (nan, 0.5);
  EXPECT_FLOAT_EQ (extraction.getMaxGraspableSide(), 0.1f);
  extraction.setDepthNoise ({-0.001f, 0.002f});
  EXPECT_EQ (extraction.getDepthNoise().constant, 0.001f);
  extraction.setCameraToBase (Eigen::Affine3f (Eigen::Scaling (2.f)));
  EXPECT_TRUE (extraction.getCameraToBase().linear().isUnitary (1e-4f));
}
