// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/scan_builder.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

} // namespace

void
ScanBuilder::start (const ScanLimits& limits, VirtualScan& scan)
{
  const float span = limits.angle_max - limits.angle_min;
  const auto directions =
      static_cast<std::size_t> (std::lround (span / limits.angle_increment)) + 1;
  if (sectors_.size() != directions + 1 || limits.angle_min != limits_.angle_min ||
      limits.angle_increment != limits_.angle_increment) {
    sectors_.assign (directions + 1, {});
    for (std::size_t i = 0; i < directions; ++i) {
      const float right =
          limits.angle_min + (static_cast<float> (i) - 0.5f) * limits.angle_increment;
      const float left =
          limits.angle_min + (static_cast<float> (i) + 0.5f) * limits.angle_increment;
      sectors_[i] = {
          std::cos (right), std::sin (right), std::cos (left), std::sin (left)};
    }
  }
  limits_ = limits;
  squares_.assign (directions + 1, infinity);
  squared_min_ = limits.range_min * limits.range_min;
  squared_max_ = limits.range_max * limits.range_max;

  scan.angle_min = limits.angle_min;
  scan.angle_max =
      limits.angle_min + static_cast<float> (directions - 1) * limits.angle_increment;
  scan.angle_increment = limits.angle_increment;
  scan.range_min = limits.range_min;
  scan.range_max = limits.range_max;
  scan_ = &scan;
}

void
ScanBuilder::add (const float* x, const float* y, const float* z, std::size_t count)
{
  std::size_t current = sectors_.size() - 1;
  Sector sector; // sectors_[current]
  float closest = infinity;
  for (std::size_t i = 0; i < count; ++i) {
    const float squared = x[i] * x[i] + y[i] * y[i];
    if (!(z[i] <= limits_.max_height && squared >= squared_min_ &&
          squared <= squared_max_ && squared > 0.f))
      continue;
    if (!sector.contains (x[i], y[i])) {
      squares_[current] = std::min (squares_[current], closest);
      current = find (x[i], y[i], current);
      sector = sectors_[current];
      closest = infinity;
    }
    closest = std::min (closest, squared);
  }
  squares_[current] = std::min (squares_[current], closest);
}

std::size_t
ScanBuilder::find (float x, float y, std::size_t guess) const
{
  for (const std::size_t near : {guess + 1, guess - 1})
    if (near < sectors_.size() && sectors_[near].contains (x, y))
      return near;
  const float steps_in_turn = 6.2831853f / limits_.angle_increment;
  float steps =
      (std::atan2 (y, x) - limits_.angle_min) / limits_.angle_increment + 0.5f;
  steps -= steps_in_turn * std::floor (steps / steps_in_turn);
  return std::min (static_cast<std::size_t> (steps), sectors_.size() - 1);
}

void
ScanBuilder::finish()
{
  scan_->ranges.resize (sectors_.size() - 1);
  for (std::size_t i = 0; i < scan_->ranges.size(); ++i)
    scan_->ranges[i] = std::sqrt (squares_[i]);
}

} // namespace rgbd_planes
} // namespace pcl
