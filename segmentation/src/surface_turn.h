// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <Eigen/Core>

namespace pcl {
namespace rgbd_planes {

/** \brief How much the normals of points turn with the place. */
struct SurfaceTurn {
  /** From one side of the points to the other: the root mean square, in radians. */
  double over_all = 0.;
  /** For each metre on the surface, in radians. */
  double per_metre = 0.;
  /** Along which they turn the most, a unit vector. */
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
  /** Where the points are in the mean, from where their sums are taken. */
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
};

/** \brief Fits the normals, seen along two directions in the plane with \a plane_normal, as
 * linear functions of the place in these directions.
 * \param[in] sums those of sumNormals()
 */
SurfaceTurn
turnOf (const double (&sums)[22], const Eigen::Vector3f& plane_normal);

} // namespace rgbd_planes
} // namespace pcl
