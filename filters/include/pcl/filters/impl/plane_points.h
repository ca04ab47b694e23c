// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/ModelCoefficients.h>
#include <pcl/PointIndices.h>

#include <Eigen/Core>
#include <Eigen/StdVector>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief a, b, c, d of planes with unit normals. */
using PlaneVectors =
    std::vector<Eigen::Vector4f, Eigen::aligned_allocator<Eigen::Vector4f>>;

/** \brief a, b, c, d with a unit normal towards the origin; NaN for what has no four finite
 * coefficients and a normal. */
PCL_RGBD_PLANES_EXPORTS Eigen::Vector4f
planeVector (const ModelCoefficients& model);

PCL_RGBD_PLANES_EXPORTS PlaneVectors
planeVectors (const std::vector<ModelCoefficients>& models);

/** \brief The plane of points that are shifted by \a shift, its normal towards the origin. */
PCL_RGBD_PLANES_EXPORTS Eigen::Vector4f
shifted (Eigen::Vector4f plane, const Eigen::Vector3f& shift);

/** \brief m of m * p = 1 for the points p of a plane. */
PCL_RGBD_PLANES_EXPORTS Eigen::Vector3d
inverseDistance (const Eigen::Vector4f& plane);

/** \brief The default of ProjectOntoPlanes::setMaxRayFactor(). */
constexpr float default_max_ray_factor = 10.f;

/** \brief A point of the plane: where the ray from \a sensor through \a point meets it, or the
 * nearest one where that is farther than \a max_ray_factor times the distance of \a point from
 * the plane, or behind the sensor. \a point itself for planes that are NaN. */
inline Eigen::Vector3f
projectOnto (const Eigen::Vector4f& plane,
             const Eigen::Vector3f& sensor,
             const Eigen::Vector3f& point,
             float max_ray_factor)
{
  const Eigen::Vector3f normal = plane.head<3>();
  const Eigen::Vector3f ray = point - sensor;
  const float along_normal = normal.dot (ray);
  const float d = plane[3] + normal.dot (sensor);
  const float distance = along_normal + d;
  if (!std::isfinite (distance))
    return point;
  const float scale = -d / along_normal;
  const bool is_steep = std::abs (along_normal) * max_ray_factor > ray.norm();
  if (is_steep && scale > 0.f)
    return sensor + scale * ray;
  return point - distance * normal;
}

/** \brief For each of \a size points the last plane that it is an inlier of, or a number
 * beyond. */
PCL_RGBD_PLANES_EXPORTS void
fillPlaneOf (const std::vector<PointIndices>& inliers,
             std::size_t size,
             std::vector<std::uint32_t>& plane_of);

} // namespace rgbd_planes
} // namespace pcl
