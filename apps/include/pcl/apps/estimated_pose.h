// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/ModelCoefficients.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The plane that is taken for a floor or table at height 0 where the pose of the camera
 * is unknown: the largest one that faces up in its image, within 60 degrees, or else the
 * largest one.
 * \param[in] planes by decreasing number of points, facing the camera
 * \return 0 where there is no plane
 */
std::size_t
findLikelyFloor (const std::vector<pcl::ModelCoefficients>& planes);

/** \brief Where a camera is whose pose is unknown, see findLikelyFloor() and
 * cameraToBaseFromFloor(); nothing where there is no plane. */
std::optional<Eigen::Affine3f>
estimateCameraToBase (const std::vector<pcl::ModelCoefficients>& planes);

/** \brief The heights of planes that may support objects, in metres: the least and the largest. */
using PlaneHeights = std::array<double, 2>;

/** \brief Those of the paper; more where the pose of the camera is unknown, for what has height 0
 * may be a table. */
PlaneHeights
planeHeights (bool is_pose_known);

} // namespace rgbd_planes
} // namespace pcl
