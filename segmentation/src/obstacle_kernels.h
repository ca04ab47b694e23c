// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "plane_kernels.h"

#include <pcl/segmentation/obstacle_points.h>
#include <pcl/segmentation/point_row.h>
#include <pcl/segmentation/scan_builder.h>

#include <Eigen/Geometry>

namespace pcl {
namespace rgbd_planes {

// Thresholds in standard deviations of the height of a point. On simulated floors, no
// point exceeds the first, and 0.01 % of the windows the second: the warp of a Kinect's
// depth moves their means, though not their noise, as much as that of points.
constexpr float point_sigmas = 4.5f;
constexpr float window_sigmas = 2.75f;
/** Below the floor: real sensors also measure far depth too long, which bends floors
 * downwards by more than their noise. */
constexpr float drop_sigmas = 8.f;

/** Tells what the points of a row are by their heights above the floor alone, and adds those
 * that may be floor to the sums of \a result. */
void
classifyRow (const PointRow& row,
             const Eigen::Vector4f& floor,
             const ObstaclePointParameters& parameters,
             ObstacleRow& result);

/** Moves the points of a row to another frame.
 * \param[out] x, y, z arrays as long as the row
 * \param[out] squares of their distance from the z axis
 */
void
moveRow (const PointRow& row,
         const Eigen::Affine3f& transform,
         float* x,
         float* y,
         float* z,
         float* squares);

/** The smallest of \a values, without those that are NaN; infinite without any. */
float
minimum (const float* values, std::size_t count);

/** Looks for the closest point of each column in its sector.
 * \param[in] size of the row, a multiple of PointRow::block_size
 * \return whether there are strays
 */
bool
scanRow (const float* x,
         const float* y,
         const float* z,
         std::size_t size,
         const ScanLimits& limits,
         ScanColumns& columns);

} // namespace rgbd_planes
} // namespace pcl
