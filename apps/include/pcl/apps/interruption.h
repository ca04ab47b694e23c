// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

namespace pcl {
namespace rgbd_planes {

/** \brief From now on, SIGINT (Ctrl-C), SIGTERM and SIGHUP do not end the program, however often
 * they come, so that it can clean up; SIGQUIT still does. The functions below tell of them, and
 * waiting for a file ends; those that are ignored stay so. Those of a full quota (SIGXFSZ) or a
 * reader that has ended (SIGPIPE) become errors of writing. To be called before the first
 * temporary file is written. */
void
catchInterruption ();

/** \brief Whether a signal came. */
bool
isInterrupted ();

/** \brief Throws AppError if a signal came. To be called after each frame, before each
 * method that is compared on it, and before files are committed. */
void
stopIfInterrupted ();

} // namespace rgbd_planes
} // namespace pcl
