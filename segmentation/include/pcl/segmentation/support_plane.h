// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/ModelCoefficients.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl {

/** \brief A level plane that things can stand on; coordinates in the frame of the cloud it was
 * found in, metres. */
struct SupportPlane {
  /** Its number among the planes given to extract(). */
  std::size_t index = 0;
  /** a, b, c, d of the model that was fitted anew, a x + b y + c z + d = 0, with a unit normal
   * towards the sensor. */
  pcl::ModelCoefficients coefficients;
  /** Corners of the convex hull of its points, counterclockwise for the sensor; fewer than 3
   * where these lie on a line. */
  std::vector<Eigen::Vector3f> hull;
  /** That of the centre of its points in the base frame. */
  float height = 0.f;
  /** It lies on a thing that stands on another plane, like a lid. */
  bool is_on_object = false;
  /** It lies low above another plane and is too large for the top of a thing: a step, a
   * pallet, the lowest board of a shelf. */
  bool is_platform = false;
};

/** \brief Why planes support nothing: how many of the last frame are not level, or below or above
 * the heights that are looked at. */
struct SupportRejections {
  std::size_t not_level = 0;
  std::size_t too_low = 0;
  std::size_t too_high = 0;
};

} // namespace pcl
