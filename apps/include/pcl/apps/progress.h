// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <cstddef>

namespace pcl {
namespace rgbd_planes {

/** \brief Says on stderr how many frames are done, where that is a terminal and there
 * are several. */
void
showProgress (std::size_t done, std::size_t all);

} // namespace rgbd_planes
} // namespace pcl
