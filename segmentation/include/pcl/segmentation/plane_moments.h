// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>
#include <cstddef>

namespace pcl {
namespace rgbd_planes {

/** \brief A plane normal * p + d = 0; d >= 0, so that the normal faces the origin. */
struct Plane {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  float d = 0.f;

  float
  distance (const float* p) const
  {
    return normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2] + d;
  }
};

/** \brief Weighted sums of points, their coordinates and products: all that a
 * least-squares plane needs.
 *
 * Depth sensors err along the viewing ray, and a plane that does not contain the sensor
 * is m * p = 1 with m = -normal / d. What m * p is short of 1 is the relative error of
 * the range. So with points weighted by the inverse square of their relative standard
 * deviation, the sum of the weighted squares of m * p - 1 is that of errors in standard
 * deviations, and the best m solves three linear equations.
 */
struct PlaneMoments {
  double weight = 0.;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  std::size_t points = 0;

  void
  add (const float* p, double w)
  {
    const Eigen::Vector3d q (p[0], p[1], p[2]);
    weight += w;
    first += w * q;
    second += w * q * q.transpose();
    ++points;
  }

  /** \brief Adds sums over points relative to \a reference: of 1, x, y, z, xx, xy, xz,
   * yy, yz and zz. */
  void
  add (const double (&sums)[10], const Eigen::Vector3d& reference, std::size_t number)
  {
    const Eigen::Vector3d f (sums[1], sums[2], sums[3]);
    Eigen::Matrix3d s;
    s << sums[4], sums[5], sums[6], sums[5], sums[7], sums[8], sums[6], sums[8],
        sums[9];
    weight += sums[0];
    first += f + sums[0] * reference;
    second += s + reference * f.transpose() + f * reference.transpose() +
              sums[0] * reference * reference.transpose();
    points += number;
  }

  PlaneMoments&
  operator+= (const PlaneMoments& other)
  {
    weight += other.weight;
    first += other.first;
    second += other.second;
    points += other.points;
    return *this;
  }

  /** \brief The same points, with weights \a factor times as large. */
  PlaneMoments
  scaled (double factor) const
  {
    return {factor * weight, factor * first, factor * second, points};
  }

  Eigen::Vector3d
  mean () const
  {
    return first / weight;
  }

  Eigen::Matrix3d
  covariance () const
  {
    return second / weight - mean() * mean().transpose();
  }

  /** \brief The best m of the plane m * p = 1; not finite where points determine none.
   */
  Eigen::Vector3d
  inverseDistance () const
  {
    return second.inverse() * first;
  }

  /** \brief The weighted sum of the squares of m * p - 1. */
  double
  squaredErrors (const Eigen::Vector3d& m) const
  {
    return m.dot (second * m) - 2. * m.dot (first) + weight;
  }

  /** \brief The mean of the squares of the errors of the points on m * p = 1, in squared
   * standard deviations. */
  double
  meanSquaredError (const Eigen::Vector3d& m) const
  {
    return squaredErrors (m) / static_cast<double> (points);
  }

  /** \brief The mean error of the points on m * p = 1, in standard deviations. */
  double
  meanError (const Eigen::Vector3d& m) const
  {
    return (m.dot (first) - weight) / std::sqrt (weight * static_cast<double> (points));
  }

  /** \brief The sum, weighted, of squared distances to \a plane. */
  double
  squaredDistances (const Plane& plane) const
  {
    const Eigen::Vector3d n = plane.normal.cast<double>();
    const double d = plane.d;
    return n.dot (second * n) + 2. * d * n.dot (first) + d * d * weight;
  }
};

/** \brief The plane m * p = 1. */
inline Plane
planeOf (const Eigen::Vector3d& m)
{
  const double length = m.norm();
  return {(-m / length).cast<float>(), static_cast<float> (1. / length)};
}

/** \brief The covariance of the coefficients (a, b, c, d) of the plane m * p = 1 that
 * fits best to points with independent errors, to first order. */
inline Eigen::Matrix4d
parameterCovariance (const PlaneMoments& moments, const Eigen::Vector3d& m)
{
  const double d = 1. / m.norm();
  const Eigen::Vector3d n = -d * m;
  Eigen::Matrix<double, 4, 3> derivative;
  derivative.topRows<3>() = -d * (Eigen::Matrix3d::Identity() - n * n.transpose());
  derivative.bottomRows<1>() = d * d * n.transpose();
  return derivative * moments.second.inverse() * derivative.transpose();
}

} // namespace rgbd_planes
} // namespace pcl
