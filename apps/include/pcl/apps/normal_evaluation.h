// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/point_types.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief How far normals are from reference ones (Holz et al. 2011, section 6), pooled
 * over all points added.
 *
 * The angle is taken between directions: a normal to the wrong side is 180 degrees off.
 */
class NormalDeviations {
public:
  /** \brief A point of the input. Without a reference normal (NaN) it does not count;
   * without a normal (NaN, Inf or zero) it counts for the coverage only. Neither needs
   * unit length.
   * \return whether the point has both */
  bool
  add (const pcl::Normal& reference, const pcl::Normal& normal);

  /** \brief In degrees, over the points with both normals; NaN if there are none. */
  double
  mean () const;

  /** \brief In degrees, to 0.01, over the points with both normals; NaN if there are
   * none. */
  double
  median () const;

  /** \brief The share of deviations of more than 25 degrees in those with both normals,
   * in percent; NaN if there are none. */
  double
  over25Percent () const;

  /** \brief The share of points with both normals in those with a reference normal, in
   * percent; NaN if there are none. */
  double
  coveragePercent () const;

private:
  std::size_t reference_normals_ = 0;
  std::size_t both_normals_ = 0;
  std::size_t over_25_ = 0;
  double sum_ = 0.;
  std::vector<std::size_t> histogram_;
};

} // namespace rgbd_planes
} // namespace pcl
