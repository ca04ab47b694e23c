// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>

namespace pcl {
namespace rgbd_planes {

/** \brief How many threads \a nr_threads stands for: itself, up to 256, or one for each
 * processor where it is 0. */
PCL_RGBD_PLANES_EXPORTS unsigned int
numberOfThreads (unsigned int nr_threads);

} // namespace rgbd_planes
} // namespace pcl
