// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/console/print.h>
#include <pcl/filters/camera_pose.h>

namespace pcl {
namespace rgbd_planes {

Eigen::Affine3f
defaultCameraToBase ()
{
  Eigen::Affine3f transform = Eigen::Affine3f::Identity();
  transform.linear() << 0.f, 0.f, 1.f, -1.f, 0.f, 0.f, 0.f, -1.f, 0.f;
  transform.translation().y() = 0.02f;
  return transform;
}

std::optional<Eigen::Affine3f>
cameraToBaseFromFloor (const Eigen::Vector4f& floor)
{
  // The normal points to the side on which the camera is.
  const double scale =
      (floor[3] < 0.f ? -1. : 1.) / floor.head<3>().cast<double>().norm();
  const Eigen::Vector4f plane = (scale * floor.cast<double>()).cast<float>();
  if (!plane.allFinite())
    return std::nullopt;
  const Eigen::Vector3f up = plane.head<3>();
  const float height = plane[3];

  constexpr float min_sine = 0.0175f; // 1 degree
  Eigen::Vector3f forward = Eigen::Vector3f::UnitZ() - up.z() * up;
  if (forward.norm() < min_sine)
    forward = -Eigen::Vector3f::UnitY() + up.y() * up;
  forward.normalize();

  Eigen::Affine3f transform = Eigen::Affine3f::Identity();
  transform.linear().row (0) = forward;
  transform.linear().row (1) = up.cross (forward);
  transform.linear().row (2) = up;
  transform.translation().z() = height;
  return transform;
}

bool
isRigid (const Eigen::Affine3f& transform)
{
  const Eigen::Matrix3f rotation = transform.linear();
  constexpr float tolerance = 1e-3f;
  return transform.matrix().allFinite() &&
         (rotation * rotation.transpose()).isIdentity (tolerance) &&
         rotation.determinant() > 0.f;
}

bool
setTransform (const std::string& setter,
              const Eigen::Affine3f& value,
              Eigen::Affine3f& transform)
{
  if (isRigid (value)) {
    transform = value;
    return true;
  }
  PCL_ERROR ("[pcl::%s] The transform must only turn and shift: give a rotation matrix "
             "and a finite translation. Keeping the one before.\n",
             setter.c_str());
  return false;
}

} // namespace rgbd_planes
} // namespace pcl
