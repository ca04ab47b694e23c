// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/point_labels.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>

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
 *
 * \param[out] labels if asked for, what readPointLabels() finds in the file
 */
pcl::PointCloud<pcl::PointXYZRGB>::Ptr
readOrganizedPcd (const std::string& file, PointLabels* labels = nullptr);

/** \brief Reads an image of 32-bit floats, the field intensity of an organized cloud. Throws
 * AppError as readOrganizedPcd() does. */
pcl::PointCloud<pcl::Intensity>
readIntensityPcd (const std::string& file);

} // namespace rgbd_planes
} // namespace pcl
