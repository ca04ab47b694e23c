// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_kernels.h"

#include <pcl/segmentation/impl/point_row.h>

#include <limits>
#include <numeric>

namespace pcl {
namespace rgbd_planes {

void
PointRow::load (const OrganizedPoints& points, int row, const std::uint8_t* selected)
{
  const auto width = static_cast<std::size_t> (points.width);
  resize (width);
  const std::size_t first = static_cast<std::size_t> (row) * width;
  loadPixels (points[first],
              points.stride,
              columns_,
              width,
              coordinates_[0].data() + block_size,
              coordinates_[1].data() + block_size,
              coordinates_[2].data() + block_size);
  for (std::size_t u = 0; selected && u < width; ++u)
    if (!selected[first + u])
      coordinates_[0][block_size + u] = std::numeric_limits<float>::quiet_NaN();
}

void
PointRow::load (const OrganizedPoints& points,
                int row,
                std::size_t begin,
                std::size_t end)
{
  const auto width = static_cast<std::size_t> (points.width);
  resize (width);
  for (std::size_t u = begin; u < end; ++u)
    for (std::size_t k = 0; k < 3; ++k)
      coordinates_[k][block_size + u] =
          points[static_cast<std::size_t> (row) * width + u][k];
}

void
PointRow::resize (std::size_t width)
{
  if (columns_.size() == width)
    return;
  columns_.resize (width);
  std::iota (columns_.begin(), columns_.end(), 0);
  for (auto& coordinate : coordinates_)
    coordinate.assign (block_size + size(), std::numeric_limits<float>::quiet_NaN());
}

} // namespace rgbd_planes
} // namespace pcl
