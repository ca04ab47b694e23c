// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <cstdint>

namespace pcl {
namespace rgbd_planes {

/** \brief Columns at the left and right border of an image, and rows at the upper and lower one. */
struct ImageMargins {
  std::uint32_t left = 0, right = 0, above = 0, below = 0;
};

} // namespace rgbd_planes
} // namespace pcl
