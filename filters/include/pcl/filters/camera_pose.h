// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>

#include <Eigen/Geometry>

#include <optional>
#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief From the camera frame (x right, y down, z forward) to the base frame of a robot
 * (x forward, y left, z up) where the pose of the camera is unknown: the axes are
 * exchanged, and y is shifted by the 2 cm between the colour and the infrared camera (Holz
 * et al. 2011, section 3). The height of the camera stays unknown: its own is z = 0. */
PCL_RGBD_PLANES_EXPORTS Eigen::Affine3f
defaultCameraToBase ();

/** \brief The pose of a camera that sees a floor: height, roll and pitch.
 *
 * In the base frame that results, the floor is z = 0, the camera is above the origin, and
 * x is the viewing direction projected onto the floor; where the camera looks straight up
 * or down (within 1 degree), x is the upward direction of its image.
 * \param[in] floor a, b, c, d with a x + b y + c z + d = 0 in the camera frame, in metres,
 * of any sign and length
 * \return nothing where \a floor is no plane: (a, b, c) is zero, or a value is not finite
 */
PCL_RGBD_PLANES_EXPORTS std::optional<Eigen::Affine3f>
cameraToBaseFromFloor (const Eigen::Vector4f& floor);

/** \brief Whether \a transform only turns and shifts, within 1e-3. */
PCL_RGBD_PLANES_EXPORTS bool
isRigid (const Eigen::Affine3f& transform);

/** \brief What setters of poses do: \a transform becomes \a value. One that is not rigid: an
 * error message with the name of the setter, and the one before stays.
 * \return whether \a transform has become \a value
 */
PCL_RGBD_PLANES_EXPORTS bool
setTransform (const std::string& setter,
              const Eigen::Affine3f& value,
              Eigen::Affine3f& transform);

} // namespace rgbd_planes
} // namespace pcl
