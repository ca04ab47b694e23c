// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "random.h"
#include "renderer.h"

#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Where the second imager of an active stereo camera is, 5 cm right of the first, in
 * the frame of which depth is: it measures only what both see. */
std::vector<Eigen::Vector3f>
activeStereoEyes ();

/** \brief The depth that an active stereo camera measures, row by row, in metres; NaN where it
 * has none.
 *
 * The error of disparity is that of DepthNoise::activeStereo () and shared by the pixels of a
 * window, as on the floor of a recording (doc/simulation.md).
 */
std::vector<float>
measureWithActiveStereo (const std::vector<RenderedPixel>& image,
                         const Camera& camera,
                         Random& random);

} // namespace rgbd_planes
} // namespace pcl
