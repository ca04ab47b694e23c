// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "surface_turn.h"

#include <pcl/segmentation/impl/plane_moments.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pcl {
namespace rgbd_planes {

SurfaceTurn
turnOf (const double (&sums)[22], const Eigen::Vector3f& plane_normal)
{
  PlaneMoments places;
  std::copy_n (sums, std::size (places.sums), places.sums);
  const double weight = places.weight();
  if (!(weight > 0.))
    return {};
  const Eigen::Vector3d place = places.mean();
  const Eigen::Vector3d normal =
      Eigen::Vector3d (sums[10], sums[11], sums[12]) / weight;
  Eigen::Matrix3d normals;
  normals << sums[13], sums[14], sums[15], sums[16], sums[17], sums[18], sums[19],
      sums[20], sums[21];
  const Eigen::Vector3d n = plane_normal.cast<double>();
  Eigen::Matrix<double, 2, 3> directions;
  directions.row (0) = n.unitOrthogonal();
  directions.row (1) = n.cross (n.unitOrthogonal());
  const Eigen::Matrix2d spread =
      directions * places.covariance() * directions.transpose();
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
          directions.transpose() * direction,
          place};
}

} // namespace rgbd_planes
} // namespace pcl
