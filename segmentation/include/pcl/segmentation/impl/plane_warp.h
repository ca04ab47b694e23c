// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/impl/plane_moments.h>
#include <pcl/segmentation/impl/point_row.h>
#include <pcl/types.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief How a camera bends a plane: the mean height of its points around each block of
 * 16 x 16 pixels over the plane that fits all of them. */
class PCL_RGBD_PLANES_EXPORTS PlaneWarp {
public:
  /** \param[in] inliers of the plane; only measured points count */
  void
  compute (const OrganizedPoints& points,
           const pcl::Indices& inliers,
           const Plane& plane);

  /** \brief Heights of the blocks in the row \a v of pixels, metres; 0 where there are too few
   * inliers around. */
  const float*
  row (int v) const
  {
    return &heights_[static_cast<std::size_t> (v / block_size) * columns_];
  }

private:
  static constexpr int block_size = PointRow::block_size;

  struct Sum {
    float heights = 0.f;
    float points = 0.f;
  };

  Sum
  window (std::size_t column, std::size_t row) const;

  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<Sum> sums_;
  std::vector<float> heights_;
};

} // namespace rgbd_planes
} // namespace pcl
