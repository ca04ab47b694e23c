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

/** \brief Reads an organized cloud from a PCD file.
 *
 * Needs fields x, y, z (32-bit floats, metres); takes rgb or rgba where there is one,
 * points are black otherwise; other fields are left out. Points with NaN, Inf or (0, 0,
 * 0) come back as NaN.
 *
 * Throws AppError where the file is missing, no PCD, incomplete, damaged, unorganized
 * (a single row or column) or without coordinates.
 */
pcl::PointCloud<pcl::PointXYZRGB>::Ptr
readOrganizedPcd (const std::string& file);

/** \brief The labels of the points of a file that readOrganizedPcd() takes: its field \c label,
 * 32-bit and unsigned, or nothing where there is none. */
std::vector<std::uint32_t>
readPcdLabels (const std::string& file);

} // namespace rgbd_planes
} // namespace pcl
