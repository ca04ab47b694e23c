// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "surface_turn.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

namespace pcl {
namespace rgbd_planes {

SurfaceTurn
turnOf (const double (&sums)[22], const Eigen::Vector3f& plane_normal)
{
  const double weight = sums[0];
  if (!(weight > 0.))
    return {};
  const Eigen::Vector3d place = Eigen::Vector3d (sums[1], sums[2], sums[3]) / weight;
  const Eigen::Vector3d normal =
      Eigen::Vector3d (sums[10], sums[11], sums[12]) / weight;
  Eigen::Matrix3d places, normals;
  places << sums[4], sums[5], sums[6], sums[5], sums[7], sums[8], sums[6], sums[8],
      sums[9];
  normals << sums[13], sums[14], sums[15], sums[16], sums[17], sums[18], sums[19],
      sums[20], sums[21];
  const Eigen::Vector3d n = plane_normal.cast<double>();
  Eigen::Matrix<double, 2, 3> directions;
  directions.row (0) = n.unitOrthogonal();
  directions.row (1) = n.cross (n.unitOrthogonal());
  const Eigen::Matrix2d spread = directions *
                                 (places / weight - place * place.transpose()) *
                                 directions.transpose();
  const Eigen::Matrix2d turning = directions *
                                  (normals / weight - normal * place.transpose()) *
                                  directions.transpose();
  const Eigen::Matrix2d bend =
      turning * (spread + 1e-9 * Eigen::Matrix2d::Identity()).inverse();
  const Eigen::Matrix2d squares = bend.transpose() * bend;
  const double angle =
      0.5 * std::atan2 (2. * squares (0, 1), squares (0, 0) - squares (1, 1));
  const Eigen::Vector2d direction (std::cos (angle), std::sin (angle));
  return {std::sqrt ((bend * spread * bend.transpose()).trace()),
          bend.norm(),
          directions.transpose() * direction};
}

} // namespace rgbd_planes
} // namespace pcl
