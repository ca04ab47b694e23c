// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "synthetic_clouds.h"

#include <pcl/common/angles.h>

#include <cmath>
#include <random>

namespace synthetic {

Surface
tiltedPlane (float depth, float degrees_x, float degrees_y)
{
  const Eigen::Vector3f normal =
      Eigen::AngleAxisf (pcl::deg2rad (degrees_x), Eigen::Vector3f::UnitX()) *
      Eigen::AngleAxisf (pcl::deg2rad (degrees_y), Eigen::Vector3f::UnitY()) *
      Eigen::Vector3f (0.f, 0.f, -1.f);
  return {normal, -normal.z() * depth};
}

Scene
render (const std::vector<Surface>& surfaces,
        int width,
        int height,
        const std::function<float (float)>& sigma)
{
  const float f = 525.f * static_cast<float> (width) / 640.f;
  std::mt19937 generator (1);
  std::normal_distribution<float> gauss;
  Scene scene;
  scene.cloud->resize (width, height);
  scene.surface.assign (scene.cloud->size(), -1);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const Eigen::Vector3f ray ((static_cast<float> (u) - 0.5f * (width - 1)) / f,
                                 (static_cast<float> (v) - 0.5f * (height - 1)) / f,
                                 1.f);
      float depth = 10.f;
      const auto i = static_cast<std::size_t> (v * width + u);
      for (std::size_t k = 0; k < surfaces.size(); ++k) {
        const float z = -surfaces[k].d / surfaces[k].normal.dot (ray);
        if (z > 0.f && z < depth && surfaces[k].covers (u, v)) {
          depth = z;
          scene.surface[i] = static_cast<int> (k);
        }
      }
      const float z =
          scene.surface[i] < 0 ? nan : depth + sigma (depth) * gauss (generator);
      (*scene.cloud)[i].getVector3fMap() = z * ray;
    }
  return scene;
}

float
angleDegrees (const Eigen::Vector3f& a, const Eigen::Vector3f& b)
{
  return pcl::rad2deg (std::atan2 (a.cross (b).norm(), a.dot (b)));
}

Eigen::Affine3f
cameraPose (float height, float pitch, float roll)
{
  Eigen::Matrix3f axes;
  axes << 0.f, 0.f, 1.f, -1.f, 0.f, 0.f, 0.f, -1.f, 0.f;
  Eigen::Affine3f pose (axes);
  pose.rotate (Eigen::AngleAxisf (roll, Eigen::Vector3f::UnitZ()));
  pose.prerotate (Eigen::AngleAxisf (pitch, Eigen::Vector3f::UnitY()));
  return pose.pretranslate (Eigen::Vector3f (0.f, 0.f, height));
}

std::string
dataFolder ()
{
  return PCL_RGBD_PLANES_DATA;
}

} // namespace synthetic
