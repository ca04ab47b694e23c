// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/common/angles.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace synthetic {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/** The plane normal * p = -d, visible where \a covers says so of a pixel. */
struct Surface {
  Eigen::Vector3f normal;
  float d;
  std::function<bool (int, int)> covers = [] (int, int) { return true; };
};

/** A plane through (0, 0, depth) that faces the camera, turned about its x and y axes.
 */
inline Surface
tiltedPlane (float depth, float degrees_x, float degrees_y)
{
  const Eigen::Vector3f normal =
      Eigen::AngleAxisf (pcl::deg2rad (degrees_x), Eigen::Vector3f::UnitX()) *
      Eigen::AngleAxisf (pcl::deg2rad (degrees_y), Eigen::Vector3f::UnitY()) *
      Eigen::Vector3f (0.f, 0.f, -1.f);
  return {normal, -normal.z() * depth};
}

struct Scene {
  Cloud::Ptr cloud = pcl::make_shared<Cloud>();
  /** The surface that each pixel sees, or -1. */
  std::vector<int> surface;
};

/** What a pinhole camera with the field of view of a Kinect sees: the nearest surface
 * of each pixel, up to 10 m; depth has Gaussian noise of sigma (z) metres. */
inline Scene
render (
    const std::vector<Surface>& surfaces,
    int width = 640,
    int height = 480,
    const std::function<float (float)>& sigma = [] (float) { return 0.f; })
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

/** The angle between two directions, in degrees. */
inline float
angleDegrees (const Eigen::Vector3f& a, const Eigen::Vector3f& b)
{
  return pcl::rad2deg (std::atan2 (a.cross (b).norm(), a.dot (b)));
}

/** Every \a step th pixel of every \a step th row. */
template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr
subsample (const pcl::PointCloud<PointT>& cloud, unsigned step)
{
  auto result = pcl::make_shared<pcl::PointCloud<PointT>>();
  result->resize (cloud.width / step, cloud.height / step);
  for (unsigned v = 0; v < result->height; ++v)
    for (unsigned u = 0; u < result->width; ++u)
      (*result) (u, v) = cloud (u * step, v * step);
  return result;
}

/** The folder with recordings, or empty. */
inline std::string
dataFolder ()
{
  return PCL_RGBD_PLANES_DATA;
}

/** A camera \a height above the floor, pitched down and rolled clockwise, radians. */
inline Eigen::Affine3f
cameraPose (float height, float pitch, float roll = 0.f)
{
  Eigen::Matrix3f axes;
  axes << 0.f, 0.f, 1.f, -1.f, 0.f, 0.f, 0.f, -1.f, 0.f;
  Eigen::Affine3f pose (axes);
  pose.rotate (Eigen::AngleAxisf (roll, Eigen::Vector3f::UnitZ()));
  pose.prerotate (Eigen::AngleAxisf (pitch, Eigen::Vector3f::UnitY()));
  return pose.pretranslate (Eigen::Vector3f (0.f, 0.f, height));
}

} // namespace synthetic

#define SKIP_WITHOUT_RECORDINGS()                                                      \
  if (synthetic::dataFolder().empty())                                                 \
  GTEST_SKIP() << "no recordings: set PCL_RGBD_PLANES_DATA to their folder"
