// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/impl/concave_split.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** The runs of cells of one owner that are not cut. Cells are cut where, of two cells of the
 * owner on opposite sides, one lies above the tangent plane of the other.
 * \param[in] row the place of the first cell of a row of the image
 * \param[in] pixel_angle the angle between the rays of neighbouring cells, radians
 */
void
findUncut (const ClusterImage& image,
           std::size_t row,
           float pixel_angle,
           const DepthNoise& noise,
           std::vector<RunBits>& bits);

} // namespace rgbd_planes
} // namespace pcl
