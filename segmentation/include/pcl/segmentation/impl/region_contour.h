// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/types.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The outer boundary of a connected region of an image of labels, by Moore
 * neighbour tracing (Gonzalez and Woods, Digital Image Processing, 3rd edition, section
 * 11.1.1).
 *
 * The region are the pixels with the label of \a start that are 8-connected with it. The
 * edge of the image bounds it as other labels do; holes have no part in it. It starts at
 * \a start and runs clockwise as seen in the image; each pixel touches the one before,
 * and the last touches the first. Where the region is one pixel wide, pixels occur twice
 * or more, once for each side.
 *
 * \param[in] labels one for each pixel, row by row
 * \param[in] width pixels of a row
 * \param[in] start the first pixel of the region, row by row
 * \param[out] contour the pixels of the boundary; replaced
 */
PCL_RGBD_PLANES_EXPORTS void
traceContour (const std::vector<std::uint32_t>& labels,
              std::size_t width,
              index_t start,
              Indices& contour);

} // namespace rgbd_planes
} // namespace pcl
