// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/filters/impl/plane_points.h>

#include <limits>

namespace pcl {
namespace rgbd_planes {

Eigen::Vector4f
planeVector (const ModelCoefficients& model)
{
  if (model.values.size() != 4)
    return Eigen::Vector4f::Constant (std::numeric_limits<float>::quiet_NaN());
  // Squares of what a float holds are no floats.
  const Eigen::Vector4d plane =
      Eigen::Map<const Eigen::Vector4f> (model.values.data()).cast<double>();
  const double sign = plane[3] < 0. ? -1. : 1.;
  return (sign / plane.head<3>().norm() * plane).cast<float>();
}

PlaneVectors
planeVectors (const std::vector<ModelCoefficients>& models)
{
  PlaneVectors planes;
  for (const auto& model : models)
    planes.push_back (planeVector (model));
  return planes;
}

Eigen::Vector4f
shifted (Eigen::Vector4f plane, const Eigen::Vector3f& shift)
{
  plane[3] -= plane.head<3>().dot (shift);
  return plane[3] < 0.f ? Eigen::Vector4f (-plane) : plane;
}

Eigen::Vector3d
inverseDistance (const Eigen::Vector4f& plane)
{
  return -plane.head<3>().cast<double>() / plane[3];
}

void
fillPlaneOf (const std::vector<PointIndices>& inliers,
             std::size_t size,
             std::vector<std::uint32_t>& plane_of)
{
  plane_of.assign (size, std::numeric_limits<std::uint32_t>::max());
  for (std::size_t k = 0; k < inliers.size(); ++k)
    for (const pcl::index_t index : inliers[k].indices)
      plane_of[static_cast<std::size_t> (index)] = static_cast<std::uint32_t> (k);
}

} // namespace rgbd_planes
} // namespace pcl
