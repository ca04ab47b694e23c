// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <algorithm>
#include <cstddef>

namespace pcl {
namespace rgbd_planes {

/** \brief The fewest points of a plane in an image of so many pixels: 1000 of 640 x 480, in
 * proportion for others, and no fewer than 3. */
inline unsigned
minPlanePoints (std::size_t pixels)
{
  constexpr std::size_t fewest = 3;
  return static_cast<unsigned> (std::max (pixels * 1000 / (640 * 480), fewest));
}

/** \brief The fewest points of an object in an image of so many pixels: 40 of 640 x 480, in
 * proportion for others, and no fewer than 20. */
inline unsigned
minObjectPoints (std::size_t pixels)
{
  constexpr std::size_t fewest = 20;
  return static_cast<unsigned> (std::max (pixels * 40 / (640 * 480), fewest));
}

} // namespace rgbd_planes
} // namespace pcl
