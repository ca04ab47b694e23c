// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_kernels.h"
#include <hwy/cache_control.h>

#include <pcl/segmentation/plane_samples.h>

#include <algorithm>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Samples along the longer side of large images and of small ones, about. */
constexpr int samples_of_large = 160, samples_of_small = 107;
constexpr int large_side = 480;
/** Normals with more than this part of the largest curvature are not trusted. */
constexpr float trusted_share = 0.5f;

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

/** The pixel in the middle of \a step pixels, of which the last may be missing. */
int
middle (int cell, int step, int pixels)
{
  return std::min (cell * step + step / 2, pixels - 1);
}

bool
isUnit (const float* normal)
{
  const float square =
      normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
  return square > 0.9f && square < 1.1f;
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
  for (auto* values : {&sigma, &relative_sigma, &weight})
    values->resize (size);
  min_cosine.assign (size, -1.f);
  is_seed.assign (size, 0);
  if (width != old_width || height != old_height)
    findNeighbours();
}

void
PlaneSamples::findNeighbours()
{
  neighbours.resize (size());
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const auto neighbour = [&] (int other_u, int other_v) {
        const bool inside = other_u >= 0 && other_u < width && other_v >= 0;
        return static_cast<std::uint32_t> (inside ? at (other_u, other_v) : at (u, v));
      };
      neighbours[at (u, v)] = {neighbour (u - 1, v),
                               neighbour (u - 1, v - 1),
                               neighbour (u, v - 1),
                               neighbour (u + 1, v - 1)};
    }
}

void
PlaneSamples::findClustered (std::vector<std::uint32_t>& clustered) const
{
  clustered.resize (size());
  std::size_t number = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    clustered[number] = static_cast<std::uint32_t> (i);
    number +=
        static_cast<std::size_t> (isFree (i)) & static_cast<std::size_t> (is_seed[i]);
  }
  clustered.resize (number);
}

void
PlaneSamples::compute (const OrganizedPoints& points,
                       const OrganizedNormals& normals,
                       const std::vector<std::uint8_t>& selected,
                       const DepthNoise& noise,
                       float maximum_curvature)
{
  resize (points.width, points.height);
  const float farthest =
      std::min (noise.max_range * noise.max_range, max_squared_range);
  const auto isUsable = [&] (std::size_t pixel) {
    const float square = squaredRange (points[pixel]);
    return (selected.empty() || selected[pixel]) && square > min_squared_range &&
           square <= farthest;
  };
  for (int v = 0; v < height; ++v) {
    const int row = middle (v, step, points.height);
    const std::size_t below = pixelAt (
        points, middle (0, step, points.width), middle (v + 1, step, points.height));
    for (int u = 0; u < width; ++u) {
      if (step > 1) { // else the processor reads ahead by itself
        const std::size_t next = below + static_cast<std::size_t> (u * step);
        hwy::Prefetch (points[next]);
        hwy::Prefetch (normals.normal + next * normals.stride);
      }
      std::size_t pixel = pixelAt (points, middle (u, step, points.width), row);
      if (!isUsable (pixel)) {
        pixel = findPixel (points, u, v, isUsable);
        if (pixel == points.size())
          continue;
      }
      const std::size_t i = at (u, v);
      const float* p = points[pixel];
      x[i] = p[0];
      y[i] = p[1];
      z[i] = p[2];
      const float* normal = normals.normal + pixel * normals.stride;
      if (!isUnit (normal))
        continue;
      normal_x[i] = normal[0];
      normal_y[i] = normal[1];
      normal_z[i] = normal[2];
      const float curvature = normals.curvature[pixel * normals.stride];
      is_seed[i] = !(curvature > maximum_curvature);
      if (!(curvature > trusted_share * maximum_curvature))
        min_cosine[i] = 0.f;
    }
  }
  fillUncertainties (*this, noise);
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
