// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/estimated_pose.h>
#include <pcl/filters/camera_pose.h>

#include <algorithm>

namespace pcl {
namespace rgbd_planes {

std::size_t
findLikelyFloor (const std::vector<pcl::ModelCoefficients>& planes)
{
  constexpr float min_cosine = 0.5f;
  const auto facing_up = std::find_if (
      planes.begin(), planes.end(), [] (const pcl::ModelCoefficients& plane) {
        return -plane.values[1] >= min_cosine;
      });
  return facing_up != planes.end()
             ? static_cast<std::size_t> (facing_up - planes.begin())
             : 0;
}

std::optional<Eigen::Affine3f>
estimateCameraToBase (const std::vector<pcl::ModelCoefficients>& planes)
{
  if (planes.empty())
    return std::nullopt;
  return cameraToBaseFromFloor (Eigen::Map<const Eigen::Vector4f> (
      planes[findLikelyFloor (planes)].values.data()));
}

PlaneHeights
planeHeights (bool is_pose_known)
{
  return is_pose_known ? PlaneHeights{0., 1.2} : PlaneHeights{-2., 2.};
}

} // namespace rgbd_planes
} // namespace pcl
