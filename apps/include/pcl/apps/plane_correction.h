// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/plane_methods.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/simulation/truth_point.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Distances of points from where they should be. */
struct Residuals {
  double squares = 0.;
  std::size_t points = 0;

  /** \brief Their root mean square; NaN where there are no points. */
  double
  rmsMillimetres () const;
};

/** \brief How far the angles between walls are from the true ones, in degrees; infinity where
 * one of the two was not found. */
struct WallAngles {
  std::vector<double> errors;

  /** \brief NaN where there are no walls. */
  double
  medianDegrees () const;

  /** \brief Pairs of walls within 1 degree of the truth, in percent of all. */
  double
  withinPercent () const;
};

/** \brief What pcl::ProjectOntoPlanes gains (Holz et al. 2011, section 5.2), pooled over
 * simulated frames.
 *
 * Far points are all those at a range of 3.5 to 6 m on a true plane, away from edges, on a
 * found plane or not; their residuals are distances from the true plane. Walls are vertical
 * true planes of 2 % of the pixels and more; two that meet at 30 degrees or more are a
 * pair. A wall is found when at least half of its points are on one plane, whose normal is
 * then the wall's. Fits are the planes that least squares, weighted with DepthNoise, gives
 * for the measured points of each true plane away from edges: what would be left if every
 * point were on the right plane.
 */
class PlaneCorrection {
public:
  /** \param[in] cloud as measured; \a found may be planes of corrected points
   * \param[in] truth the true planes; \a pixels the edges
   * \param[in] up a unit vector in the frame of the cloud
   * \param[in] min_points of true planes; smaller ones do not count
   */
  void
  add (const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud,
       const FoundPlanes& found,
       const PlaneSet& truth,
       const pcl::PointCloud<TruthPoint>& pixels,
       const Eigen::Vector3f& up,
       std::size_t min_points);

  Residuals before;         /**< as measured */
  Residuals along_ray;      /**< moved along their viewing rays onto found planes */
  Residuals along_normal;   /**< moved along the normals of found planes */
  Residuals fits_along_ray; /**< moved along their viewing rays onto fits */
  WallAngles walls;
  WallAngles fits_walls;
};

} // namespace rgbd_planes
} // namespace pcl
