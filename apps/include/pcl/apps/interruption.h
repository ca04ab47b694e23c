// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

namespace pcl {
namespace rgbd_planes {

/** \brief From now on, the first SIGINT (Ctrl-C), SIGTERM or SIGHUP does not end the program,
 * unless it is ignored, but is found by the functions below, and ends waiting for a file. Others
 * within two seconds change nothing, so that it can clean up; a later one ends it. Those of a full
 * quota (SIGXFSZ) or a reader that has ended (SIGPIPE) become errors of writing: temporary files
 * go. To be called before the first of them is written. */
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
