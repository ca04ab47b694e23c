// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <functional>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief A way to compute normals, with its buffers. */
struct NormalMethod {
  /** As in the files that pcl_evaluate_normals writes. */
  std::string name;
  /** Computes one normal for every point of an organized cloud in the camera frame.
   * Returns the time it took in milliseconds, on one thread and without conversions.
   */
  std::function<double (const pcl::PointCloud<pcl::PointXYZ>::ConstPtr&,
                        pcl::PointCloud<pcl::Normal>&)>
      compute;
};

/** \brief Radius of neighbourhoods in metres, at depth z in metres. */
using RadiusFunction = std::function<float (float)>;

/** \brief The methods that pcl_evaluate_normals compares: ours, "tangent" first, then
 * those of PCL, and those of OpenCV where it was found at build time. For one size of
 * clouds at a time. */
std::vector<NormalMethod>
normalMethods ();

/** \brief Two-run principal component analysis, "two_run_pca".
 * \param[in] threads 0 for one on each processor
 */
NormalMethod
twoRunMethod (const RadiusFunction& radius, unsigned int threads);

/** \brief OpenCV's RgbdNormals, "opencv_fals", "opencv_linemod" and "opencv_sri", with
 * windows of 7 pixels. */
std::vector<NormalMethod>
opencvNormalMethods ();

} // namespace rgbd_planes
} // namespace pcl
