// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "plane_kernels.h"

#include <pcl/segmentation/point_row.h>

#include <Eigen/Core>

#include <cmath>
#include <cstdint>

namespace pcl {
namespace rgbd_planes {

/** How far apart neighbouring points of one thing may be. */
struct LinkLimit {
  /** Metres. */
  float constant = 0.f;
  /** Metres for each metre of range. */
  float slope = 0.f;
  /** Standard deviations of depth. */
  float sigmas = 0.f;
  DepthNoise noise;

  /** Whether \a q is close to \a p, whose range counts. */
  bool
  allows (const float* p, const float* q) const
  {
    const Eigen::Map<const Eigen::Vector3f> from (p), to (q);
    const float squared_range = from.squaredNorm();
    const float limit = constant + sigmas * noise.sigma (squared_range) +
                        slope * std::sqrt (squared_range);
    return (from - to).squaredNorm() <= limit * limit;
  }
};

/** Whether each point of a row is close to the one before, and to the one above it.
 * \param[in] blocks not 0 for the blocks of the row to look at, others are left alone;
 * null for all
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
