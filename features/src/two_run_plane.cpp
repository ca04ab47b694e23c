// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "two_run_plane.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Neighbours whose spread across their main direction is a thousandth of that along it
 * are taken for a line. */
constexpr double min_squared_spread = 1e-6;

/** Neighbours this many root mean squares away from the first plane do not count. */
constexpr double cutoff = 2.5;

/** Sums over weighted neighbours that give their mean and covariance. */
struct Moments {
  double weight = 0.;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  void
  add (const Eigen::Vector3d& p, double w)
  {
    const Eigen::Vector3d wp = w * p;
    weight += w;
    first += wp;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j)
        second (j, i) += wp[i] * p[j];
  }
};

bool
principalPlane (const Moments& moments, LocalPlane& plane)
{
  const Eigen::Vector3d mean = moments.first / moments.weight;
  // The solver reads the lower triangle only.
  const Eigen::Matrix3d covariance =
      moments.second / moments.weight - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect (covariance);
  const Eigen::Vector3d eigenvalues = solver.eigenvalues().cwiseMax (0.);
  if (!(eigenvalues[1] > min_squared_spread * eigenvalues[2]))
    return false;
  plane.normal = solver.eigenvectors().col (0).cast<float>();
  plane.curvature = static_cast<float> (eigenvalues[0] / eigenvalues.sum());
  return true;
}

} // namespace

bool
fitPlaneInTwoRuns (const std::vector<Eigen::Vector3f>& neighbours, LocalPlane& plane)
{
  if (neighbours.size() < 3)
    return false;
  Moments all;
  for (const Eigen::Vector3f& p : neighbours)
    all.add (p.cast<double>(), 1.);
  if (!principalPlane (all, plane))
    return false;

  const Eigen::Vector3d normal = plane.normal.cast<double>();
  const double mean_square =
      normal.dot (all.second.selfadjointView<Eigen::Lower>() * normal) / all.weight;
  if (!(mean_square > 0.))
    return true;
  Moments weighted;
  for (const Eigen::Vector3f& p : neighbours) {
    const double distance = normal.dot (p.cast<double>());
    const double root =
        std::max (1. - distance * distance / (cutoff * cutoff * mean_square), 0.);
    weighted.add (p.cast<double>(), root * root);
  }
  // Where the second run leaves a line only, the plane of the first one stands.
  principalPlane (weighted, plane);
  return true;
}

} // namespace rgbd_planes
} // namespace pcl
