// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "random.h"

#include <pcl/simulation/simulate.h>

#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Standard normal noise of the pixels of an image, row by row, averaged over windows
 * of this size, in pixels. */
std::vector<float>
correlatedNoise (const Camera& camera,
                 int window_width,
                 int window_height,
                 Random& random);

} // namespace rgbd_planes
} // namespace pcl
