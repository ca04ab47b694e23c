// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_kernels.h"

#include <pcl/segmentation/point_row.h>

#include <limits>
#include <numeric>

namespace pcl {
namespace rgbd_planes {

void
PointRow::load (const OrganizedPoints& points, int row)
{
  const auto width = static_cast<std::size_t> (points.width);
  if (columns_.size() != width) {
    columns_.resize (width);
    std::iota (columns_.begin(), columns_.end(), 0);
    for (auto& coordinate : coordinates_)
      coordinate.assign ((1 + blocks()) * block_size,
                         std::numeric_limits<float>::quiet_NaN());
  }
  loadPixels (points[static_cast<std::size_t> (row) * width],
              points.stride,
              columns_,
              width,
              coordinates_[0].data() + block_size,
              coordinates_[1].data() + block_size,
              coordinates_[2].data() + block_size);
}

} // namespace rgbd_planes
} // namespace pcl
