// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_source.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief Every step-th pixel of \a frame. AppError where these are less than \a min_pixels in
 * a row or column. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
measuredCloud (const Frame& frame, std::uint32_t step, std::uint32_t min_pixels);

/** \brief What to use where every step-th pixel are too few. */
std::string
adviceForMorePixels (std::uint32_t step);

} // namespace rgbd_planes
} // namespace pcl
