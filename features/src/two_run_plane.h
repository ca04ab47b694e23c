// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The direction of a surface at a point. */
struct LocalPlane {
  /** Of unit length, with either sign. */
  Eigen::Vector3f normal;
  /** Smallest eigenvalue of the covariance over the sum of all, 0 to 1/3. */
  float curvature;
};

/** \brief Principal component analysis in two runs (Holz et al. 2011, section 3).
 *
 * The first run fits a plane to all neighbours. In the second one each of them has a
 * weight that falls with its distance d to the plane through the point itself with the
 * first normal, so that the other side of an edge counts for less: Tukey's biweight
 * (1 - (d / 2.5 s)^2)^2, and 0 from 2.5 s on, where s is the root mean square of all d. Of
 * Gaussian, Cauchy-like and biweight functions over s or over the median of |d|, it
 * keeps most of noisy creases and, with the scale it takes from the data, costs least
 * on noisy planes.
 * \param[in] neighbours their positions relative to the point, in any unit; the point
 * itself (0, 0, 0) is usually one of them
 * \param[out] plane the plane of the second run
 * \return false if there are fewer than 3 neighbours, or they lie on a line
 */
bool
fitPlaneInTwoRuns (const std::vector<Eigen::Vector3f>& neighbours, LocalPlane& plane);

} // namespace rgbd_planes
} // namespace pcl
