// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/plane_joining.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl {
namespace rgbd_planes {

namespace {

/** By how much errors may grow when one plane stands for two, as a ratio of their root
 * mean squares; smaller ones than this many standard deviations count as that. */
constexpr double max_growth = 2.2, min_error = 0.8;
/** How far off the plane of the larger part the smaller one may lie in the mean, in
 * standard deviations. */
constexpr double max_offset = 2.;

/** 0 for a perfect match, up to 1 for parts that may join. */
double
mismatch (const PlaneMoments& larger, const PlaneMoments& smaller)
{
  const double offset =
      std::abs (smaller.meanError (larger.inverseDistance())) / max_offset;
  if (!(offset <= 1.))
    return 2.;
  PlaneMoments both = larger;
  both += smaller;
  const Eigen::Vector3d plane = both.inverseDistance();
  const auto growth = [&plane] (const PlaneMoments& part) {
    const double least = min_error * min_error * static_cast<double> (part.points);
    const double own = part.squaredErrors (part.inverseDistance());
    return part.squaredErrors (plane) /
           (std::max (own, least) * max_growth * max_growth);
  };
  const double worst = std::max (growth (larger), growth (smaller));
  return std::isfinite (worst) ? std::max (worst, offset) : 2.;
}

} // namespace

void
PlaneJoining::compute (const std::vector<PlaneMoments>& parts, bool join)
{
  order_.resize (parts.size());
  std::iota (order_.begin(), order_.end(), std::size_t{0});
  std::sort (order_.begin(), order_.end(), [&] (std::size_t a, std::size_t b) {
    return parts[a].points != parts[b].points ? parts[a].points > parts[b].points
                                              : a < b;
  });
  planes_.clear();
  plane_of_part_.resize (parts.size());
  for (const std::size_t part : order_) {
    double least = 1.;
    std::size_t best = planes_.size();
    for (std::size_t k = 0; join && k < planes_.size(); ++k) {
      const double now = mismatch (planes_[k], parts[part]);
      if (now <= least) {
        least = now;
        best = k;
      }
    }
    plane_of_part_[part] = static_cast<std::int32_t> (best);
    if (best == planes_.size())
      planes_.push_back (parts[part]);
    else
      planes_[best] += parts[part];
  }
}

} // namespace rgbd_planes
} // namespace pcl
