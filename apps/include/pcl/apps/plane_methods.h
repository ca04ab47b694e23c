// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/depth_correction.h>
#include <pcl/apps/plane_evaluation.h>
#include <pcl/features/depth_noise.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Planes of a frame and the points on them, those given, or corrected ones, which stay
 * until the method has the next frame. */
struct FoundPlanes : PlaneSet {
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud;
};

/** \brief Finds the planes with at least \a min_inliers points, with buffers of its own. */
using FindPlanes =
    std::function<void (const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud,
                        unsigned min_inliers,
                        SegmentedPlanes& planes)>;

/** \brief PCL's OrganizedMultiPlaneSegmentation on AVERAGE_3D_GRADIENT normals with a smoothing
 * size of 10; other settings as the classes have them.
 * \param[in] tuned planes of up to 6 degrees and 5 cm between neighbours, and a curvature of 0.01,
 * instead of 3 degrees, 2 cm and 0.001: better on simulated frames of a Kinect
 */
FindPlanes
organizedMultiPlanes (bool tuned = false);

/** \brief A way to find planes that is timed, with its buffers. */
struct PlaneMethod {
  /** As in the files that pcl_evaluate_planes writes. */
  std::string name;
  /** Finds the planes with at least \a min_inliers points in an organized cloud in the
   * camera frame. Returns the time in milliseconds, normals included, on one thread and
   * without conversions. */
  std::function<double (const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud,
                        unsigned min_inliers,
                        FoundPlanes& planes)>
      compute;
  /** What learns from all frames of a camera: each of these is to be shown every frame, one
   * after the other, before the first compute. */
  std::vector<DepthCorrection::Calibration> calibration;
};

/** \brief What planeMethods() can leave out: "creases, noise, ..." */
std::string
planeAdditionNames ();

/** \brief Which planeMethods() there are. */
struct PlaneMethodOptions {
  /** Ours once more with cells of spherical coordinates, "spherical_grid". */
  bool spherical_grid = false;
  /** Ours once more with the settings of "pcl_omps", "kept_settings". */
  bool kept_settings = false;
  /** Lists of PlaneAdditions, "NAME,..." or "all": for each, ours once more without these, "no_"
   * and the list. */
  std::vector<std::string> without;
  /** Ours once more on points that DepthWarpCorrection corrected, "corrected". */
  std::optional<CorrectedOption> corrected;
  /** That ours expects of points that are not corrected. */
  DepthNoise noise = DepthNoise::kinectV1();
};

/** \brief Ours as the class has it, "normal_space", organizedMultiPlanes(), "pcl_omps" and
 * "pcl_omps_tuned", and those of \a options. AppError where a name of an addition is none. */
std::vector<PlaneMethod>
planeMethods (const PlaneMethodOptions& options);

} // namespace rgbd_planes
} // namespace pcl
