// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "random.h"
#include "renderer.h"

#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Where the infrared camera and the projector of a Kinect are, 7.5 cm apart, in
 * the frame of its colour camera: it measures only what both of them and the colour
 * camera see. */
std::vector<Eigen::Vector3f>
kinectEyes ();

/** \brief The depth that a Kinect measures, row by row, in metres; NaN where it has
 * none.
 *
 * Depth is registered to the colour camera, as all drivers can do. Errors are made
 * where they arise, in the disparity between the infrared image and the reference
 * pattern (Khoshelham and Elberink 2012; Handa et al. 2014, after Barron and Malik
 * 2013; Nguyen et al. 2012); doc/simulation.md compares the result with recordings.
 * \param[in,out] camera_random draws, last, what belongs to the camera: the warp
 */
std::vector<float>
measureWithKinect (const std::vector<RenderedPixel>& image,
                   const Camera& camera,
                   Random& random,
                   Random& camera_random);

} // namespace rgbd_planes
} // namespace pcl
