// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Disjoint sets of numbers (union-find), of pixels or runs. The root of a set is its
 * smallest number. */
class DisjointSets {
public:
  void
  resize (std::size_t numbers)
  {
    parent_.resize (numbers);
  }

  /** \brief Starts anew with so many numbers, each a set of its own. */
  void
  start (std::size_t numbers)
  {
    parent_.resize (numbers);
    std::iota (parent_.begin(), parent_.end(), 0u);
  }

  /** \brief Makes \a i a set of its own; needed after resize() before all else is asked of it. */
  void
  add (std::uint32_t i)
  {
    parent_[i] = i;
  }

  std::uint32_t
  root (std::uint32_t i)
  {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }

  void
  join (std::uint32_t i, std::uint32_t j)
  {
    const std::uint32_t a = root (i), b = root (j);
    parent_[std::max (a, b)] = std::min (a, b);
  }

private:
  std::vector<std::uint32_t> parent_;
};

} // namespace rgbd_planes
} // namespace pcl
