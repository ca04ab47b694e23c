// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

namespace pcl {
namespace rgbd_planes {

/** \brief Angles between the rays of neighbouring pixels, in radians; 0 where no two are
 * measured. */
struct PixelAngles {
  float in_row = 0.f, in_column = 0.f;
};

} // namespace rgbd_planes
} // namespace pcl
