// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <cstddef>

namespace pcl {
namespace rgbd_planes {

/** \brief Why candidates did not become planes: how many in the last frame. Candidates have 20 %
 * of the smallest number of inliers, or more. What is left over is tried twice, so that a surface
 * may be two candidates. */
struct PlaneRejections {
  /** The plane had too few points, or points in a line, which determine none. */
  std::size_t too_few_points = 0;
  /** The normals turn with the place, on the candidate or around it, or too many of them
   * differ from that of the plane: a part of a curved or uneven surface. Or the curvature of its
   * points is above that of setMaximumCurvature. */
  std::size_t curved = 0;
  /** Planes that were found before had taken the points. */
  std::size_t claimed_by_larger = 0;
};

/** \brief Run time of each stage, in seconds. */
struct PlaneStageTimes {
  double normal_space = 0.;
  double distance_space = 0.;
  double refinement = 0.;
};

} // namespace rgbd_planes
} // namespace pcl
