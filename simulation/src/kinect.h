// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "random.h"
#include "renderer.h"

namespace pcl {
namespace rgbd_planes {

/** \brief The projector of the Kinect is 7.5 cm to the right of its infrared camera. */
constexpr float kinect_baseline_m = 0.075f;

/** \brief The depth image that a Kinect would measure, NaN where it has none. */
std::vector<float>
measureWithKinect (const std::vector<RenderedPixel>& image,
                   const Camera& camera,
                   Random& random);

} // namespace rgbd_planes
} // namespace pcl
