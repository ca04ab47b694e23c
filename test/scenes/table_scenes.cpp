// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "table_scenes.h"

#include "synthetic_clouds.h"

#include <algorithm>
#include <limits>
#include <random>

namespace table_scenes {

namespace {

Eigen::Vector3f
faceNormal (const Box& box, int face)
{
  const Eigen::Vector3f local =
      Eigen::Vector3f::Unit (face / 2) * (face % 2 ? 1.f : -1.f);
  return Eigen::AngleAxisf (box.yaw, Eigen::Vector3f::UnitZ()) * local;
}

} // namespace

std::pair<float, int>
meet (const Box& box, const Eigen::Vector3f& eye, const Eigen::Vector3f& ray)
{
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf (-box.yaw, Eigen::Vector3f::UnitZ()).toRotationMatrix();
  const Eigen::Vector3f center =
      box.bottom_center + 0.5f * box.size.z() * Eigen::Vector3f::UnitZ();
  const Eigen::Vector3f from = turn * (eye - center), along = turn * ray;
  float enter = 0.f, leave = std::numeric_limits<float>::max();
  int face = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const float a = (-0.5f * box.size[axis] - from[axis]) / along[axis];
    const float b = (0.5f * box.size[axis] - from[axis]) / along[axis];
    if (std::min (a, b) > enter) {
      enter = std::min (a, b);
      face = 2 * axis + (a < b ? 0 : 1);
    }
    leave = std::min (leave, std::max (a, b));
  }
  return {enter, enter < leave ? face : -1};
}

Eigen::Affine3f
Camera::toBase() const
{
  return synthetic::cameraPose (height, pitch_down, roll);
}

std::set<pcl::index_t>
View::pixelsOf (int which) const
{
  std::set<pcl::index_t> pixels;
  for (std::size_t i = 0; i < box.size(); ++i)
    if (box[i] == which)
      pixels.insert (static_cast<pcl::index_t> (i));
  return pixels;
}

View
look (const std::vector<Box>& boxes, const Camera& camera, float noise)
{
  View view;
  view.camera_to_base = camera.toBase();
  view.cloud->resize (camera.width, camera.image_height);
  view.normals->resize (camera.width, camera.image_height);
  view.box.assign (view.cloud->size(), -1);
  const Eigen::Matrix3f to_camera = view.camera_to_base.linear().transpose();
  const float f = 525.f * static_cast<float> (camera.width) / 640.f;
  std::mt19937 generator (1);
  std::normal_distribution<float> gauss;
  std::map<std::pair<int, int>, pcl::Indices> faces;
  for (std::size_t i = 0; i < view.box.size(); ++i) {
    const Eigen::Vector3f ray (
        (static_cast<float> (i % camera.width) - 0.5f * (camera.width - 1)) / f,
        (static_cast<float> (i / camera.width) - 0.5f * (camera.image_height - 1)) / f,
        1.f);
    float depth = std::numeric_limits<float>::max();
    int face = -1;
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      const auto hit = meet (boxes[k],
                             view.camera_to_base.translation(),
                             view.camera_to_base.linear() * ray);
      if (hit.second >= 0 && hit.first < depth) {
        depth = hit.first;
        face = hit.second;
        view.box[i] = static_cast<int> (k);
      }
    }
    if (face < 0)
      depth = std::numeric_limits<float>::quiet_NaN();
    const float sigma = 0.001f + 0.002f * depth * depth;
    (*view.cloud)[i].getVector3fMap() =
        (depth + noise * sigma * gauss (generator)) * ray;
    (*view.normals)[i].getNormalVector3fMap().setConstant (depth);
    if (face >= 0) {
      (*view.normals)[i].getNormalVector3fMap() =
          to_camera * faceNormal (boxes[view.box[i]], face);
      faces[std::make_pair (view.box[i], face)].push_back (
          static_cast<pcl::index_t> (i));
    }
  }
  for (const auto& [key, pixels] : faces) {
    if (pixels.size() < 300)
      continue;
    const auto& [which, face] = key;
    const Eigen::Vector3f normal = faceNormal (boxes[which], face);
    const Eigen::Vector3f on_face =
        boxes[which].bottom_center +
        0.5f * boxes[which].size.z() * Eigen::Vector3f::UnitZ() +
        0.5f * boxes[which].size[face / 2] * normal;
    const Eigen::Vector3f in_camera = to_camera * normal;
    const float d = -normal.dot (on_face - view.camera_to_base.translation());
    if (face == 5)
      view.top[which] = view.models.size();
    view.models.emplace_back();
    view.models.back().values = {in_camera.x(), in_camera.y(), in_camera.z(), d};
    view.inliers.emplace_back();
    view.inliers.back().indices = pixels;
  }
  return view;
}

} // namespace table_scenes
