// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief A pinhole camera; focal lengths and principal point in pixels, pixel centres
 * at whole numbers. */
struct Intrinsics {
  float fx = 0.f;
  float fy = 0.f;
  float cx = 0.f;
  float cy = 0.f;
};

/** \brief Depth along the optical axis, row by row from the top; 0 and 65535 are missing depth. */
struct DepthImage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint16_t> depth;
};

/** \brief Reads a 16-bit greyscale PNG; the stored numbers, whatever gamma the file
 * claims.
 *
 * Throws AppError where the file is missing, no PNG, incomplete, damaged, or not 16-bit
 * greyscale.
 */
DepthImage
readDepthPng (const std::string& file);

/** \brief Whether a file is a PNG of another kind than readDepthPng() reads, as colour images are;
 * false where it is damaged. */
bool
isOtherPng (const std::string& file);

/** \brief The points of a depth image.
 * \param[in] units_per_metre what the image holds at a depth of 1 m
 * \return an organized cloud of the size of the image in the camera frame (x right, y
 * down, z forward) in metres; NaN where depth is missing; black
 */
pcl::PointCloud<pcl::PointXYZRGB>::Ptr
toCloud (const DepthImage& image, const Intrinsics& intrinsics, float units_per_metre);

} // namespace rgbd_planes
} // namespace pcl
