// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_source.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>

namespace pcl {
namespace rgbd_planes {

/** \brief The fewest pixels in a row or column for PCL's integral-image normals: their smoothing
 * area, 20 pixels, has to be inside the image. */
constexpr std::uint32_t min_pcl_pixels = 40;

/** \brief Every step-th pixel of \a frame. AppError where these are less than \a min_pixels in
 * a row or column. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
measuredCloud (const Frame& frame, std::uint32_t step, std::uint32_t min_pixels);

} // namespace rgbd_planes
} // namespace pcl
