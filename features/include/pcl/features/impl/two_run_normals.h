// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/organized_view.h>
#include <pcl/features/impl/tangent_normals.h>
#include <pcl/features/rgbd_planes_exports.h>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The settings of computeTwoRunNormals(). */
struct TwoRunNormalParameters {
  /** The radius of the neighbourhood at distance z along the viewing axis. */
  std::function<float (float)> radius = [] (float z) { return 0.01f + 0.01f * z; };
  /** Width and height in pixels of the window that neighbours are taken from; 0: from
   * everywhere. */
  int window_size = 0;
  /** 0: one for each processor. */
  unsigned int threads = 0;
  /** Where the sensor is, in the frame of the points; normals face it. */
  std::array<float, 3> sensor_origin{{0.f, 0.f, 0.f}};
  /** Where the sensor looks, of unit length. */
  std::array<float, 3> viewing_axis{{0.f, 0.f, 1.f}};
};

/** \brief Normals by principal component analysis in two runs (Holz et al. 2011,
 * section 3) over all neighbours within a radius.
 *
 * Writes one normal for each index: of unit length, towards the sensor, with the
 * curvature of fitPlaneInTwoRuns; NaN where the point is missing, the radius is not
 * positive, or fewer than 3 neighbours, or only neighbours on a line, are inside. The
 * result does not depend on the number of threads.
 * \param[in] points a height of 1: unorganized
 * \param[in] indices the points whose normals are wanted
 * \param[in] surface the points that neighbours are taken from, usually \a points again
 * and necessarily so where the window size is set; a height of 1: unorganized
 * \return the number of normals that are not NaN
 */
PCL_RGBD_PLANES_EXPORTS std::size_t
computeTwoRunNormals (const OrganizedPoints& points,
                      const std::vector<int>& indices,
                      const OrganizedPoints& surface,
                      const TwoRunNormalParameters& parameters,
                      const NormalOutput& output);

} // namespace rgbd_planes
} // namespace pcl
