// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "spread_sample.h"

#include <pcl/features/organized_view.h>
#include <pcl/segmentation/linked_runs.h>
#include <pcl/types.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** Calls use (index) for some \a count of the inliers, evenly spread. */
template <typename Use>
void
sampleIndices (const pcl::Indices& inliers, std::size_t count, const Use& use)
{
  SpreadSample sample (std::max<std::size_t> (inliers.size() / count, 1));
  for (std::size_t i = sample.next(); i < inliers.size(); i = sample.next())
    use (static_cast<std::size_t> (inliers[i]));
}

/** The same for runs. */
template <typename Use>
void
sampleIndices (const std::vector<PointRun>& runs, std::size_t count, const Use& use)
{
  SpreadSample sample (std::max<std::size_t> (pointsOf (runs) / count, 1));
  std::size_t i = sample.next(), begin = 0;
  for (const PointRun& run : runs) {
    for (; i < begin + run.length; i = sample.next())
      use (run.first + (i - begin));
    begin += run.length;
  }
}

/** Calls use (p) for some \a count of the measured points of a thing, evenly spread. */
template <typename Thing, typename Use>
void
samplePoints (const OrganizedPoints& points,
              const Thing& thing,
              std::size_t count,
              const Use& use)
{
  sampleIndices (thing, count, [&] (std::size_t index) {
    if (isMeasured (points[index]))
      use (Eigen::Map<const Eigen::Vector3f> (points[index]));
  });
}

} // namespace rgbd_planes
} // namespace pcl
