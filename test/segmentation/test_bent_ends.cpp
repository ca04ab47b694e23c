// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/bent_ends.h>
#include <pcl/segmentation/impl/plane_growth.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace pcl::rgbd_planes;

namespace {

/** Columns and rows, from \a u and \a v on, that are not of the wall but a part of their own. */
struct Region {
  int u, v, width, height;

  bool
  has (int column, int row) const
  {
    return column >= u && column < u + width && row >= v && row < v + height;
  }
};

constexpr int width = 640, height = 480;
constexpr float sigma = 0.003f; // of a Kinect at 1 m

/** Which planes a wall at z = 1 m and a region are, whose points are so many standard deviations
 * too far, and more by \a rise for each column away from the one that is next to the wall.
 * \param[in] curved what of the wall is said to be curved */
std::vector<std::int32_t>
planesOf (const Region& region, float offset, float rise, const Region& curved = {})
{
  std::vector<float> xyz, normals;
  std::vector<std::int32_t> owner_of_pixel;
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const bool is_in_region = region.has (u, v);
      const auto from_seam = static_cast<float> (region.u + region.width - 1 - u);
      const float z = is_in_region ? 1.f + sigma * (offset + rise * from_seam) : 1.f;
      const float x = static_cast<float> (u - width / 2) / 525.f;
      const float y = static_cast<float> (v - height / 2) / 525.f;
      xyz.insert (xyz.end(), {x * z, y * z, z, 1.f});
      normals.insert (normals.end(), {0.f, 0.f, -1.f, 0.f, 0.f});
      owner_of_pixel.push_back (is_in_region        ? 1
                                : curved.has (u, v) ? PlaneGrowth::curved_surface
                                                    : 0);
    }
  OrganizedNormals normals_view;
  normals_view.normal = normals.data();
  normals_view.curvature = normals.data() + 4;
  normals_view.stride = 5;
  PlaneSamples samples;
  samples.compute (
      {xyz.data(), 4, width, height}, normals_view, {}, DepthNoise(), 0.08f);
  std::vector<std::int32_t> owners (samples.size(), -1);
  std::vector<PlaneMoments> parts (2);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto [u, v] = samples.placeOf (i);
    if (u >= samples.width || v >= samples.height)
      continue;
    const int middle = samples.step / 2;
    owners[i] = owner_of_pixel[static_cast<std::size_t> (
        (v * samples.step + middle) * width + u * samples.step + middle)];
    if (owners[i] < 0)
      continue;
    const Eigen::Vector3f p (samples.x[i], samples.y[i], samples.z[i]);
    parts[static_cast<std::size_t> (owners[i])].add (
        p.data(), static_cast<double> (samples.weight[i]));
  }
  std::vector<TilePart> tile_parts;
  findTileParts (owners, tile_parts);
  BentEnds ends;
  ends.find (samples, owners, tile_parts, parts);
  EXPECT_EQ (ends.planes().front().points, parts.front().points);
  return ends.planeOfPart();
}

const std::vector<std::int32_t> one{0, 0}, two{0, 1};
constexpr Region corner{0, 400, 64, 80};

} // namespace

TEST (BentEnds, ACornerThatIsBentIsOfItsPlane)
{
  EXPECT_EQ (planesOf (corner, 3.f, 0.05f), one);
  EXPECT_EQ (planesOf (corner, -3.f, -0.05f), one);
}

TEST (BentEnds, WhatIsInTheMiddleOfAPlaneIsNoEnd)
{
  EXPECT_EQ (planesOf ({200, 200, 64, 80}, 2.f, 0.02f), two);
}

TEST (BentEnds, WhatLiesBetweenAPlaneAndACurvedSurfaceIsNoEnd)
{
  EXPECT_EQ (planesOf ({200, 200, 64, 80}, 2.f, 0.02f, {136, 136, 128, 208}), two);
}

TEST (BentEnds, AThingBeforeTheEndOfAWallIsNoEnd)
{
  EXPECT_EQ (planesOf (corner, -4.6f, 0.f), two);
}

TEST (BentEnds, AWallThatMeetsAPlaneAtItsEndIsNoEnd)
{
  // It is turned by 40 degrees.
  EXPECT_EQ (planesOf ({0, 0, 16, 480}, 0.f, 0.5f), two);
}

TEST (BentEnds, LargeSurfacesAreNoEnds)
{
  EXPECT_EQ (planesOf ({0, 0, 64, 480}, 3.f, 0.02f), two);
}
