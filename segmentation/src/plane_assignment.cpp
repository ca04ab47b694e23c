// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/plane_assignment.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr int tile_size = 16;
constexpr std::uint16_t min_tile_points = 8;
constexpr float min_cos_normals = 0.82f; // 35 degrees

} // namespace

void
PlaneAssignment::assign (const OrganizedPoints& points,
                         const OrganizedNormals& normals,
                         const std::vector<std::uint8_t>& use,
                         const std::vector<Plane>& planes,
                         const DepthNoise& noise,
                         float max_sigmas,
                         Preference preference,
                         std::vector<std::uint32_t>& labels)
{
  findPresentPlanes (points.width, points.height, planes.size(), labels);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    labels[i] = unlabelled;
    if (!(use[i] & measured))
      continue;
    const float* p = points[i];
    const float squared_range = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
    float nearest = max_sigmas * noise.sigma (squared_range);
    const int u = static_cast<int> (i % static_cast<std::size_t> (points.width));
    const int v = static_cast<int> (i / static_cast<std::size_t> (points.width));
    const auto tile =
        static_cast<std::size_t> (v / tile_size * tiles_u_ + u / tile_size);
    for (std::size_t k = present_begin_[tile]; k < present_begin_[tile + 1]; ++k) {
      const Plane& plane = planes[present_[k]];
      const float distance = std::abs (plane.distance (p));
      if (!(distance <= nearest))
        continue;
      if (use[i] & trusted_normal) {
        const Eigen::Map<const Eigen::Vector3f> normal (normals.normal +
                                                        i * normals.stride);
        if (std::abs (normal.dot (plane.normal)) < min_cos_normals)
          continue;
      }
      labels[i] = present_[k];
      nearest = distance;
      if (preference == Preference::first)
        break;
    }
  }
}

void
PlaneAssignment::findPresentPlanes (int width,
                                    int height,
                                    std::size_t planes,
                                    const std::vector<std::uint32_t>& labels)
{
  tiles_u_ = (width + tile_size - 1) / tile_size;
  tiles_v_ = (height + tile_size - 1) / tile_size;
  const std::size_t tiles = static_cast<std::size_t> (tiles_u_ * tiles_v_);
  counts_.assign (tiles * planes, 0);
  std::size_t i = 0;
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u, ++i)
      if (labels[i] != unlabelled) {
        const auto tile =
            static_cast<std::size_t> (v / tile_size * tiles_u_ + u / tile_size);
        ++counts_[tile * planes + labels[i]];
      }

  const auto isPresent = [&] (int tile_u, int tile_v, std::size_t plane) {
    for (int v = std::max (tile_v - 1, 0); v <= std::min (tile_v + 1, tiles_v_ - 1);
         ++v)
      for (int u = std::max (tile_u - 1, 0); u <= std::min (tile_u + 1, tiles_u_ - 1);
           ++u)
        if (counts_[static_cast<std::size_t> (v * tiles_u_ + u) * planes + plane] >=
            min_tile_points)
          return true;
    return false;
  };
  present_.clear();
  present_begin_.assign (1, 0);
  for (int v = 0; v < tiles_v_; ++v)
    for (int u = 0; u < tiles_u_; ++u) {
      for (std::size_t plane = 0; plane < planes; ++plane)
        if (isPresent (u, v, plane))
          present_.push_back (static_cast<std::uint32_t> (plane));
      present_begin_.push_back (present_.size());
    }
}

} // namespace rgbd_planes
} // namespace pcl
