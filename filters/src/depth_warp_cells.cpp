// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/filters/impl/depth_warp.h>

#include <cmath>

namespace pcl {
namespace rgbd_planes {

void
DepthWarp::collectCells (const OrganizedPoints& points,
                         const std::vector<std::uint32_t>& plane_of,
                         const PlaneVectors& planes,
                         const DepthNoise& noise)
{
  planes_.resize (planes.size());
  for (PlaneSums& sums : planes_)
    sums.cells = 0;
  cells_.clear();
  Cell cell;
  for (cell.row = 0; cell.row < column_cosines_.cols(); ++cell.row)
    for (cell.column = 0; cell.column < row_cosines_.cols(); ++cell.column)
      if (findMean (points, plane_of, noise, cell) && cell.plane < planes.size() &&
          inverseDistance (planes[cell.plane]).allFinite()) {
        cells_.push_back (cell);
        ++planes_[cell.plane].cells;
      }
}

/** False for a cell with few points or of several planes. */
bool
DepthWarp::findMean (const OrganizedPoints& points,
                     const std::vector<std::uint32_t>& plane_of,
                     const DepthNoise& noise,
                     Cell& cell) const
{
  int count = 0;
  float x = 0.f, y = 0.f, inverse_depth = 0.f;
  const float max_squared_range = noise.maxSquaredRange();
  for (int v = cell.row * cell_size_; v < (cell.row + 1) * cell_size_; ++v)
    for (int u = cell.column * cell_size_; u < (cell.column + 1) * cell_size_; ++u) {
      const std::size_t i =
          static_cast<std::size_t> (v) * static_cast<std::size_t> (width_) +
          static_cast<std::size_t> (u);
      const Eigen::Map<const Eigen::Vector3f> p (points[i]);
      if (!isMeasured (points[i]) || p.z() <= 0.f ||
          p.squaredNorm() > max_squared_range)
        continue;
      if (count == 0)
        cell.plane = plane_of[i];
      if (plane_of[i] != cell.plane)
        return false;
      const float inverse = 1.f / p.z();
      x += inverse * p.x();
      y += inverse * p.y();
      inverse_depth += inverse;
      ++count;
    }
  cell.ray = Eigen::Vector3d (x, y, count) / count;
  cell.inverse_depth = static_cast<double> (inverse_depth) / count;
  return 2 * count >= cell_size_ * cell_size_ && cell.ray.allFinite() &&
         std::isfinite (cell.inverse_depth);
}

} // namespace rgbd_planes
} // namespace pcl
