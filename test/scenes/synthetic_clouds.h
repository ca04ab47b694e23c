// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include <functional>
#include <limits>
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
Surface
tiltedPlane (float depth, float degrees_x, float degrees_y);

struct Scene {
  Cloud::Ptr cloud = pcl::make_shared<Cloud>();
  /** The surface that each pixel sees, or -1. */
  std::vector<int> surface;
};

/** What a pinhole camera with the field of view of a Kinect sees: the nearest surface
 * of each pixel, up to 10 m; depth has Gaussian noise of sigma (z) metres. */
Scene
render (
    const std::vector<Surface>& surfaces,
    int width = 640,
    int height = 480,
    const std::function<float (float)>& sigma = [] (float) { return 0.f; });

/** The angle between two directions, in degrees. */
float
angleDegrees (const Eigen::Vector3f& a, const Eigen::Vector3f& b);

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
std::string
dataFolder ();

/** A camera \a height above the floor, pitched down and rolled clockwise, radians. */
Eigen::Affine3f
cameraPose (float height, float pitch, float roll = 0.f);

} // namespace synthetic

#define SKIP_WITHOUT_RECORDINGS()                                                      \
  if (synthetic::dataFolder().empty())                                                 \
  GTEST_SKIP() << "no recordings: set PCL_RGBD_PLANES_DATA to their folder"
