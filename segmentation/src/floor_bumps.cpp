// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "obstacle_kernels.h"

#include <pcl/segmentation/impl/floor_bumps.h>
#include <pcl/segmentation/impl/floor_plane.h>
#include <pcl/segmentation/impl/pixel_lines.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl {
namespace rgbd_planes {

namespace {

// In standard deviations of the height of a point:
/** Half of the points of a bump are lower, */
constexpr float max_height = 5.f;
/** and half of its lines end without a step as high as this. */
constexpr float min_step = 2.f;

constexpr std::size_t no_run = std::numeric_limits<std::size_t>::max();

} // namespace

void
FloorBumps::find (const OrganizedPoints& points,
                  const Eigen::Vector4f& floor,
                  const DepthNoise& noise,
                  const ObstacleClusters& clusters,
                  const std::vector<ObstacleClass>& classes)
{
  points_ = points;
  floor_ = floor;
  noise_ = noise;
  runs_ = &clusters.runs();
  const auto& sizes = clusters.sizes();
  last_run_.assign (sizes.size(), no_run);
  run_before_.resize (runs_->size());
  for (std::size_t k = 0; k < runs_->size(); ++k) {
    const ObstacleClusters::Run& run = (*runs_)[k];
    if (run.cluster != ObstacleClusters::none &&
        sizes[run.cluster] < maxPoints (points) &&
        classes[run.first] == ObstacleClass::obstacle)
      run_before_[k] = std::exchange (last_run_[run.cluster], k);
  }
  are_bumps_.resize (sizes.size());
  for (std::size_t k = 0; k < sizes.size(); ++k)
    are_bumps_[k] = last_run_[k] != no_run && isLow (k) && endsWithoutStep (k);
}

bool
FloorBumps::isLow (std::size_t cluster) const
{
  std::size_t number = 0, low = 0;
  forEachRun (cluster, [&] (const ObstacleClusters::Run& run) {
    number += run.length;
    for (std::size_t i = run.first; i < run.first + run.length; ++i)
      low += heightInSigmas (static_cast<std::uint32_t> (i)) < max_height;
  });
  return 2 * low > number;
}

bool
FloorBumps::endsWithoutStep (std::size_t cluster)
{
  const std::size_t first = (*runs_)[last_run_[cluster]].first;
  const std::ptrdiff_t up =
      stepUpwards (points_, floor_.head<3>(), static_cast<std::uint32_t> (first));
  findLineEnds (
      static_cast<std::size_t> (points_.width),
      alongRow (up),
      [&] (const auto& use) { forEachRun (cluster, use); },
      first_,
      last_);
  std::size_t lines = 0, steps = 0;
  for (std::size_t k = 0; k < first_.size(); ++k)
    if (first_[k] != no_pixel) {
      ++lines;
      steps += up > 0 ? hasStep (first_[k], last_[k], up)
                      : hasStep (last_[k], first_[k], up);
    }
  return 2 * steps < lines;
}

/** Between the means of a few pixels, on the way upwards from \a i to \a end and through the cells
 * before and behind. */
bool
FloorBumps::hasStep (std::uint32_t i, std::uint32_t end, std::ptrdiff_t up)
{
  const int cell = cellSize (points_);
  const std::size_t number = static_cast<std::size_t> (std::max (3 * cell / 4, 1));
  const std::size_t apart = number + static_cast<std::size_t> (cell / 4);
  for (int k = 0; k < cell; ++k) {
    i = nextPixel (points_, i, -up);
    end = nextPixel (points_, end, up);
  }
  heights_.clear();
  for (bool is_end = false; !is_end; i = nextPixel (points_, i, up)) {
    is_end = i == end;
    heights_.push_back (heightInSigmas (i));
    if (!isMeasured (points_[i]) || std::isnan (heights_.back())) // or too far
      return true;
  }
  for (std::size_t k = 0; k + apart + number <= heights_.size(); ++k) {
    float fall = 0.f;
    for (std::size_t n = k; n < k + number; ++n)
      fall += heights_[n] - heights_[n + apart];
    if (fall >= min_step * static_cast<float> (number))
      return true;
  }
  return false;
}

template <typename Use>
void
FloorBumps::forEachRun (std::size_t cluster, const Use& use) const
{
  for (std::size_t k = last_run_[cluster]; k != no_run; k = run_before_[k])
    use ((*runs_)[k]);
}

float
FloorBumps::heightInSigmas (std::uint32_t i) const
{
  const float* p = points_[i];
  return heightAbove (floor_, p) / std::sqrt (heightVariance (p, floor_[3], noise_));
}

} // namespace rgbd_planes
} // namespace pcl
