// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/plane_moments.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

Eigen::Matrix3d
PlaneMoments::second() const
{
  Eigen::Matrix3d result;
  result << sums[4], sums[5], sums[6], sums[5], sums[7], sums[8], sums[6], sums[8],
      sums[9];
  return result;
}

Eigen::Matrix3d
PlaneMoments::covariance() const
{
  return second() / weight() - mean() * mean().transpose();
}

double
PlaneMoments::curvature() const
{
  const Eigen::Matrix3d matrix = covariance();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (matrix,
                                                               Eigen::EigenvaluesOnly);
  // Rounding may leave a little less than 0.
  return std::max (solver.eigenvalues()[0], 0.) / matrix.trace();
}

Eigen::Vector3d
PlaneMoments::inverseDistance() const
{
  return second().inverse() * first();
}

bool
PlaneMoments::determinePlane (double max_error) const
{
  constexpr double least_ratio = 1e-12;
  const Eigen::Vector3d m = inverseDistance();
  // The covariance of m is the inverse of the second moments.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (second(),
                                                               Eigen::EigenvaluesOnly);
  const double least = solver.eigenvalues()[0];
  return least > least_ratio * solver.eigenvalues()[2] &&
         least * m.squaredNorm() * max_error * max_error > 1.;
}

double
PlaneMoments::squaredErrors (const Eigen::Vector3d& m) const
{
  return m.dot (second() * m) - 2. * m.dot (first()) + weight();
}

double
PlaneMoments::meanError (const Eigen::Vector3d& m) const
{
  return (m.dot (first()) - weight()) /
         std::sqrt (weight() * static_cast<double> (points));
}

double
PlaneMoments::squaredDistances (const Plane& plane) const
{
  const Eigen::Vector3d n = plane.normal.cast<double>();
  const double d = plane.d;
  return n.dot (second() * n) + 2. * d * n.dot (first()) + d * d * weight();
}

Plane
planeOf (const Eigen::Vector3d& m)
{
  const double length = m.norm();
  return {(-m / length).cast<float>(), static_cast<float> (1. / length)};
}

Eigen::Matrix4d
parameterCovariance (const PlaneMoments& moments, const Eigen::Vector3d& m)
{
  const double d = 1. / m.norm();
  const Eigen::Vector3d n = -d * m;
  Eigen::Matrix<double, 4, 3> derivative;
  derivative.topRows<3>() = -d * (Eigen::Matrix3d::Identity() - n * n.transpose());
  derivative.bottomRows<1>() = d * d * n.transpose();
  return derivative * moments.second().inverse() * derivative.transpose();
}

Eigen::Matrix4d
shiftedCovariance (const Eigen::Matrix4d& covariance, const Eigen::Vector3d& shift)
{
  Eigen::Matrix4d derivative = Eigen::Matrix4d::Identity();
  derivative.bottomLeftCorner<1, 3>() = -shift.transpose();
  return derivative * covariance * derivative.transpose();
}

} // namespace rgbd_planes
} // namespace pcl
