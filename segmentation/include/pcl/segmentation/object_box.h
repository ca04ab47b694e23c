// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/support_planes.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief A box that rests on a plane. */
struct ObjectBox {
  Eigen::Vector3f center = Eigen::Vector3f::Zero(); /**< in the camera frame */
  /** Columns are the directions of its sides, right-handed; the last one is the normal of
   * the plane. */
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
  Eigen::Vector3f size = Eigen::Vector3f::Zero(); /**< along \ref axes */
};

/** \brief Finds boxes, and keeps its buffers for the next one. */
class PCL_RGBD_PLANES_EXPORTS ObjectBoxFinder {
public:
  /** \brief The box that stands on the plane, is as high as the points, and has the smallest
   * rectangle around them for its ground; a few points, such as flying pixels, may stick out.
   * \param[in] indices measured points, at least one
   */
  ObjectBox
  compute (const OrganizedPoints& points,
           const pcl::Indices& indices,
           const SupportPlane& support);

private:
  std::vector<Eigen::Vector2f> projected_;
  std::vector<float> values_;
  std::vector<Eigen::Vector2f> border_;
  std::vector<Eigen::Vector2f> hull_;
};

} // namespace rgbd_planes
} // namespace pcl
