// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/PointIndices.h>

#include <Eigen/Core>

#include <cstddef>

namespace pcl {

/** \brief A thing that stands on a horizontal plane; coordinates in the frame of the cloud it
 * was found in, metres. */
struct SupportedObject {
  /** Its points, in ascending order. */
  pcl::PointIndices indices;
  /** The mean of its points. */
  Eigen::Vector3f centroid = Eigen::Vector3f::Zero();
  /** The centre of its box, which rests on the plane; on another thing, if its points show that it
   * does: see SupportedObjectExtraction. */
  Eigen::Vector3f box_center = Eigen::Vector3f::Zero();
  /** Columns are the directions of the sides of the box, right-handed; the last one is the
   * normal of the plane. */
  Eigen::Matrix3f box_axes = Eigen::Matrix3f::Identity();
  /** Sides of the box along \a box_axes; the last one is its height. The outermost 2 % of the
   * points at each end count as flying pixels: without such, sides are up to 5 % too short. */
  Eigen::Vector3f box_size = Eigen::Vector3f::Zero();
  /** The plane it stands on, among those given to extract(). */
  std::size_t support = 0;
  /** It reaches the border of the image: the box may be too small. */
  bool truncated = false;
  /** Its smallest side is in the range of setGraspableSides(), and all of it is in the image. A
   * side along the view that is no longer than what noise makes of a front, 5 standard deviations
   * of depth, does not count: how deep the thing is cannot be seen. */
  bool graspable = false;
};

} // namespace pcl
