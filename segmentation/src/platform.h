// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/impl/support_planes.h>

#include <Eigen/Core>

#include <limits>

namespace pcl {
namespace rgbd_planes {

/** Whether a hull is longer and wider than those of tops of things up to a height. */
bool
isLargerThanTops (const ConvexOutline& hull, float max_object_height);

/** Where most of a level surface is, a rectangle: planes also get points of what is as high
 * elsewhere, such as the sides of things nearby, or the foot of a wall. Before compute(), it is
 * everywhere. */
class MainPart {
public:
  void
  compute (const OrganizedPoints& points,
           const pcl::Indices& inliers,
           const SupportSurface& surface);

  bool
  contains (const Eigen::Vector2f& q) const
  {
    return ((axes_ * (q - center_)).array().abs() <= reach_.array()).all();
  }

private:
  Eigen::Vector2f center_ = Eigen::Vector2f::Zero();
  Eigen::Matrix2f axes_ = Eigen::Matrix2f::Identity(); // in rows
  Eigen::Vector2f reach_ =
      Eigen::Vector2f::Constant (std::numeric_limits<float>::infinity());
};

/** Whether hardly any ray goes through \a hull to what is below: the tops of things that are as
 * high as each other have a hull in common, with gaps. What stands on a surface, or before it,
 * makes none. */
bool
isClosed (const OrganizedPoints& points,
          const pcl::Indices& inliers,
          const SupportSurface& surface,
          const ConvexOutline& hull,
          const DepthNoise& noise);

} // namespace rgbd_planes
} // namespace pcl
