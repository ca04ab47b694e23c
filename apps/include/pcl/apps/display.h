// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

namespace pcl {
namespace rgbd_planes {

/** \brief AppError where there is no X display that a window can be opened on, on which VTK
 * would end the program. */
void
checkDisplay ();

/** \brief Where the environment names no display, starts one without a screen (Xvfb) for this
 * program; AppError where that is not installed. */
void
provideDisplay ();

} // namespace rgbd_planes
} // namespace pcl
