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
  if (directions != squares_.size() || limits.angle_min != limits_.angle_min ||
      limits.angle_increment != limits_.angle_increment) {
    borders_.resize (directions + 1);
    for (std::size_t i = 0; i <= directions; ++i) {
      const float angle =
          limits.angle_min + (static_cast<float> (i) - 0.5f) * limits.angle_increment;
      borders_[i] = {std::cos (angle), std::sin (angle)};
    }
  }
  limits_ = limits;
  squares_.assign (directions, infinity);
  current_ = 0;
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
ScanBuilder::find (const Eigen::Vector3f& point)
{
  // Mostly a neighbour of the direction before.
  for (const std::size_t near : {current_ + 1, current_ - 1})
    if (isInside (point, near)) {
      current_ = near;
      return;
    }
  const float steps_in_turn = 6.2831853f / limits_.angle_increment;
  float steps = (std::atan2 (point.y(), point.x()) - limits_.angle_min) /
                    limits_.angle_increment +
                0.5f;
  steps -= steps_in_turn * std::floor (steps / steps_in_turn);
  current_ = std::min (static_cast<std::size_t> (steps), squares_.size());
}

void
ScanBuilder::finish()
{
  scan_->ranges.resize (squares_.size());
  for (std::size_t i = 0; i < squares_.size(); ++i)
    scan_->ranges[i] = std::sqrt (squares_[i]);
}

} // namespace rgbd_planes
} // namespace pcl
