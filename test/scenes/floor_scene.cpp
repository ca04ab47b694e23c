// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "floor_scene.h"

#include <limits>
#include <random>

namespace synthetic {

Patch
floorAt (float height)
{
  return {Eigen::Vector3f::UnitZ(), {0.f, 0.f, height}};
}

std::vector<Patch>
box (const Eigen::Vector3f& min, const Eigen::Vector3f& max)
{
  const Eigen::AlignedBox3f extent (min - Eigen::Vector3f::Constant (1e-4f),
                                    max + Eigen::Vector3f::Constant (1e-4f));
  const auto covers = [extent] (const Eigen::Vector3f& p) {
    return extent.contains (p);
  };
  std::vector<Patch> faces;
  for (int axis = 0; axis < 3; ++axis) {
    faces.push_back ({-Eigen::Vector3f::Unit (axis), min, covers});
    faces.push_back ({Eigen::Vector3f::Unit (axis), max, covers});
  }
  return faces;
}

void
addBox (const Eigen::Vector3f& min,
        const Eigen::Vector3f& max,
        std::vector<Patch>& patches)
{
  for (const auto& face : box (min, max))
    patches.push_back (face);
}

FloorScene::FloorScene (const std::vector<Patch>& patches,
                        const Eigen::Affine3f& pose,
                        std::uint32_t width,
                        const std::function<float (float)>& sigma)
: camera_to_base (pose)
, cloud (new pcl::PointCloud<pcl::PointXYZ> (width, width * 3 / 4))
, normals (new pcl::PointCloud<pcl::Normal> (width, width * 3 / 4))
, labels (new pcl::PointCloud<pcl::Label> (width, width * 3 / 4))
{
  for (const auto& patch : patches)
    planes.push_back (planeOf (patch));
  const float focal = 525.f * static_cast<float> (width) / 640.f;
  std::mt19937 generator (1);
  std::normal_distribution<float> gauss;
  for (std::uint32_t v = 0; v < cloud->height; ++v)
    for (std::uint32_t u = 0; u < width; ++u) {
      const Eigen::Vector3f ray (
          (static_cast<float> (u) - 0.5f * static_cast<float> (width - 1)) / focal,
          (static_cast<float> (v) - 0.5f * static_cast<float> (cloud->height - 1)) /
              focal,
          1.f);
      see (patches, ray, v * width + u);
      auto& point = (*cloud) (u, v);
      if (sigma)
        point.getVector3fMap() += ray * sigma (point.z) * gauss (generator);
    }
}

Eigen::Vector3f
FloorScene::inBase (std::size_t i) const
{
  return camera_to_base * (*cloud)[i].getVector3fMap();
}

pcl::ModelCoefficients
FloorScene::planeOf (const Patch& patch) const
{
  const Eigen::Affine3f base_to_camera = camera_to_base.inverse();
  const Eigen::Vector3f normal = base_to_camera.linear() * patch.normal;
  const Eigen::Vector3f point = base_to_camera * patch.point;
  const float d = -normal.dot (point);
  const float sign = d < 0.f ? -1.f : 1.f;
  pcl::ModelCoefficients model;
  model.values = {sign * normal.x(), sign * normal.y(), sign * normal.z(), sign * d};
  return model;
}

void
FloorScene::see (const std::vector<Patch>& patches,
                 const Eigen::Vector3f& ray,
                 std::size_t i)
{
  constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
  const Eigen::Vector3f eye = camera_to_base.translation();
  const Eigen::Vector3f direction = camera_to_base.linear() * ray;
  float depth = 8.f;
  (*labels)[i].label = std::numeric_limits<std::uint32_t>::max();
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const Patch& patch = patches[k];
    const float z = patch.normal.dot (patch.point - eye) / patch.normal.dot (direction);
    if (z > 0.f && z < depth && patch.covers (eye + z * direction)) {
      depth = z;
      (*labels)[i].label = static_cast<std::uint32_t> (k);
    }
  }
  const std::uint32_t seen = (*labels)[i].label;
  if (seen >= patches.size()) {
    (*cloud)[i].getVector3fMap().setConstant (nothing);
    (*normals)[i].getNormalVector3fMap().setConstant (nothing);
    return;
  }
  (*cloud)[i].getVector3fMap() = depth * ray;
  (*normals)[i].getNormalVector3fMap() =
      Eigen::Map<const Eigen::Vector3f> (planes[seen].values.data());
}

} // namespace synthetic
