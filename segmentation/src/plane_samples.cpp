// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/plane_samples.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Samples along the longer side of the image, about. */
constexpr int samples_per_side = 160;
/** By how many degrees a normal may differ from that of its plane: 10, and 6 more with
 * each metre, as depth noise tilts far normals. */
constexpr float angle_at_sensor = 10.f, angle_per_metre = 6.f, largest_angle = 60.f;
/** Nearer points have no direction. */
constexpr float min_squared_range = 1e-12f;
/** Squares of larger numbers are no floats. */
constexpr float max_squared_range = 1e18f;

float
minCosine (float range)
{
  const float degrees =
      std::min (angle_at_sensor + angle_per_metre * range, largest_angle);
  const float angle = degrees * static_cast<float> (M_PI / 180.);
  const float square = angle * angle;
  return 1.f - square * (1.f / 2.f - square * (1.f / 24.f - square * (1.f / 720.f)));
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
  step = std::max (1,
                   (std::max (image_width, image_height) + samples_per_side / 2) /
                       samples_per_side);
  width = (image_width + step - 1) / step;
  height = (image_height + step - 1) / step;
  tiles_u = (width + tile_side - 1) / tile_side;
  tiles_v = (height + tile_side - 1) / tile_side;
  const std::size_t size = static_cast<std::size_t> (tiles_u * tiles_v) * tile_size;
  for (auto* values :
       {&x, &y, &z, &normal_x, &normal_y, &normal_z, &weight, &min_cosine})
    values->assign (size, 0.f);
  sigma.assign (size, -1.f);
  relative_sigma.assign (size, -1.f);
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
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const int column = std::min (u * step + step / 2, points.width - 1);
      const int row = std::min (v * step + step / 2, points.height - 1);
      const auto pixel =
          static_cast<std::size_t> (row) * static_cast<std::size_t> (points.width) +
          static_cast<std::size_t> (column);
      if (!selected.empty() && !selected[pixel])
        continue;
      const float* p = points[pixel];
      const float squared_range = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
      if (!(squared_range > min_squared_range && squared_range <= farthest))
        continue;
      const std::size_t i = at (u, v);
      const float range = std::sqrt (squared_range);
      x[i] = p[0];
      y[i] = p[1];
      z[i] = p[2];
      sigma[i] = noise.sigma (squared_range);
      relative_sigma[i] = sigma[i] / range;
      weight[i] = 1.f / (relative_sigma[i] * relative_sigma[i]);
      const float* normal = normals.normal + pixel * normals.stride;
      min_cosine[i] = -1.f;
      if (!isUnit (normal) ||
          normals.curvature[pixel * normals.stride] > maximum_curvature)
        continue;
      normal_x[i] = normal[0];
      normal_y[i] = normal[1];
      normal_z[i] = normal[2];
      min_cosine[i] = minCosine (range);
    }
}

} // namespace rgbd_planes
} // namespace pcl
