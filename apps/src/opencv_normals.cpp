// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/fit_camera.h>
#include <pcl/apps/normal_methods.h>
#include <pcl/apps/stopwatch.h>

#include <opencv2/core.hpp>
#include <opencv2/rgbd/depth.hpp>

#include <memory>
#include <utility>

namespace pcl {
namespace rgbd_planes {

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;

cv::Mat
toMat (const Cloud& cloud)
{
  cv::Mat points (
      static_cast<int> (cloud.height), static_cast<int> (cloud.width), CV_32FC3);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    points.ptr<cv::Vec3f>()[i] = {cloud[i].x, cloud[i].y, cloud[i].z};
  return points;
}

double
computeNormals (const Cloud& cloud, int method, cv::Mat& result, Normals& normals)
{
  constexpr int window_size = 7;
  cv::Mat points = toMat (cloud);
  // Version 4.6 crashes when this method gets points instead of depth, and takes
  // neighbours apart by more than 50 units for another surface: millimetres.
  if (method == cv::rgbd::RgbdNormals::RGBD_NORMALS_METHOD_LINEMOD) {
    cv::extractChannel (points, points, 2);
    points *= 1000.;
  }
  const Intrinsics fit = fitCamera (cloud);
  // The estimation keeps a reference to it.
  const cv::Mat camera (
      cv::Matx33f (fit.fx, 0.f, fit.cx, 0.f, fit.fy, fit.cy, 0.f, 0.f, 1.f));
  const cv::rgbd::RgbdNormals estimation (
      points.rows, points.cols, CV_32F, camera, window_size, method);
  estimation.initialize();
  cv::setNumThreads (1);

  const Stopwatch watch;
  estimation (points, result);
  const double milliseconds = watch.milliseconds();

  normals.resize (cloud.width, cloud.height);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const cv::Vec3f& n = result.ptr<cv::Vec3f>()[i];
    normals[i].getNormalVector3fMap() = Eigen::Vector3f (n[0], n[1], n[2]);
  }
  return milliseconds;
}

} // namespace

std::vector<NormalMethod>
opencvNormalMethods ()
{
  const std::pair<const char*, int> kinds[] = {
      {"opencv_fals", cv::rgbd::RgbdNormals::RGBD_NORMALS_METHOD_FALS},
      {"opencv_linemod", cv::rgbd::RgbdNormals::RGBD_NORMALS_METHOD_LINEMOD},
      {"opencv_sri", cv::rgbd::RgbdNormals::RGBD_NORMALS_METHOD_SRI}};
  std::vector<NormalMethod> methods;
  for (const auto& [name, kind] : kinds) {
    const auto result = std::make_shared<cv::Mat>();
    methods.push_back (
        {name, [kind = kind, result] (const Cloud::ConstPtr& cloud, Normals& normals) {
           return computeNormals (*cloud, kind, *result, normals);
         }});
  }
  return methods;
}

} // namespace rgbd_planes
} // namespace pcl
