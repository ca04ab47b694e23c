// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/ModelCoefficients.h>

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Where a camera is whose pose is unknown: the largest plane that faces up in its
 * image, within 60 degrees, or else the largest one, is taken for a floor or table at height
 * 0, see cameraToBaseFromFloor().
 * \param[in] planes by decreasing number of points, facing the camera
 * \return nothing where there is no plane
 */
std::optional<Eigen::Affine3f>
estimateCameraToBase (const std::vector<pcl::ModelCoefficients>& planes);

} // namespace rgbd_planes
} // namespace pcl
