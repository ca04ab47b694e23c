// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "table_scenes.h"

#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/segmentation/impl/plane_warp.h>
#include <pcl/segmentation/supported_object_extraction.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using Eigen::Vector3f;
using pcl::rgbd_planes::Plane;
using pcl::rgbd_planes::PlaneWarp;
using table_scenes::Box;
using table_scenes::Camera;
using table_scenes::look;
using table_scenes::View;

namespace {

constexpr int block_size = 16;
constexpr float table_height = 0.7f;
const Box floor_slab{{3.f, 0.f, -0.1f}, {8.f, 8.f, 0.1f}};
const Box table{{1.2f, 0.f, 0.66f}, {0.8f, 1.f, 0.04f}};
const Camera vga{1.4f, 0.65f, 0.f, 640, 480};

/** How much higher a camera that warps depth sees a place of the table. */
using Bend = float (*) (const Vector3f& in_base);

/** Moves all points along their rays: those of the table rise by its bend. */
View
bent (View view, Bend bend)
{
  const float camera_above = view.camera_to_base.translation().z() - table_height;
  for (auto& point : *view.cloud) {
    const Vector3f in_base = view.camera_to_base * point.getVector3fMap();
    if (in_base.allFinite() && std::fabs (in_base.z() - table_height) < 0.1f)
      point.getVector3fMap() *= 1.f - bend (in_base) / camera_above;
  }
  return view;
}

float
wave (const Vector3f& in_base)
{
  return 0.008f * std::sin (2.f * static_cast<float> (M_PI) * in_base.y() / 0.8f);
}

/** 1 in the middle of the table, 0.6 in a distance of \a width. */
float
bell (const Vector3f& in_base, float width)
{
  const Vector3f off = in_base - table.bottom_center;
  return std::exp (-off.head<2>().squaredNorm() / (2.f * width * width));
}

std::vector<pcl::SupportedObject>
extract (const View& view)
{
  pcl::SupportedObjectExtraction<pcl::PointXYZ, pcl::Normal> extraction;
  extraction.setCameraToBase (view.camera_to_base);
  extraction.setInputCloud (view.cloud);
  std::vector<pcl::SupportedObject> objects;
  extraction.extract (view.models, view.inliers, objects);
  return objects;
}

Plane
topOfTable (const View& view)
{
  const auto& values = view.models[view.top.at (1)].values;
  return {{values[0], values[1], values[2]}, values[3]};
}

} // namespace

TEST (PlaneWarp, FollowsTheBendOfAPlane)
{
  const View flat = look ({floor_slab, table}, vga), view = bent (flat, wave);
  PlaneWarp warp;
  warp.compute (pcl::rgbd_planes::viewPoints (*view.cloud),
                view.inliers[view.top.at (1)].indices,
                topOfTable (view));
  int blocks = 0;
  for (int v = block_size / 2; v < 480; v += block_size)
    for (int u = block_size / 2; u < 640; u += block_size) {
      const auto isOnTable = [&] (int a, int b) {
        const int x = u + 48 * a, y = v + 48 * b;
        return x >= 0 && y >= 0 && x < 640 && y < 480 &&
               view.box[static_cast<std::size_t> (640 * y + x)] == 1;
      };
      if (!isOnTable (-1, -1) || !isOnTable (1, -1) || !isOnTable (-1, 1) ||
          !isOnTable (1, 1))
        continue;
      ++blocks;
      const float truth =
          wave (flat.camera_to_base * flat.cloud->at (u, v).getVector3fMap());
      EXPECT_NEAR (warp.row (v)[u / block_size], truth, 0.0015f) << u << ' ' << v;
    }
  EXPECT_GT (blocks, 50);
}

TEST (PlaneWarp, IsZeroWithoutEnoughInliers)
{
  View view =
      bent (look ({floor_slab, table}, vga), [] (const Vector3f&) { return 0.005f; });
  pcl::Indices few;
  for (const auto index : view.inliers[view.top.at (1)].indices)
    if (index % 16 == 0)
      few.push_back (index);
  PlaneWarp warp;
  const auto largest = [&] (const pcl::Indices& inliers) {
    warp.compute (
        pcl::rgbd_planes::viewPoints (*view.cloud), inliers, topOfTable (view));
    float height = 0.f;
    for (int v = 0; v < 480; v += block_size)
      for (int k = 0; k < 640 / block_size; ++k)
        height = std::max (height, std::fabs (warp.row (v)[k]));
    return height;
  };
  const pcl::Indices all = view.inliers[view.top.at (1)].indices;
  EXPECT_NEAR (largest (all), 0.005f, 1e-4f);
  EXPECT_EQ (largest (few), 0.f);
  EXPECT_EQ (largest ({}), 0.f);
  for (auto& point : *view.cloud)
    point.x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ (largest (all), 0.f);
}

TEST (PlaneWarp, BumpOfATableIsNoObject)
{
  const auto bump = [] (const Vector3f& p) { return 0.015f * bell (p, 0.1f); };
  EXPECT_TRUE (extract (bent (look ({floor_slab, table}, vga), bump)).empty());
}

TEST (PlaneWarp, BumpTooNarrowToFollowIsNoObject)
{
  const auto bump = [] (const Vector3f& p) { return 0.02f * bell (p, 0.03f); };
  EXPECT_TRUE (extract (bent (look ({floor_slab, table}, vga), bump)).empty());
  // What is not higher, but ends at steps.
  const Box block{{1.2f, 0.f, table_height}, {0.07f, 0.07f, 0.015f}};
  EXPECT_EQ (extract (look ({floor_slab, table, block}, vga)).size(), 1u);
}

TEST (PlaneWarp, LowThingInADipIsAnObject)
{
  const Box bar{{1.2f, 0.f, table_height}, {0.04f, 0.12f, 0.014f}};
  const auto dip = [] (const Vector3f& p) { return -0.008f * bell (p, 0.2f); };
  const View view = bent (look ({floor_slab, table, bar}, vga), dip);
  const auto objects = extract (view);
  ASSERT_EQ (objects.size(), 1u);
  const auto of_bar = view.pixelsOf (2);
  const auto& indices = objects.front().indices.indices;
  const auto both = std::count_if (
      indices.begin(), indices.end(), [&] (auto i) { return of_bar.count (i) != 0; });
  EXPECT_GT (static_cast<std::size_t> (both), of_bar.size() / 2);
  EXPECT_GT (static_cast<double> (both), 0.9 * static_cast<double> (indices.size()));
}
