// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/depth_image.h>
#include <pcl/common/point_tests.h>
#include <pcl/point_cloud.h>

#include <cstdint>

namespace pcl {
namespace rgbd_planes {

/** \brief Least squares for pixel = focal * slope + center, along one axis of an image. */
struct LineFit {
  double n = 0., x = 0., y = 0., xx = 0., xy = 0.;

  void
  add (double slope, double pixel)
  {
    n += 1.;
    x += slope;
    y += pixel;
    xx += slope * slope;
    xy += slope * pixel;
  }

  double
  focal () const
  {
    const double spread = n * xx - x * x;
    return spread > 1e-9 * n * n ? (n * xy - x * y) / spread : 0.;
  }

  double
  center () const
  {
    return n > 0. ? (y - focal() * x) / n : 0.;
  }
};

/** \brief The pinhole camera that an organized cloud fits best, in pixels; focal lengths are 0
 * where it has too few points. */
template <typename PointT>
Intrinsics
fitCamera (const pcl::PointCloud<PointT>& cloud)
{
  LineFit columns, rows;
  for (std::uint32_t v = 0; v < cloud.height; ++v)
    for (std::uint32_t u = 0; u < cloud.width; ++u) {
      const PointT& p = cloud (u, v);
      if (!pcl::isFinite (p) || p.z <= 0.f)
        continue;
      columns.add (p.x / p.z, u);
      rows.add (p.y / p.z, v);
    }
  return {static_cast<float> (columns.focal()),
          static_cast<float> (rows.focal()),
          static_cast<float> (columns.center()),
          static_cast<float> (rows.center())};
}

} // namespace rgbd_planes
} // namespace pcl
