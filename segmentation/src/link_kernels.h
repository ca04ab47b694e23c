// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/segmentation/impl/point_row.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl {
namespace rgbd_planes {

/** How far apart neighbouring points of one thing may be. Points at the same height may be of a
 * level surface, and points above each other of an upright one: there, neighbours are the farther
 * apart, the flatter it is seen. */
struct LinkLimit {
  /** Heights that differ by less, in standard deviations of depth as far as it shows in
   * heights, are the same. */
  static constexpr float same_sigmas = 1.f;
  /** The sine of the flattest angle at which level surfaces are seen, 9 degrees. What is seen
   * beyond the end of one may be as high. */
  static constexpr float min_rise = 0.15f;
  /** The same for upright surfaces, 3 degrees: nothing beyond the end of one is below it. */
  static constexpr float min_run = 0.05f;

  /** Neighbours are allowed so much in any case, metres for each metre of range: about what the
   * rest allows those of a Kinect at least, whose pixels are wide and whose noise is large. */
  static constexpr float min_slope = 0.008f;

  /** Metres for each metre of range. */
  float slope = 0.f;
  /** Standard deviations of depth. */
  float sigmas = 0.f;
  DepthNoise noise;
  /** Metres for each metre of range on a level or upright surface seen at a right angle. */
  float known_slope = 0.f;
  /** A unit vector; zero where no surface is level or upright. */
  Eigen::Vector3f up = Eigen::Vector3f::Zero();

  /** Whether \a q is close to \a p, whose range counts. */
  bool
  allows (const float* p, const float* q) const
  {
    const Eigen::Map<const Eigen::Vector3f> from (p), to (q);
    const Eigen::Vector3f way = from - to;
    const float range = from.norm();
    const float sigma = noise.sigmaAtSquare (range * range);
    const float rise = std::fabs (up.dot (from)) / range;
    const float run = std::sqrt (std::max (0.f, 1.f - rise * rise));
    const float climb = up.dot (way);
    const float level = std::sqrt (std::max (0.f, way.squaredNorm() - climb * climb));
    float stretched = slope;
    if (rise >= min_rise && std::fabs (climb) <= same_sigmas * sigma * rise)
      stretched = std::max (stretched, known_slope / rise);
    if (run >= min_run && level <= same_sigmas * sigma * run + known_slope * range)
      stretched = std::max (stretched, known_slope / run);
    const float limit =
        std::max (sigmas * sigma + stretched * range, min_slope * range);
    return way.squaredNorm() <= limit * limit;
  }
};

/** Whether each point of a row is close to the one before, and to the one above it.
 * \param[in] blocks not 0 for the blocks of the row to look at, others are left alone
 */
void
linkRow (const PointRow& row,
         const PointRow& row_above,
         const LinkLimit& limit,
         const std::uint8_t* blocks,
         std::uint8_t* to_left,
         std::uint8_t* to_above);

} // namespace rgbd_planes
} // namespace pcl
