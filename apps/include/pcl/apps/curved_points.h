// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/plane_evaluation.h>
#include <pcl/point_cloud.h>
#include <pcl/simulation/truth_point.h>

#include <cstddef>

namespace pcl {
namespace rgbd_planes {

/** \brief How many points of curved surfaces were taken for points of planes, pooled over
 * simulated frames. Curved are cylinders, spheres and the walls of cups and bowls: what is
 * seen and on no true plane.
 */
class CurvedPoints {
public:
  /** \param[in] truth one for each point */
  void
  add (const OrganizedPoints& points,
       const PlaneSet& found,
       const pcl::PointCloud<TruthPoint>& truth);

  /** \brief Points with the label of a plane, in percent of the measured points of curved
   * surfaces; NaN where there are none. */
  double
  labelledPercent () const;

  /** \brief The part of \ref labelledPercent of planes that have more than half of their
   * points on curved surfaces. The rest is where curved surfaces meet planes, and too close to
   * them for the noise to tell. */
  double
  shatteredPercent () const;

private:
  std::size_t points_ = 0;
  std::size_t labelled_ = 0;
  std::size_t shattered_ = 0;
};

} // namespace rgbd_planes
} // namespace pcl
