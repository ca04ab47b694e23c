// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "cell_middle.h"
#include "obstacle_kernels.h"
#include "row_bits.h"
#include <hwy/cache_control.h>

#include <pcl/segmentation/impl/obstacle_points.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Where a plane that differs begins, noise alone decides which points are on it: samples
 * of it are higher than that above the floor. */
constexpr float sample_sigmas = 1.f;
/** Noise moves points of a part of the floor by less from the floor, or from their own plane
 * where the smooth error of depth tilts that. */
constexpr float part_point_sigmas = 3.f;
/** Of the 9 of a window. */
constexpr float enough_samples = 6.f;

/** Points whose normal is further from that of the floor are on something else: 34 degrees. */
constexpr float min_cos_turned = 0.8253356f;

constexpr float
square (float x)
{
  return x * x;
}

/** So many numbers that vectors which begin with the last one end in them. */
std::size_t
padded (std::size_t size)
{
  return size + PointRow::block_size;
}

void
clear (FloorSums& sums, std::size_t size)
{
  for (auto* values : {&sums.height, &sums.variance, &sums.points, &sums.high})
    values->assign (size, 0.f);
}

void
clear (CellRow& cells, std::size_t size)
{
  clear (cells.sums, size);
  cells.differ.assign (size, 0.f);
}

/** Whether a point belongs to a low obstacle where there is one. */
inline bool
isHigh (float height, float variance, const ObstaclePointParameters& parameters)
{
  return (height > high_part * parameters.min_height) &
         (height * height > square (high_sigmas) * variance);
}

} // namespace

void
ObstaclePoints::start (const ObstacleFrame& frame,
                       const ObstaclePointParameters& parameters,
                       const PixelAngles& angles)
{
  parameters_ = parameters;
  angles_ = angles;
  width_ = frame.points.width;
  cell_size_ = cellSize (frame.points);
  cells_u_ = (width_ + cell_size_ - 1) / cell_size_;
  const auto cells = padded (static_cast<std::size_t> (cells_u_) + 2);
  clear (columns_, cells * static_cast<std::size_t> (cell_size_));
  for (auto& row : cells_)
    clear (row, cells);
  verdicts_.are_high.resize (cells);
  verdicts_.are_other.resize (cells);
  verdicts_.height.resize (cells);
  verdicts_.limit.resize (cells);
}

int
ObstaclePoints::addRow (const ObstacleFrame& frame,
                        int v,
                        const PointRow& points,
                        const PointRow& points_above,
                        RowLinks& links,
                        std::vector<ObstacleClass>& classes)
{
  if (frame.floor.isFound())
    prefetchNormals (frame, v);
  const std::size_t first = static_cast<std::size_t> (v) * width_;
  row_.resize (links.to_left.size() * bits_in_word);
  classifyRow (points,
               points_above,
               frame.floor.reference(),
               parameters_,
               angles_,
               row_.data(),
               links,
               columns_);
  if (!frame.floor.isFound()) {
    std::replace (
        row_.begin(), row_.end(), ObstacleClass::floor, ObstacleClass::obstacle);
    std::copy_n (row_.begin(), width_, &classes[first]);
    return v + 1;
  }
  std::copy_n (row_.begin(), width_, &classes[first]);
  if (frame.floor.hasPartsOrLevels())
    judgePlanes (frame, first, classes);

  const int cell_v = v / cell_size_;
  CellRow& cells = cellRow (cell_v);
  const bool is_last = v == frame.points.height - 1;
  if (v == middle (cell_v, cell_size_, frame.points.height))
    sampleRow (frame, first, cells);
  if (v % cell_size_ < cell_size_ - 1 && !is_last)
    return std::max (cell_v - 1, 0) * cell_size_;
  sumCells (columns_, cell_size_, cells_u_, cells.sums);
  if (cell_v > 0)
    judgeRow (frame, cell_v - 1, classes);
  if (!is_last)
    return cell_v * cell_size_;
  clear (cellRow (cell_v + 1), cells.differ.size());
  judgeRow (frame, cell_v, classes);
  return v + 1;
}

/** Those that the row of cells to come looks at, some with each row before it: memory is not kept
 * waiting by all of them. */
void
ObstaclePoints::prefetchNormals (const ObstacleFrame& frame, int v) const
{
  const int next = middle (v / cell_size_ + 1, cell_size_, frame.points.height);
  for (int cell = v % cell_size_; cell < cells_u_; cell += cell_size_) {
    const int i = next * width_ + middle (cell, cell_size_, width_);
    hwy::Prefetch (frame.normals[static_cast<std::size_t> (i)]);
  }
}

void
ObstaclePoints::judgePlanes (const ObstacleFrame& frame,
                             std::size_t first,
                             std::vector<ObstacleClass>& classes) const
{
  const std::size_t end = first + static_cast<std::size_t> (width_);
  std::uint32_t plane = frame.planes[first];
  float level = frame.floor.level (plane);
  bool is_part = frame.floor.isPart (plane);
  for (std::size_t i = first; i < end; ++i) {
    if (frame.planes[i] != plane) {
      plane = frame.planes[i];
      level = frame.floor.level (plane);
      is_part = frame.floor.isPart (plane);
    }
    if (classes[i] == ObstacleClass::unmeasured || (!is_part && level == 0.f))
      continue;
    const float* p = frame.points[i];
    const float height = heightAbove (frame.floor.coefficients(), p);
    if (is_part) {
      const float limit =
          part_point_sigmas * parameters_.noise.sigmaAtSquare (squaredRange (p));
      const float own_height = heightAbove (frame.planes.coefficients[plane], p);
      if (std::abs (height) <= limit || std::abs (own_height) <= limit)
        classes[i] = ObstacleClass::floor;
    }
    else if (level > parameters_.min_height && height > 0.f)
      classes[i] = ObstacleClass::obstacle;
    else if (level < -parameters_.min_drop && height < 0.f)
      classes[i] = ObstacleClass::drop_off;
  }
}

void
ObstaclePoints::sampleRow (const ObstacleFrame& frame,
                           std::size_t first,
                           CellRow& cells) const
{
  const auto differs = [&] (std::size_t i) {
    if (isTurned (frame, i))
      return true;
    if (!frame.floor.differs (frame.planes[i]))
      return false;
    const Eigen::Vector4f& floor = frame.floor.coefficients();
    const float* p = frame.points[i];
    return heightAbove (floor, p) >
           sample_sigmas * std::sqrt (heightVariance (p, floor[3], parameters_.noise));
  };
  for (int cell = 0; cell < cells_u_; ++cell) {
    const int u = middle (cell, cell_size_, width_);
    cells.differ[cell + 1] =
        row_[u] == ObstacleClass::floor && differs (first + u) ? 1.f : 0.f;
  }
}

bool
ObstaclePoints::isTurned (const ObstacleFrame& frame, std::size_t point) const
{
  const Eigen::Vector4f& floor = frame.floor.coefficients();
  const float* normal = frame.normals[point];
  return floor[0] * normal[0] + floor[1] * normal[1] + floor[2] * normal[2] <
         min_cos_turned;
}

void
ObstaclePoints::judgeRow (const ObstacleFrame& frame,
                          int cell_v,
                          std::vector<ObstacleClass>& classes)
{
  // The few points that something else leaves at its rim tell nothing.
  const float enough_points = static_cast<float> (9 * cell_size_ * cell_size_ / 4);
  if (!judgeCells (cellRow (cell_v - 1),
                   cellRow (cell_v),
                   cellRow (cell_v + 1),
                   cells_u_,
                   {enough_points, enough_samples, 0.5f * parameters_.min_height},
                   verdicts_))
    return;
  for (int u = 0; u < cells_u_; ++u)
    if (verdicts_.are_high[u] || verdicts_.are_other[u])
      judgeCell (frame, u, cell_v, classes);
}

void
ObstaclePoints::judgeCell (const ObstacleFrame& frame,
                           int cell_u,
                           int cell_v,
                           std::vector<ObstacleClass>& classes) const
{
  const bool is_high = verdicts_.are_high[cell_u] != 0;
  const bool is_other = verdicts_.are_other[cell_u] != 0;
  const float mean_height = verdicts_.height[cell_u], limit = verdicts_.limit[cell_u];
  const Eigen::Vector4f& floor = frame.floor.coefficients();
  const int end_v = std::min ((cell_v + 1) * cell_size_, frame.points.height);
  const int end_u = std::min ((cell_u + 1) * cell_size_, frame.points.width);
  for (int v = cell_v * cell_size_; v < end_v; ++v)
    for (int u = cell_u * cell_size_; u < end_u; ++u) {
      const auto i = static_cast<std::size_t> (v * frame.points.width + u);
      if (classes[i] != ObstacleClass::floor)
        continue;
      const float* p = frame.points[i];
      const std::uint32_t plane = frame.planes[i];
      const bool is_part = frame.floor.isPart (plane);
      float height = heightAbove (floor, p);
      if (is_part) // which the error of depth may have raised
        height = std::min (height, heightAbove (frame.planes.coefficients[plane], p));
      const float variance = heightVariance (p, floor[3], parameters_.noise);
      // The variance of depth is so many times that of height.
      const float factor = is_part ? squaredRange (p) / square (floor[3]) : 1.f;
      // Below the floor, a tilted plane can only be one that grew too far.
      if ((is_high && square (mean_height) > factor * limit &&
           isHigh (height, factor * variance, parameters_)) ||
          (is_other && (isTurned (frame, i) ||
                        (height > 0.f && frame.floor.differs (frame.planes[i])))))
        classes[i] = ObstacleClass::obstacle;
    }
}

} // namespace rgbd_planes
} // namespace pcl
