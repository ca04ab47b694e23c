// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

/** PCL's own PCL_EXPORTS is empty on Linux, so that consumers built with hidden
 * visibility would not find the instantiations in the library. */
#if defined(__GNUC__)
#define PCL_RGBD_PLANES_EXPORTS __attribute__ ((visibility ("default")))
#else
#define PCL_RGBD_PLANES_EXPORTS
#endif
