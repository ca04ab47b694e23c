// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The noise of a frame: \a noise itself or, where that is the least and the frame is
 * noisier, \a noise times their ratio, up to 4: more is fine structure, as of a fence or leaves.
 *
 * The ratio is a median over small rectangles of the image. What counts is the inverse range at
 * two opposite corners less that at the other two, which is 0 on planes and on cylinders along
 * the image, divided by the standard deviation that \a noise predicts for it. Errors that are
 * smooth over an eightieth of the image's longer side are not seen. Where fewer than a hundred
 * rectangles have all their corners, the noise is taken for the least. Where the
 * quadratic part of the noise is more than a tenth of the range, depth is beyond that of the
 * result.
 *
 * \param[in] selected not 0 for the points to look at; empty for all
 */
PCL_RGBD_PLANES_EXPORTS DepthNoise
noiseIn (const OrganizedPoints& points,
         const std::vector<std::uint8_t>& selected,
         const DepthNoise& noise);

/** \brief What setters of the noise of a sensor do: \a noise becomes \a value. One that is
 * negative, 0 at a range of 1 m, not finite, without a range, or with a scatter of normals that is
 * not 1 to 5: an error message, and the noise before stays. */
PCL_RGBD_PLANES_EXPORTS void
setDepthNoise (const std::string& class_name,
               const DepthNoise& value,
               DepthNoise& noise);

} // namespace rgbd_planes
} // namespace pcl
