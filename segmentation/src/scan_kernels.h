// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/impl/point_row.h>
#include <pcl/segmentation/impl/scan_builder.h>

#include <Eigen/Geometry>

namespace pcl {
namespace rgbd_planes {

/** Looks for the closest point of each column in its sector, and of each run.
 */
void
scanRuns (const PointRow& row,
          const Eigen::Affine3f& camera_to_base,
          const Eigen::Vector4f& floor,
          const ScanLimits& limits,
          const std::vector<ScanRun>& runs,
          ScanColumns& columns);

} // namespace rgbd_planes
} // namespace pcl
