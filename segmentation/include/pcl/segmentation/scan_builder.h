// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/obstacle.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Collects points into a virtual scan (Holz et al. 2011, sections 2 and 5.1). */
class PCL_RGBD_PLANES_EXPORTS ScanBuilder {
public:
  /** \brief Starts anew.
   * \param[in,out] scan the result, which must outlive the additions; its memory is reused
   */
  void
  start (const ScanLimits& limits, VirtualScan& scan);

  /** \brief Adds a point. Fastest where points follow each other in direction.
   * \param[in] point in the base frame, metres
   */
  void
  add (const Eigen::Vector3f& point)
  {
    const float squared = point.x() * point.x() + point.y() * point.y();
    if (!(point.z() <= limits_.max_height && squared >= squared_min_ &&
          squared <= squared_max_ && squared > 0.f))
      return;
    if (!isInside (point, current_))
      find (point);
    if (current_ < squares_.size() && squared < squares_[current_])
      squares_[current_] = squared;
  }

  /** \brief Fills in the ranges. */
  void
  finish ();

private:
  /** Whether a point lies between the borders of a direction. */
  bool
  isInside (const Eigen::Vector3f& p, std::size_t i) const
  {
    return i < squares_.size() && borders_[i].x() * p.y() >= borders_[i].y() * p.x() &&
           borders_[i + 1].x() * p.y() < borders_[i + 1].y() * p.x();
  }

  void
  find (const Eigen::Vector3f& point);

  VirtualScan* scan_ = nullptr;
  ScanLimits limits_;
  float squared_min_ = 0.f;
  float squared_max_ = 0.f;
  /** Direction i is between the unit vectors borders_[i] and borders_[i + 1]. */
  std::vector<Eigen::Vector2f> borders_;
  /** Of the closest point in each direction. */
  std::vector<float> squares_;
  /** The direction of the last point, or squares_.size() where it is outside of all. */
  std::size_t current_ = 0;
};

} // namespace rgbd_planes
} // namespace pcl
