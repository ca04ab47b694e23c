// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/impl/object_parameters.h>
#include <pcl/segmentation/impl/point_row.h>
#include <pcl/segmentation/impl/support_planes.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** Added to the place of a point that lies over the bounds of the surroundings of its plane, but
 * may be outside of its outline. */
constexpr std::uint8_t maybe_above = 128;

/** For each measured point, the first of \a planes that it lies on or above, within the bounds
 * of its surroundings and up to the largest height of an object.
 * \param[in] v the number of the row in the image, for the warp of the planes
 * \param[in] is_background 1 for points to leave out, else 0; one for each point of the blocks
 * \param[out] places 0 where the point is left out, or on that plane within noise, 1 where
 * there is no such plane, 2 + k where it is above the plane number k, \ref maybe_above more
 * where that is not certain, or where it may be on that plane, a platform
 * \param[out] has_above for each block of the row, 0 where no point is above a plane, 1 where
 * some are for certain, 2 where some may be
 */
void
placeRow (const PointRow& row,
          int v,
          const std::vector<const SupportSurface*>& planes,
          const ObjectParameters& parameters,
          const std::uint8_t* is_background,
          std::uint8_t* places,
          std::uint8_t* has_above);

} // namespace rgbd_planes
} // namespace pcl
