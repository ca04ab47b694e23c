// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>

#include <Eigen/Core>

#include <cstddef>

namespace pcl {
namespace rgbd_planes {

/** \brief A plane normal * p + d = 0; d >= 0 relative to the sensor, which the normal
 * faces. */
struct Plane {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  float d = 0.f;

  float
  distance (const float* p) const
  {
    return normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2] + d;
  }

  /** \brief The same one where points are shifted by \a shift. */
  Plane
  shifted (const Eigen::Vector3f& shift) const
  {
    return {normal, d - normal.dot (shift)};
  }
};

/** \brief Turns sums over points relative to \a reference, in the order of
 * PlaneMoments::sums, into sums over the points themselves. */
inline void
shiftSums (const Eigen::Vector3d& reference, double (&sums)[10])
{
  const double x = reference[0], y = reference[1], z = reference[2];
  const double w = sums[0], wx = sums[1], wy = sums[2], wz = sums[3];
  sums[1] += w * x;
  sums[2] += w * y;
  sums[3] += w * z;
  sums[4] += x * (wx + sums[1]);
  sums[5] += x * wy + y * sums[1];
  sums[6] += x * wz + z * sums[1];
  sums[7] += y * (wy + sums[2]);
  sums[8] += y * wz + z * sums[2];
  sums[9] += z * (wz + sums[3]);
}

/** \brief Weighted sums of points, their coordinates and products: all that a
 * least-squares plane needs.
 *
 * Depth sensors err along the viewing ray, and a plane that does not contain the sensor
 * is m * p = 1 with m = -normal / d. What m * p is short of 1 is the relative error of
 * the range. So with points weighted by the inverse square of their relative standard
 * deviation, the sum of the weighted squares of m * p - 1 is that of errors in standard
 * deviations, and the best m solves three linear equations.
 */
struct PCL_RGBD_PLANES_EXPORTS PlaneMoments {
  /** Of 1, x, y, z, xx, xy, xz, yy, yz and zz. */
  double sums[10] = {};
  std::size_t points = 0;

  void
  add (const float* p, double w)
  {
    const double x = p[0], y = p[1], z = p[2];
    const double of_point[10] = {w,
                                 w * x,
                                 w * y,
                                 w * z,
                                 w * x * x,
                                 w * x * y,
                                 w * x * z,
                                 w * y * y,
                                 w * y * z,
                                 w * z * z};
    add (of_point, 1);
  }

  /** \brief Adds sums over so many points, \a factor times. */
  void
  add (const double (&others)[10], std::size_t number, double factor = 1.)
  {
    for (int k = 0; k < 10; ++k)
      sums[k] += factor * others[k];
    points += number;
  }

  PlaneMoments&
  operator+= (const PlaneMoments& other)
  {
    add (other.sums, other.points);
    return *this;
  }

  PlaneMoments&
  operator-= (const PlaneMoments& other)
  {
    for (int k = 0; k < 10; ++k)
      sums[k] -= other.sums[k];
    points -= other.points;
    return *this;
  }

  double
  weight () const
  {
    return sums[0];
  }

  Eigen::Vector3d
  first () const
  {
    return {sums[1], sums[2], sums[3]};
  }

  Eigen::Matrix3d
  second () const;

  Eigen::Vector3d
  mean () const
  {
    return first() / weight();
  }

  Eigen::Matrix3d
  covariance () const;

  /** \brief The smallest eigenvalue of the covariance by the sum of all, 0 to 1 / 3. */
  double
  curvature () const;

  /** \brief The best m of the plane m * p = 1; not finite where points determine none.
   */
  Eigen::Vector3d
  inverseDistance () const;

  /** \brief Whether noise leaves the direction of the best plane certain to \a max_error radians
   * in the standard deviation; points in a line do not. */
  bool
  determinePlane (double max_error) const;

  /** \brief The weighted sum of the squares of m * p - 1. */
  double
  squaredErrors (const Eigen::Vector3d& m) const;

  /** \brief The mean of the squares of the errors of the points on m * p = 1, in squared
   * standard deviations. */
  double
  meanSquaredError (const Eigen::Vector3d& m) const
  {
    return squaredErrors (m) / static_cast<double> (points);
  }

  /** \brief The mean error of the points on m * p = 1, in standard deviations. */
  double
  meanError (const Eigen::Vector3d& m) const;

  /** \brief The sum, weighted, of squared distances to \a plane. */
  double
  squaredDistances (const Plane& plane) const;
};

/** \brief The plane m * p = 1. */
PCL_RGBD_PLANES_EXPORTS Plane
planeOf (const Eigen::Vector3d& m);

/** \brief The covariance of the coefficients (a, b, c, d) of the plane m * p = 1 that
 * fits best to points with independent errors, to first order. */
PCL_RGBD_PLANES_EXPORTS Eigen::Matrix4d
parameterCovariance (const PlaneMoments& moments, const Eigen::Vector3d& m);

/** \brief The covariance of the coefficients of the plane where points are shifted. */
PCL_RGBD_PLANES_EXPORTS Eigen::Matrix4d
shiftedCovariance (const Eigen::Matrix4d& covariance, const Eigen::Vector3d& shift);

} // namespace rgbd_planes
} // namespace pcl
