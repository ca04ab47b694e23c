// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/organized_view.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Planes of a frame, found or true. Plane k is coefficients[k] (a, b, c, d; unit
 * normal, metres); labels holds for each point its plane or \ref unlabelled. */
struct PlaneSet {
  std::vector<Eigen::Vector4f> coefficients;
  std::vector<std::uint32_t> labels;
};

/** \brief How well found planes match true ones, pooled over frames.
 *
 * Regions are compared as Hoover et al. do (An Experimental Comparison of Range Image
 * Segmentation Algorithms, 1996): with an overlap of 80 %, a true and a found region are a
 * correct pair when their common points are 80 % of each; a true region is over-segmented
 * when it is 80 % covered by several found regions that each lie 80 % inside of it; a found
 * region is under-segmented when it is 80 % covered by several true regions that each lie
 * 80 % inside of it; a true region in none of these is missed, a found one noise.
 */
class PlaneEvaluation {
public:
  /** \brief Adds a frame without truth: coverage and off only. */
  void
  add (const OrganizedPoints& points, const PlaneSet& found);

  /** \brief Adds a frame with truth. Only measured points count. True planes with fewer
   * than \a min_points points are not asked for, and neither are found ones that lie on
   * them for the most part. */
  void
  add (const OrganizedPoints& points,
       const PlaneSet& found,
       const PlaneSet& truth,
       std::size_t min_points);

  bool
  hasTruth () const
  {
    return has_truth_;
  }

  std::size_t planes_truth = 0;
  std::size_t planes_found = 0;
  std::size_t correct = 0; /**< pairs */
  std::size_t over = 0;    /**< true planes that are over-segmented */
  std::size_t under = 0;   /**< found planes that are under-segmented */
  std::size_t missed = 0;  /**< true planes */
  std::size_t noise = 0;   /**< found planes */

  /** \brief F1 score of pairs with an intersection of more than half of their union; NaN where
   * there is neither a true plane nor a found one. */
  double
  f1 () const;

  /** \brief Mean over the true planes of their best intersection over union; NaN where there
   * are none. */
  double
  meanIou () const;

  /** \brief Labelled points in percent of the measured points; NaN where there are none. */
  double
  coveragePercent () const;

  /** \brief Labelled points further from their plane than 5 mm + 4 mm z^2, in percent of
   * the labelled points; NaN where there are none. */
  double
  offPercent () const;

  /** \brief Median over the pairs of \ref f1 of the angle between the normals. */
  double
  medianAngleDegrees () const;

  /** \brief Median over the pairs of \ref f1 of the distance of the found plane from the
   * true one, at the centroid of the points of the true one. */
  double
  medianDistanceMillimetres () const;

private:
  struct Regions;

  void
  addPoints (const OrganizedPoints& points, const PlaneSet& found);

  void
  countRegions (const Regions& regions);

  void
  matchPlanes (const OrganizedPoints& points,
               const PlaneSet& found,
               const PlaneSet& truth,
               const Regions& regions);

  bool has_truth_ = false;
  std::size_t found_with_truth_ = 0;
  std::size_t measured_ = 0;
  std::size_t labelled_ = 0;
  std::size_t off_ = 0;
  std::size_t pairs_ = 0;
  double iou_sum_ = 0.;
  std::vector<double> angles_;
  std::vector<double> distances_;
};

} // namespace rgbd_planes
} // namespace pcl
