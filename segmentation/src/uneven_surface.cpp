// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "uneven_surface.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** The error of points on an uneven surface is larger. */
constexpr double min_error = 0.72;
/** Strips are longer, in widths. */
constexpr double max_length = 5.;
/** Walls are wider, in metres, and clothes hardly are. Of the least share of near normals,
 * this one is enough on them, and less the wider they are: far ones that the camera bends have
 * little more, and those of depth with gaps much less. */
constexpr double max_uneven_width = 0.6, enough_if_wide = 0.8;

} // namespace

bool
isUneven (const PlaneMoments& points,
          double error,
          double near_normals,
          double min_near_normals)
{
  if (!(error > min_error && near_normals < min_near_normals))
    return false;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (points.covariance(),
                                                               Eigen::EigenvaluesOnly);
  const Eigen::Vector3d& squares = solver.eigenvalues();
  // The normals of strips do not tell: they are averages over windows that reach beyond.
  if (squares[2] > max_length * max_length * squares[1])
    return false;
  const double width = std::sqrt (12. * squares[1]); // of a rectangle full of points
  return width < max_uneven_width ||
         near_normals * width < enough_if_wide * min_near_normals * max_uneven_width;
}

} // namespace rgbd_planes
} // namespace pcl
