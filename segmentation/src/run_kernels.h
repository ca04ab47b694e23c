// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/impl/linked_runs.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** The runs of a row of points in the same places, of those after \a outside.
 * \param[in] places of the points of the row, and of one more
 * \param[in] places_above of the row above
 * \param[in] to_left not 0 for points that are close to the one before; 0 for the first one
 * \param[in] to_above not 0 for points that are close to the one above
 * \param[in] blocks not 0 for blocks with points of runs
 */
void
findRunBits (const std::uint8_t* places,
             const std::uint8_t* places_above,
             std::uint8_t outside,
             const std::uint8_t* to_left,
             const std::uint8_t* to_above,
             const std::uint8_t* blocks,
             std::vector<RunBits>& bits);

} // namespace rgbd_planes
} // namespace pcl
