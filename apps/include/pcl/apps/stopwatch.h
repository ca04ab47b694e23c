// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <chrono>

namespace pcl {
namespace rgbd_planes {

/** \brief Runs from its construction on. */
class Stopwatch {
public:
  double
  milliseconds () const
  {
    return std::chrono::duration<double, std::milli> (Clock::now() - start_).count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

} // namespace rgbd_planes
} // namespace pcl
