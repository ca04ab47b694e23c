// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The samples that a plane owns in a tile, a bit for each. */
struct TilePart {
  std::uint32_t plane, tile, own;
};

/** \brief Lists what planes own, tile after tile.
 * \param[in] owners the plane of each sample, less than 0 for none
 */
PCL_RGBD_PLANES_EXPORTS void
findTileParts (const std::vector<std::int32_t>& owners, std::vector<TilePart>& parts);

} // namespace rgbd_planes
} // namespace pcl
