// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/plane_evaluation.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Angles between found planes in scenes that are known to be right-angled, pooled
 * over frames.
 *
 * Planes with at least 2 % of the pixels of the image are looked at, and pairs of them whose
 * angle lies within 20 degrees of 90: others are parallel, or no part of the scene's frame.
 */
class RightAngles {
public:
  enum class Pairs {
    /** Each with each, such as the walls, the floor and the ceiling of a corridor. */
    all,
    /** Each with the floor, the one whose points lie lowest in the image on average: for
     * boards that stand on a floor at any angle to each other. */
    with_floor
  };

  /** \param[in] points an image whose first row is the upper one */
  void
  add (const OrganizedPoints& points, const PlaneSet& found, Pairs pairs);

  /** \brief Frames with at least one pair; the others count nowhere. */
  std::size_t
  frames () const
  {
    return frames_;
  }

  /** \brief Median over all pairs of the difference to 90 degrees; NaN without a pair. */
  double
  medianDegrees () const;

  /** \brief Pairs within 2 degrees of 90, in percent of all; NaN without a pair. */
  double
  pairsWithinPercent () const;

  /** \brief Frames with all their pairs within 2 degrees of 90, in percent of
   * \ref frames; NaN without a pair. */
  double
  framesWithinPercent () const;

private:
  std::vector<double> deviations_;
  std::size_t frames_ = 0;
  std::size_t frames_within_ = 0;
};

} // namespace rgbd_planes
} // namespace pcl
