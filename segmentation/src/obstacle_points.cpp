// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "obstacle_kernels.h"

#include <pcl/segmentation/obstacle_points.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr int cells_in_row = 160;

/** Where a plane that differs begins, noise alone decides which points are on it: samples
 * of it are higher than that above the floor. */
constexpr float sample_sigmas = 1.f;
/** The error of depth moves points of a floor by less. */
constexpr float part_point_sigmas = 3.f;
/** Of the 9 of a window. */
constexpr float enough_samples = 6.f;

template <typename T>
constexpr T
square (T x)
{
  return x * x;
}

/** Whether a point belongs to a low obstacle where there is one. */
inline bool
isHigh (float height, float variance, const ObstaclePointParameters& parameters)
{
  return (height > 0.25f * parameters.min_height) &
         (height * height > square (0.5f * window_sigmas) * variance);
}

} // namespace

void
ObstaclePoints::start (const ObstacleFrame& frame,
                       const ObstaclePointParameters& parameters)
{
  parameters_ = parameters;
  min_cos_ = std::cos (parameters.normal_angle);
  width_ = frame.points.width;
  cell_size_ = std::max (width_ / cells_in_row, 1);
  cells_u_ = (width_ + cell_size_ - 1) / cell_size_;
  cells_v_ = (frame.points.height + cell_size_ - 1) / cell_size_;
  cells_.assign (static_cast<std::size_t> (cells_u_ * cells_v_), {});
}

void
ObstaclePoints::addRow (const ObstacleFrame& frame,
                        int v,
                        const PointRow& points,
                        std::vector<ObstacleClass>& classes)
{
  row_.resize (points.size());
  classifyRow (points, frame.floor.coefficients(), parameters_, row_);
  const auto first = static_cast<std::size_t> (v * width_);
  std::transform (row_.what.begin(),
                  row_.what.begin() + width_,
                  classes.begin() + static_cast<std::ptrdiff_t> (first),
                  [] (std::uint8_t what) { return static_cast<ObstacleClass> (what); });
  if (frame.floor.hasParts())
    acceptParts (frame, first, classes);
  Cell* cells = &cells_[static_cast<std::size_t> (v / cell_size_ * cells_u_)];
  if (v % cell_size_ == 0)
    sampleRow (frame, first, cells);
  if (v % cell_size_ == cell_size_ - 1 || v == frame.points.height - 1)
    sumColumns (cells);
}

void
ObstaclePoints::finish (const ObstacleFrame& frame,
                        std::vector<ObstacleClass>& classes) const
{
  for (int v = 0; v < cells_v_; ++v)
    for (int u = 0; u < cells_u_; ++u) {
      const Cell& cell = cells_[static_cast<std::size_t> (v * cells_u_ + u)];
      if (cell.high > 0.f || cell.differ > 0.f)
        judgeCell (frame, u, v, classes);
    }
}

void
ObstaclePoints::acceptParts (const ObstacleFrame& frame,
                             std::size_t first,
                             std::vector<ObstacleClass>& classes) const
{
  for (std::size_t u = 0; u < static_cast<std::size_t> (width_); ++u) {
    ObstacleClass& result = classes[first + u];
    if (result == ObstacleClass::unmeasured || result == ObstacleClass::floor ||
        !frame.floor.isPart (frame.planes[first + u]))
      continue;
    if (std::abs (row_.height[u]) <=
        part_point_sigmas *
            parameters_.noise.sigma (squaredRange (frame.points[first + u])))
      result = ObstacleClass::floor;
  }
}

void
ObstacleRow::resize (std::size_t points_in_row)
{
  if (what.size() == points_in_row)
    return;
  what.resize (points_in_row);
  for (auto* values : {&height, &variance, &height_sum, &variance_sum, &points, &high})
    values->assign (points_in_row, 0.f);
}

/** Moves the sums of the columns to the cells that they are in. */
void
ObstaclePoints::sumColumns (Cell* cells)
{
  for (int begin = 0; begin < width_; begin += cell_size_, ++cells)
    for (int u = begin; u < std::min (begin + cell_size_, width_); ++u) {
      const auto column = static_cast<std::size_t> (u);
      cells->height += row_.height_sum[column];
      cells->variance += row_.variance_sum[column];
      cells->points += row_.points[column];
      cells->high += row_.high[column];
    }
  for (auto* sums : {&row_.height_sum, &row_.variance_sum, &row_.points, &row_.high})
    std::fill (sums->begin(), sums->end(), 0.f);
}

void
ObstaclePoints::sampleRow (const ObstacleFrame& frame,
                           std::size_t first,
                           Cell* cells) const
{
  for (int u = 0; u < width_; u += cell_size_)
    if (row_.what[u] == static_cast<std::uint8_t> (ObstacleClass::floor)) {
      const float noise = sample_sigmas * std::sqrt (row_.variance[u]);
      cells[u / cell_size_].differ =
          isOtherSurface (frame, first + u, row_.height[u] - noise) ? 1.f : 0.f;
    }
}

bool
ObstaclePoints::isOtherSurface (const ObstacleFrame& frame,
                                std::size_t point,
                                float height) const
{
  const Eigen::Vector4f& floor = frame.floor.coefficients();
  const float* normal = frame.normals.normal + point * frame.normals.stride;
  // Below the floor, a tilted plane can only be one that grew too far.
  return (height > 0.f && frame.floor.differs (frame.planes[point])) ||
         floor[0] * normal[0] + floor[1] * normal[1] + floor[2] * normal[2] < min_cos_;
}

ObstaclePoints::Cell
ObstaclePoints::window (int cell_u, int cell_v) const
{
  Cell sum;
  for (int v = std::max (cell_v - 1, 0); v <= std::min (cell_v + 1, cells_v_ - 1); ++v)
    for (int u = std::max (cell_u - 1, 0); u <= std::min (cell_u + 1, cells_u_ - 1);
         ++u) {
      const Cell& cell = cells_[static_cast<std::size_t> (v * cells_u_ + u)];
      sum.height += cell.height;
      sum.variance += cell.variance;
      sum.points += cell.points;
      sum.differ += cell.differ;
    }
  return sum;
}

void
ObstaclePoints::judgeCell (const ObstacleFrame& frame,
                           int cell_u,
                           int cell_v,
                           std::vector<ObstacleClass>& classes) const
{
  const Cell around = window (cell_u, cell_v);
  // The few points that something else leaves at its rim tell nothing.
  const float count = around.points;
  if (count < static_cast<float> (9 * cell_size_ * cell_size_ / 4))
    return;
  const float mean_height = around.height / count;
  const float limit = square (window_sigmas) * around.variance / count;
  const bool is_high =
      mean_height > 0.5f * parameters_.min_height && square (mean_height) > limit;
  const bool is_other = around.differ >= enough_samples;
  if (!is_high && !is_other)
    return;
  const Eigen::Vector4f& floor = frame.floor.coefficients();
  const int end_v = std::min ((cell_v + 1) * cell_size_, frame.points.height);
  const int end_u = std::min ((cell_u + 1) * cell_size_, frame.points.width);
  for (int v = cell_v * cell_size_; v < end_v; ++v)
    for (int u = cell_u * cell_size_; u < end_u; ++u) {
      const auto i = static_cast<std::size_t> (v * frame.points.width + u);
      if (classes[i] != ObstacleClass::floor)
        continue;
      const float* p = frame.points[i];
      const float height = heightAbove (floor, p);
      const float variance = heightVariance (p, floor[3], parameters_.noise);
      // The variance of depth is so many times that of height.
      const float factor = frame.floor.isPart (frame.planes[i])
                               ? squaredRange (p) / square (floor[3])
                               : 1.f;
      if ((is_high && square (mean_height) > factor * limit &&
           isHigh (height, factor * variance, parameters_)) ||
          (is_other && isOtherSurface (frame, i, height)))
        classes[i] = ObstacleClass::obstacle;
    }
}

} // namespace rgbd_planes
} // namespace pcl
