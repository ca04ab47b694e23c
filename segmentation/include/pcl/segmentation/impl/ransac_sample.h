// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/impl/plane_moments.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Points that tell on which plane most of them lie. Each coordinate is in an array of
 * its own, so that loops over them fill vectors. */
class PCL_RGBD_PLANES_EXPORTS RansacSample {
public:
  void
  clear ();

  /** \param[in] tolerance how far the point may be off a plane that it agrees with */
  void
  add (const Eigen::Vector3f& p, float tolerance);

  std::size_t
  size () const
  {
    return x_.size();
  }

  /** \brief (0, 0, 0) without points. */
  Eigen::Vector3f
  mean () const;

  /** \brief The one that most points agree with, of \a plane and some through three points
   * each; always the same for the same points, of which there are 3 or more. */
  Plane
  planeOfMost (const Plane& plane) const;

private:
  Eigen::Vector3f
  operator[] (std::size_t i) const
  {
    return {x_[i], y_[i], z_[i]};
  }

  std::size_t
  countAgreeing (const Plane& plane) const;

  std::vector<float> x_, y_, z_, tolerance_;
};

} // namespace rgbd_planes
} // namespace pcl
