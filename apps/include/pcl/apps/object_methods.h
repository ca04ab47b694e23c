// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/object_evaluation.h>
#include <pcl/features/depth_noise.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief What a method gets to find objects in. */
struct ObjectInput {
  /** Organized, in the camera frame, metres. */
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud;
  /** Where the camera is; without, estimateCameraToBase(). */
  std::optional<Eigen::Affine3f> camera_to_base;
};

/** \brief A way to find objects, with its buffers. */
struct ObjectMethod {
  /** As in files that are written. */
  std::string name;
  /** Finds objects. Returns the time in milliseconds, normals and planes included, on one
   * thread and without conversions. */
  std::function<double (const ObjectInput& input, std::vector<FoundObject>& found)>
      compute;
};

/** \brief Ours, "supported" and, with the split at concave edges, "supported_split".
 * \param[in] noise of the sensor */
std::vector<ObjectMethod>
objectMethods (const DepthNoise& noise = DepthNoise::kinectV1());

/** \brief PCL's SupervoxelClustering (voxels of 7.5 mm, seeds every 3 cm, transform for a single
 * camera) and LCCPSegmentation (10 degrees, sanity check, segments of 3 supervoxels and more) on
 * the points of the cloud, "pcl_lccp". Its largest segment is taken for the table. Boxes are not
 * known, nor whether objects are graspable. */
ObjectMethod
lccpMethod ();

} // namespace rgbd_planes
} // namespace pcl
