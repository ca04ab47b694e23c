// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

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
 * least-squares plane needs. */
struct PlaneMoments {
  double weight = 0.;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero(); // lower triangle
  std::size_t points = 0;

  void
  add (const float* p, double w)
  {
    const double x = p[0], y = p[1], z = p[2];
    weight += w;
    first += w * Eigen::Vector3d (x, y, z);
    second (0, 0) += w * x * x;
    second (1, 0) += w * y * x;
    second (1, 1) += w * y * y;
    second (2, 0) += w * z * x;
    second (2, 1) += w * z * y;
    second (2, 2) += w * z * z;
    ++points;
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

  Eigen::Vector3d
  mean () const
  {
    return first / weight;
  }

  Eigen::Matrix3d
  covariance () const
  {
    const Eigen::Matrix3d full = second.selfadjointView<Eigen::Lower>();
    return full / weight - mean() * mean().transpose();
  }

  /** \brief The plane with the least weighted sum of squared distances. */
  Plane
  fit () const
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (covariance());
    Eigen::Vector3d normal = solver.eigenvectors().col (0);
    double d = -normal.dot (mean());
    if (d < 0.) {
      normal = -normal;
      d = -d;
    }
    return {normal.cast<float>(), static_cast<float> (d)};
  }

  /** \brief The weighted sum of squared distances to \a plane. */
  double
  squaredDistances (const Plane& plane) const
  {
    const Eigen::Vector3d n = plane.normal.cast<double>();
    const double d = plane.d;
    const double quadratic = n.dot (second.selfadjointView<Eigen::Lower>() * n);
    return quadratic + 2. * d * n.dot (first) + d * d * weight;
  }
};

} // namespace rgbd_planes
} // namespace pcl
