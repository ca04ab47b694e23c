// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/pixel_lines.h>

#include <cmath>

namespace pcl {
namespace rgbd_planes {

std::ptrdiff_t
stepUpwards (const OrganizedPoints& points,
             const Eigen::Vector3f& normal,
             std::uint32_t i)
{
  const float elevation = elevationOf (points[i], normal);
  // By how much it grows with a step; 0 where no pixel beside is measured.
  const auto rise = [&] (std::ptrdiff_t step) {
    for (const int side : {1, -1}) {
      const std::uint32_t k = nextPixel (points, i, side * step);
      if (k != i && isMeasured (points[k]))
        return static_cast<float> (side) *
               (elevationOf (points[k], normal) - elevation);
    }
    return 0.f;
  };
  const float right = rise (1), down = rise (points.width);
  const bool along_row = std::fabs (right) > std::fabs (down);
  return (along_row ? 1 : points.width) * ((along_row ? right : down) > 0.f ? 1 : -1);
}

} // namespace rgbd_planes
} // namespace pcl
