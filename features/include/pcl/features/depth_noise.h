// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

namespace pcl {
namespace rgbd_planes {

/** \brief Standard deviation of measured depth, constant + quadratic * range^2, in
 * metres.
 *
 * The defaults are those of a Kinect v1; Khoshelham and Elberink (Accuracy and
 * Resolution of Kinect Depth Data, 2012) explain the square.
 */
struct DepthNoise {
  float constant = 0.001f;
  float quadratic = 0.002f;

  float
  sigma (float squared_range) const
  {
    return constant + quadratic * squared_range;
  }
};

} // namespace rgbd_planes
} // namespace pcl
