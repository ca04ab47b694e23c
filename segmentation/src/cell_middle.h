// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <algorithm>

namespace pcl {
namespace rgbd_planes {

/** Along one side of an image of so many \a pixels, the one in the middle of a cell of \a size
 * pixels, of which the last may be missing. */
inline int
middle (int cell, int size, int pixels)
{
  return std::min (cell * size + size / 2, pixels - 1);
}

} // namespace rgbd_planes
} // namespace pcl
