// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <cmath>
#include <random>

namespace pcl {
namespace rgbd_planes {

/** \brief Random numbers that are the same with every standard library: its engines are
 * specified, its distributions are not. */
class Random {
public:
  explicit Random (unsigned seed) : engine_ (seed) {}

  /** \brief Uniform in [low, high). */
  float
  uniform (float low, float high)
  {
    return low + (high - low) * static_cast<float> (engine_() >> 8) * 0x1p-24f;
  }

  /** \brief Standard normal (Box and Muller). */
  float
  normal ()
  {
    const float radius = std::sqrt (-2.f * std::log (1.f - uniform (0.f, 1.f)));
    return radius * std::cos (uniform (0.f, 6.2831853f));
  }

private:
  std::mt19937 engine_;
};

} // namespace rgbd_planes
} // namespace pcl
