// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/obstacle_points.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr int cells_in_row = 160;

// Thresholds in standard deviations of the height of a point. On simulated floors, no
// point exceeds the first, and 0.01 % of the windows the second: the warp of a Kinect's
// depth moves their means, though not their noise, as much as that of points.
constexpr float point_sigmas = 4.5f;
constexpr float window_sigmas = 2.75f;
/** Below the floor: real sensors also measure far depth too long, which bends floors
 * downwards by more than their noise. */
constexpr float drop_sigmas = 8.f;
/** Where a plane that differs begins, noise alone decides which points are on it: samples
 * of it are higher than that above the floor. */
constexpr float sample_sigmas = 1.f;
/** Of the 9 of a window. */
constexpr int enough_samples = 5;

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

ObstaclePoints::Cell&
ObstaclePoints::Cell::operator+= (const Cell& other)
{
  height += other.height;
  variance += other.variance;
  points += other.points;
  high += other.high;
  differ += other.differ;
  return *this;
}

void
ObstaclePoints::classify (const ObstacleFrame& frame,
                          const ObstaclePointParameters& parameters,
                          std::vector<ObstacleClass>& classes)
{
  parameters_ = parameters;
  min_cos_ = std::cos (parameters.normal_angle);
  prepare (frame.points);
  classes.resize (frame.points.size());
  for (int v = 0; v < frame.points.height; ++v) {
    const auto first = static_cast<std::size_t> (v * frame.points.width);
    Cell* cells = &cells_[static_cast<std::size_t> (v / cell_size_ * cells_u_)];
    measureRow (frame, first);
    classifyRow (first, classes);
    sumRow (cells);
    if (v % cell_size_ == 0)
      sampleRow (frame, first, cells);
  }
  for (int v = 0; v < cells_v_; ++v)
    for (int u = 0; u < cells_u_; ++u) {
      const Cell& cell = cells_[static_cast<std::size_t> (v * cells_u_ + u)];
      if (cell.high != 0 || cell.differ != 0)
        judgeCell (frame, u, v, classes);
    }
}

void
ObstaclePoints::prepare (const OrganizedPoints& points)
{
  width_ = points.width;
  cell_size_ = std::max (width_ / cells_in_row, 1);
  cells_u_ = (width_ + cell_size_ - 1) / cell_size_;
  cells_v_ = (points.height + cell_size_ - 1) / cell_size_;
  cells_.assign (static_cast<std::size_t> (cells_u_ * cells_v_), {});
  row_.height.resize (static_cast<std::size_t> (width_));
  row_.variance.resize (static_cast<std::size_t> (width_));
  row_.high.resize (static_cast<std::size_t> (width_));
  row_.result.resize (static_cast<std::size_t> (width_));
}

// The loops over a row have neither branches nor members in them, so that compilers
// vectorise them.
void
ObstaclePoints::measureRow (const ObstacleFrame& frame, std::size_t first)
{
  const Eigen::Vector4f floor = frame.floor.coefficients();
  const DepthNoise noise = parameters_.noise;
  const int width = frame.points.width;
  float* heights = row_.height.data();
  float* variances = row_.variance.data();
  for (int u = 0; u < width; ++u) {
    const float* p = frame.points[first + u];
    heights[u] = heightAbove (floor, p);
    variances[u] = heightVariance (p, floor[3], noise);
  }
  if (frame.selected)
    for (int u = 0; u < width; ++u)
      if (!frame.selected[first + u])
        variances[u] = std::numeric_limits<float>::quiet_NaN();
}

void
ObstaclePoints::classifyRow (std::size_t first, std::vector<ObstacleClass>& classes)
{
  const ObstaclePointParameters parameters = parameters_;
  const int width = width_;
  float* heights = row_.height.data();
  float* variances = row_.variance.data();
  int* high = row_.high.data();
  int* result = row_.result.data();
  for (int u = 0; u < width; ++u) {
    const float height = heights[u], variance = variances[u];
    const int is_measured = variance <= std::numeric_limits<float>::max();
    const float squared = height * height;
    const int is_obstacle = is_measured & (squared > square (point_sigmas) * variance) &
                            (height > parameters.min_height);
    const int is_drop_off = is_measured & (squared > square (drop_sigmas) * variance) &
                            (height < -parameters.min_drop);
    const int may_be_floor = is_measured - is_obstacle - is_drop_off;
    result[u] = is_measured + is_obstacle + 2 * is_drop_off;
    high[u] = may_be_floor & static_cast<int> (isHigh (height, variance, parameters));
    heights[u] = may_be_floor ? height : 0.f;
    variances[u] = may_be_floor ? variance : 0.f;
  }
  for (int u = 0; u < width; ++u)
    classes[first + u] = static_cast<ObstacleClass> (result[u]);
}

void
ObstaclePoints::sumRow (Cell* cells) const
{
  constexpr int floor = static_cast<int> (ObstacleClass::floor);
  for (int begin = 0; begin < width_; begin += cell_size_) {
    Cell sum; // in registers
    const int end = std::min (begin + cell_size_, width_);
    for (int u = begin; u < end; ++u) {
      sum.height += row_.height[u];
      sum.variance += row_.variance[u];
      sum.points += row_.result[u] == floor;
      sum.high += row_.high[u];
    }
    *cells++ += sum;
  }
}

void
ObstaclePoints::sampleRow (const ObstacleFrame& frame,
                           std::size_t first,
                           Cell* cells) const
{
  for (int u = 0; u < width_; u += cell_size_)
    if (row_.result[u] == static_cast<int> (ObstacleClass::floor)) {
      const float noise = sample_sigmas * std::sqrt (row_.variance[u]);
      cells[u / cell_size_].differ =
          isOtherSurface (frame, first + u, row_.height[u] - noise);
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
         ++u)
      sum += cells_[static_cast<std::size_t> (v * cells_u_ + u)];
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
  if (around.points < 9 * cell_size_ * cell_size_ / 4)
    return;
  const auto count = static_cast<float> (around.points);
  const bool is_high = around.height / count >
                       std::max (0.5f * parameters_.min_height,
                                 window_sigmas * std::sqrt (around.variance / count));
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
      if ((is_high && isHigh (height, variance, parameters_)) ||
          (is_other && isOtherSurface (frame, i, height)))
        classes[i] = ObstacleClass::obstacle;
    }
}

} // namespace rgbd_planes
} // namespace pcl
