// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "cell_middle.h"
#include "plane_kernels.h"
#include <hwy/cache_control.h>

#include <pcl/segmentation/impl/plane_samples.h>

#include <algorithm>
#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Samples along the longer side of large images and of small ones, about. */
constexpr int samples_of_large = 160, samples_of_small = 107;
constexpr int large_side = 480;

int
stepOf (int side)
{
  const int samples = side >= large_side ? samples_of_large : samples_of_small;
  return std::max (1, (side + samples / 2) / samples);
}

std::size_t
pixelAt (const OrganizedPoints& points, int column, int row)
{
  return static_cast<std::size_t> (row) * static_cast<std::size_t> (points.width) +
         static_cast<std::size_t> (column);
}

} // namespace

void
PlaneSamples::resize (int image_width, int image_height)
{
  const int old_width = width, old_height = height;
  step = stepOf (std::max (image_width, image_height));
  width = (image_width + step - 1) / step;
  height = (image_height + step - 1) / step;
  tiles_u = (width + tile_side - 1) / tile_side;
  tiles_v = (height + tile_side - 1) / tile_side;
  const std::size_t size = static_cast<std::size_t> (tiles_u * tiles_v) * tile_size;
  for (auto* values : {&x, &y, &z, &normal_x, &normal_y, &normal_z})
    values->assign (size, 0.f);
  for (auto* values : {&curvature, &sigma, &relative_sigma, &weight, &min_cosine})
    values->resize (size);
  if (width != old_width || height != old_height)
    findTilesAround();
}

void
PlaneSamples::findTilesAround()
{
  around_.clear();
  for (int v = 0; v < tiles_v; ++v)
    for (int u = 0; u < tiles_u; ++u)
      around_.push_back ({u > 0, u + 1 < tiles_u, v > 0, v + 1 < tiles_v});
}

void
PlaneSamples::dropTakenSeeds()
{
  std::size_t number = 0;
  for (const std::uint32_t i : seeds) {
    seeds[number] = i;
    number += isFree (i);
  }
  seeds.resize (number);
}

void
PlaneSamples::compute (const OrganizedPoints& points,
                       const OrganizedNormals& normals,
                       const std::vector<std::uint8_t>& selected,
                       const DepthNoise& noise,
                       float max_curvature)
{
  resize (points.width, points.height);
  const float farthest = noise.maxSquaredRange();
  const auto isUsable = [&] (std::size_t pixel) {
    const float square = squaredRange (points[pixel]);
    return (selected.empty() || selected[pixel]) &&
           square > DepthNoise::min_squared_range && square <= farthest;
  };
  missing_.clear();
  const auto stride = static_cast<std::size_t> (step);
  for (int v = 0; v < height; ++v) {
    const int row = middle (v, step, points.height);
    const std::size_t last = pixelAt (points, points.width - 1, row);
    std::size_t next = pixelAt (points, middle (0, step, points.width), row);
    std::size_t below = pixelAt (
        points, middle (0, step, points.width), middle (v + 1, step, points.height));
    for (int u = 0; u < width; ++u, next += stride, below += stride) {
      if (step > 1) { // else the processor reads ahead by itself
        hwy::Prefetch (points[below]);
        hwy::Prefetch (normals[below]);
      }
      const std::size_t pixel = std::min (next, last);
      const bool is_usable = isUsable (pixel);
      if (is_usable)
        copyPixel (points, normals, pixel, at (u, v));
      if (step > 1 && !(is_usable && isUnit (normals[pixel])))
        missing_.push_back ({u, v, is_usable});
    }
  }
  const auto isComplete = [&] (std::size_t i) {
    return isUsable (i) && isUnit (normals[i]);
  };
  for (const auto [u, v, has_point] : missing_) {
    std::size_t pixel = findPixel (points, u, v, isComplete);
    if (pixel == points.size() && !has_point)
      pixel = findPixel (points, u, v, isUsable);
    if (pixel != points.size())
      copyPixel (points, normals, pixel, at (u, v));
  }
  judgeSamples (*this, noise, max_curvature);
  findNearestPoints();
}

void
PlaneSamples::findNearestPoints()
{
  nearest_points_.clear();
  for (std::size_t begin = 0; begin < size(); begin += tile_size) {
    std::size_t nearest = begin;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t i = begin; i < begin + tile_size; ++i) {
      const float square = x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
      if (weight[i] > 0.f && square < least) {
        nearest = i;
        least = square;
      }
    }
    nearest_points_.emplace_back (x[nearest], y[nearest], z[nearest]);
  }
}

void
PlaneSamples::copyPixel (const OrganizedPoints& points,
                         const OrganizedNormals& normals,
                         std::size_t pixel,
                         std::size_t i)
{
  const float* p = points[pixel];
  x[i] = p[0];
  y[i] = p[1];
  z[i] = p[2];
  const float* normal = normals[pixel];
  normal_x[i] = normal[0];
  normal_y[i] = normal[1];
  normal_z[i] = normal[2];
  curvature[i] = normals.curvature[pixel * normals.stride];
}

/** The first usable pixel of a sample's cell; the number of pixels if there is none. */
template <typename IsUsable>
std::size_t
PlaneSamples::findPixel (const OrganizedPoints& points,
                         int u,
                         int v,
                         const IsUsable& isUsable) const
{
  for (int row = v * step; row < std::min ((v + 1) * step, points.height); ++row)
    for (int column = u * step; column < std::min ((u + 1) * step, points.width);
         ++column)
      if (isUsable (pixelAt (points, column, row)))
        return pixelAt (points, column, row);
  return points.size();
}

} // namespace rgbd_planes
} // namespace pcl
