// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace pcl {
namespace rgbd_planes {

/** Points of a plane come as x and y in turn, in so many at once or a multiple of it. */
constexpr std::size_t hull_block = 16;

/** The numbers of points that are furthest out in eight directions, counterclockwise from x.
 * \param[in] size more than 0
 */
std::array<std::uint32_t, 8>
findOctagon (const float* xy, std::size_t size);

/** Moves the points that are not inside of an octagon to the front, in their order.
 * \param[in] octagon x and y of its corners, counterclockwise; some but not all
 * may be the same
 * \return their number
 */
std::size_t
dropInside (const float* octagon, float* xy, std::size_t size);

} // namespace rgbd_planes
} // namespace pcl
