// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "table_scenes.h"

#include <pcl/segmentation/impl/object_box.h>

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

using namespace pcl::rgbd_planes;
using Eigen::Vector3f;
using table_scenes::Box;
using table_scenes::Camera;
using table_scenes::View;

namespace {

/** The box around all points of some boxes of a view that stand on z = 0. */
ObjectBox
boxOf (const View& view, std::initializer_list<int> boxes)
{
  pcl::Indices indices;
  for (const int box : boxes)
    for (const auto i : view.pixelsOf (box))
      indices.push_back (i);
  SupportSurface ground;
  ground.plane.normal = view.camera_to_base.linear().row (2);
  ground.plane.d = view.camera_to_base.translation().z();
  ground.axis_x = ground.plane.normal.unitOrthogonal();
  ground.axis_y = ground.plane.normal.cross (ground.axis_x);
  const OrganizedPoints points{&view.cloud->front().x,
                               4,
                               static_cast<int> (view.cloud->width),
                               static_cast<int> (view.cloud->height)};
  ObjectBoxFinder finder;
  return finder.compute (points, indices, ground, 0.f, DepthNoise());
}

/** Its sides: the one nearest to the base's x axis, the one nearest to y, and the height. */
Vector3f
sidesOf (const View& view, std::initializer_list<int> boxes)
{
  const ObjectBox box = boxOf (view, boxes);
  const Eigen::Matrix3f axes = view.camera_to_base.linear() * box.axes;
  EXPECT_NEAR (axes.determinant(), 1.f, 1e-4f);
  EXPECT_GT (axes (2, 2), 0.999f);
  const int x = std::fabs (axes (0, 0)) > std::fabs (axes (0, 1)) ? 0 : 1;
  return {box.size[x], box.size[1 - x], box.size.z()};
}

const Camera camera{0.8f, 0.35f, 0.f, 640, 480};

} // namespace

TEST (ObjectBox, NoiseDoesNotDeepenBoxes)
{
  // Depth has a standard deviation of 9 mm: the outermost of these points are 3 cm off.
  for (const float y : {-0.5f, -0.1f, 0.3f}) {
    const Vector3f size (0.08f, 0.1f, 0.12f);
    const float yaw = std::atan2 (y, 1.9f); // it turns a side to the camera
    const View view = table_scenes::look ({{{1.9f, y, 0.f}, size, yaw}}, camera, 1.f);
    const Vector3f sides = sidesOf (view, {0});
    EXPECT_NEAR (sides.x(), size.x(), 0.01f) << y;
    EXPECT_NEAR (sides.y(), size.y(), 0.01f) << y;
    EXPECT_NEAR (sides.z(), size.z(), 0.01f) << y;
  }
}

TEST (ObjectBox, WithoutNoiseAllSidesAreRight)
{
  for (const float yaw : {0.f, 0.3f, 0.6f}) {
    const Vector3f size (0.15f, 0.1f, 0.12f);
    const View view = table_scenes::look ({{{1.2f, 0.1f, 0.f}, size, yaw}}, camera);
    EXPECT_LT ((sidesOf (view, {0}) - size).cwiseAbs().maxCoeff(), 0.006f) << yaw;
  }
}

// A level camera sees as many points in each row of a front.
TEST (ObjectBox, AsWideAsAllPointsAre)
{
  for (const float height : {0.2f, 0.26f})
    for (float width = 0.06f; width < 0.14f; width += 0.002f) {
      const Vector3f size (0.08f, width, height);
      const View view = table_scenes::look (
          {{{1.f, 0.02f, 0.f}, size, 0.f}}, Camera{0.4f, 0.f, 0.f, 640, 480}, 0.f);
      // A fiftieth of the points at either end does not count.
      EXPECT_NEAR (sidesOf (view, {0}).y(), width, 0.08f * width) << height;
    }
}

// Seen at a flat angle, it has a tenth of the points, of which a few at the end are left out.
TEST (ObjectBox, ASmallTopTellsWhereAThingEnds)
{
  for (const float noise : {0.f, 0.5f})
    for (const float yaw : {0.f, 0.2f}) {
      const Vector3f size (0.14f, 0.12f, 0.25f);
      const View view = table_scenes::look (
          {{{1.2f, 0.f, 0.f}, size, yaw}}, Camera{0.5f, 0.2f, 0.f, 640, 480}, noise);
      EXPECT_NEAR (sidesOf (view, {0}).x(), size.x(), 0.01f) << noise << ' ' << yaw;
    }
}

TEST (ObjectBox, AHighBackIsNotTheMiddleOfAThing)
{
  const View view = table_scenes::look ({{{1.2f, 0.f, 0.f}, {0.1f, 0.1f, 0.05f}},
                                         {{1.26f, 0.f, 0.f}, {0.02f, 0.1f, 0.12f}}},
                                        camera);
  const Vector3f sides = sidesOf (view, {0, 1});
  EXPECT_NEAR (sides.x(), 0.12f, 0.01f);
  EXPECT_NEAR (sides.y(), 0.1f, 0.006f);
  EXPECT_NEAR (sides.z(), 0.12f, 0.006f);
}

// From above, two sides are a triangle, along whose third side a rectangle is as small.
TEST (ObjectBox, TwoSidesTellHowABoxIsTurned)
{
  for (const float noise : {0.f, 0.5f, 1.f})
    for (float yaw = 0.55f; yaw < 1.05f; yaw += 0.05f) {
      const Vector3f size (0.1f, 0.1f, 0.2f);
      const View view = table_scenes::look (
          {{{1.2f, 0.f, 0.f}, size, yaw}}, Camera{0.2f, 0.f, 0.f, 640, 480}, noise);
      const ObjectBox box = boxOf (view, {0});
      const Vector3f side = view.camera_to_base.linear() * box.axes.col (0);
      const float turn =
          std::remainder (std::atan2 (side.y(), side.x()) - yaw, 1.5708f);
      EXPECT_NEAR (turn, 0.f, 0.1f) << noise << ' ' << yaw;
      EXPECT_NEAR (box.size.x(), size.x(), 0.01f) << noise << ' ' << yaw;
      EXPECT_NEAR (box.size.y(), size.y(), 0.01f) << noise << ' ' << yaw;
    }
}

TEST (ObjectBox, ATopThatIsNotSeen)
{
  // The camera is lower than the top.
  const Camera low{0.2f, 0.f, 0.f, 640, 480};
  const View view = table_scenes::look ({{{1.2f, 0.f, 0.f}, {0.1f, 0.1f, 0.25f}}}, low);
  const Vector3f sides = sidesOf (view, {0});
  EXPECT_NEAR (sides.x(), 0.f, 0.006f);
  EXPECT_NEAR (sides.y(), 0.1f, 0.006f);
  EXPECT_NEAR (sides.z(), 0.25f, 0.006f);
}

TEST (ObjectBox, ATopAtTheHeightOfTheCamera)
{
  // Nothing but the front of a box, 1.2 m away, 10 cm wide and as high as the camera.
  std::vector<float> points;
  pcl::Indices indices;
  for (int column = 0; column <= 100; ++column)
    for (int row = 0; row <= 10; ++row) {
      indices.push_back (static_cast<pcl::index_t> (indices.size()));
      points.insert (points.end(),
                     {0.001f * static_cast<float> (column) - 0.05f,
                      0.025f * static_cast<float> (row),
                      1.2f});
    }
  SupportSurface ground;
  ground.plane.normal = -Vector3f::UnitY();
  ground.plane.d = 0.25f;
  ground.axis_x = Vector3f::UnitZ();
  ground.axis_y = -Vector3f::UnitX();
  const Vector3f size =
      ObjectBoxFinder()
          .compute ({points.data(), 3, 101 * 11, 1}, indices, ground, 0.f, DepthNoise())
          .size;
  EXPECT_NEAR (size.head<2>().minCoeff(), 0.f, 1e-4f);
  EXPECT_NEAR (size.head<2>().maxCoeff(), 0.1f, 0.006f);
  EXPECT_NEAR (size.z(), 0.25f, 0.006f);
}

TEST (ObjectBox, FlyingPixelsDoNotCount)
{
  const Vector3f size (0.15f, 0.1f, 0.12f);
  View view = table_scenes::look ({{{1.2f, 0.1f, 0.f}, size, 0.3f}}, camera);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < view.box.size(); ++i)
    if (view.box[i] == 0 && ++seen % 100 == 0)
      (*view.cloud)[i].getVector3fMap() *= seen % 200 ? 1.1f : 0.9f;
  EXPECT_LT ((sidesOf (view, {0}) - size).cwiseAbs().maxCoeff(), 0.01f);
}

TEST (ObjectBox, OnePoint)
{
  View view = table_scenes::look ({{{1.2f, 0.f, 0.f}, {0.1f, 0.1f, 0.1f}}}, camera);
  for (std::size_t i = 0, seen = 0; i < view.box.size(); ++i)
    if (view.box[i] == 0 && ++seen > 1)
      view.box[i] = -1;
  const Vector3f sides = sidesOf (view, {0});
  EXPECT_EQ (sides.x(), 0.f);
  EXPECT_EQ (sides.y(), 0.f);
  EXPECT_NEAR (sides.z(), 0.1f, 0.002f);
}
