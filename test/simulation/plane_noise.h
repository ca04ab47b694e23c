// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief How a depth camera errs that looks at a plane. */
struct PlaneNoise {
  /** Distances in pixels at which neighbours are compared. */
  static constexpr std::array<int, 4> lags{{1, 2, 4, 8}};

  std::size_t points = 0;
  /** Mean depth. */
  double depth_m = 0.;
  /** The depth changes by this from one disparity to the next. */
  double step_m = 0.;
  /** Root mean square of the deviation in depth from one plane. */
  double global_rms_m = 0.;
  /** The same for planes that fit tiles of 40 x 40 px: without what is warped. */
  double local_rms_m = 0.;
  /** The correlation of these local deviations between neighbours in the same tile. */
  std::array<double, lags.size()> correlation_right{};
  std::array<double, lags.size()> correlation_down{};
  /** 1 / depth = plane[0] u + plane[1] v + plane[2] for the whole plane. */
  std::array<double, 3> plane{};
};

/** \brief Measures the noise of a depth image in metres, NaN where it does not see the
 * plane; it must have at least one tile with 80 % of its pixels on the plane,
 * std::invalid_argument otherwise.
 *
 * One over the depth of a plane is linear in the pixel coordinates, so that planes are
 * fit there. The step is the mean one between all depths that occur.
 */
PlaneNoise
measurePlaneNoise (const std::vector<float>& depth, int width);

} // namespace rgbd_planes
} // namespace pcl
