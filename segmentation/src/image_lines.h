// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/organized_view.h>
#include <pcl/segmentation/impl/image_margins.h>
#include <pcl/segmentation/impl/pixel_angles.h>

namespace pcl {
namespace rgbd_planes {

// What a few rows and columns of an image tell of the sensor that took it.

/** \brief A twentieth of the image at each border, which may be ragged, and at the left and right
 * one bands in which next to nothing is measured, as what only one of two cameras sees. */
ImageMargins
marginsOf (const OrganizedPoints& points);

/** \brief The mean angles between the rays of neighbouring pixels. */
PixelAngles
pixelAngles (const OrganizedPoints& points);

/** \brief The angle between the rays of neighbouring pixels, in radians; 0 where no two are
 * measured. Where rows are farther apart than columns, as those of laser scanners are, it is that
 * between rows. */
float
meanPixelAngle (const OrganizedPoints& points);

/** \brief Whether single pixels without depth between two with depth are more than edges leave:
 * depth that is registered with another camera has lines of them. */
bool
hasLinesOfGaps (const OrganizedPoints& points);

} // namespace rgbd_planes
} // namespace pcl
