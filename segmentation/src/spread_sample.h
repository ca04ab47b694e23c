// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <cstddef>

namespace pcl {
namespace rgbd_planes {

/** \brief Chooses one of each \a step numbers from 0 on. Every step-th point may be of the same few
 * columns of a thing whose rows are equally long, so places differ by the golden section, which
 * repeats no pattern and leaves no gaps. */
class SpreadSample {
public:
  explicit SpreadSample (std::size_t step) : step_ (step) {}

  /** \brief The next one, larger than those before. */
  std::size_t
  next ()
  {
    constexpr double golden_section = 0.6180339887;
    const auto chosen =
        begin_ + static_cast<std::size_t> (place_ * static_cast<double> (step_));
    begin_ += step_;
    place_ += place_ + golden_section < 1. ? golden_section : golden_section - 1.;
    return chosen;
  }

private:
  std::size_t step_;
  std::size_t begin_ = 0;
  double place_ = 0.; // in the step, 0 to 1
};

} // namespace rgbd_planes
} // namespace pcl
