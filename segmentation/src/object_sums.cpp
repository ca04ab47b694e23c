// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "link_kernels.h"

#include <pcl/segmentation/object_clusters.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** A point so many standard deviations above a plane is not there by noise. */
constexpr float clear_sigmas = 3.f;
/** Objects have so many clear points, in parts of min_points and of their own points. */
constexpr double clear_of_min_points = 0.6;
constexpr double clear_of_points = 0.25;
/** A cluster that hangs together with the outside in more than a few points, at least two or a
 * part of min_points, and along more than a part of its width, the square root of its points,
 * is cut off from something larger. */
constexpr double few_leaks = 2.;
constexpr double leaks_of_min_points = 0.1;
constexpr double leaks_of_width = 0.1;
/** What ends, along a larger part of its tops, at something nearer may go on behind it: a leg
 * of a table, below the edge of its top. */
constexpr double may_be_hidden = 0.5;

} // namespace

void
ObjectClusters::sumUp()
{
  const LinkLimit limit = linkLimit();
  for (std::uint32_t k = 0; k < runs_.size(); ++k) {
    Run& run = runs_[k];
    const std::uint32_t root = sets_.root (k);
    if (root == k) {
      run.set = sums_.size();
      sums_.emplace_back();
      sums_.back().support = static_cast<std::size_t> (
          bases_[place_[run.first] - std::size_t{above}] - supports_->data());
    }
    else
      run.set = runs_[root].set;
    Sums& sums = sums_[run.set];
    sums.points += run.length;
    sums.clear += clearPoints (run, (*supports_)[sums.support]);
    sums.leaks += leaks (run, limit);
    countTops (run, limit, sums);
  }
}

std::size_t
ObjectClusters::clearPoints (const Run& run, const SupportPlane& support) const
{
  const auto width = static_cast<std::uint32_t> (points_.width);
  const std::uint32_t v = run.first / width, u = run.first % width;
  std::size_t count = 0;
  for (std::uint32_t k = 0; k < run.length; ++k) {
    const float* p = points_[run.first + k];
    const float height = heightAbove (support, v, u + k);
    count += height >= parameters_.min_object_height &&
             !isWithinNoise (p, support.plane, height, clear_sigmas, parameters_.noise);
  }
  return count;
}

std::size_t
ObjectClusters::leaks (const Run& run, const LinkLimit& limit) const
{
  const std::uint32_t last = run.first + run.length - 1;
  std::size_t count = 0;
  for (std::uint32_t i = run.first; i <= last; ++i) {
    const auto leaksTo = [&] (std::ptrdiff_t step) {
      const std::uint32_t j = next (i, step);
      return place_[j] == outside && limit.allows (points_[i], points_[j]);
    };
    count += leaksTo (-points_.width) || leaksTo (points_.width) ||
             (i == run.first && leaksTo (-1)) || (i == last && leaksTo (1));
  }
  return count;
}

void
ObjectClusters::countTops (const Run& run, const LinkLimit& limit, Sums& sums) const
{
  const std::ptrdiff_t step = stepUpwards (run.first);
  for (std::uint32_t i = run.first; i < run.first + run.length; ++i) {
    std::uint32_t last = i, k = next (i, step);
    for (; k != last && place_[k] != place_[i] && !isMeasured (points_[k]);
         k = next (k, step))
      last = k;
    if (k == last || place_[k] == place_[i])
      continue;
    const float *top = points_[i], *other = points_[k];
    ++sums.tops;
    sums.hidden_tops +=
        squaredRange (other) < squaredRange (top) && !limit.allows (top, other);
  }
}

/** From pixel \a i to the one beside it whose ray points highest. */
std::ptrdiff_t
ObjectClusters::stepUpwards (std::uint32_t i) const
{
  const float right = riseOfRays (i, 1), down = riseOfRays (i, points_.width);
  const bool along_row = std::fabs (right) > std::fabs (down);
  return (along_row ? 1 : points_.width) * ((along_row ? right : down) > 0.f ? 1 : -1);
}

/** By how much the sine of the elevation of rays grows with \a step; 0 where no pixel beside \a i
 * is measured. */
float
ObjectClusters::riseOfRays (std::uint32_t i, std::ptrdiff_t step) const
{
  const auto elevation = [this] (std::uint32_t k) {
    const Eigen::Map<const Eigen::Vector3f> p (points_[k]);
    return bases_.back()->plane.normal.dot (p) / p.norm();
  };
  for (const int side : {1, -1}) {
    const std::uint32_t k = next (i, side * step);
    if (k != i && isMeasured (points_[k]))
      return static_cast<float> (side) * (elevation (k) - elevation (i));
  }
  return 0.f;
}

/** The pixel itself at the border of the image. */
std::uint32_t
ObjectClusters::next (std::uint32_t i, std::ptrdiff_t step) const
{
  const auto width = static_cast<std::uint32_t> (points_.width);
  const bool has_next = step == points_.width    ? i + width < points_.size()
                        : step == -points_.width ? i >= width
                        : step > 0               ? i % width + 1 < width
                                                 : i % width > 0;
  return has_next ? static_cast<std::uint32_t> (i + step) : i;
}

bool
ObjectClusters::isObject (const Sums& sums) const
{
  const auto points = static_cast<double> (sums.points);
  const auto clear = static_cast<double> (sums.clear);
  return sums.points >= parameters_.min_points &&
         clear >= clear_of_min_points * parameters_.min_points &&
         clear >= clear_of_points * points &&
         static_cast<double> (sums.hidden_tops) <=
             may_be_hidden * static_cast<double> (sums.tops) &&
         static_cast<double> (sums.leaks) <=
             std::max (few_leaks, leaks_of_min_points * parameters_.min_points) +
                 leaks_of_width * std::sqrt (points);
}

} // namespace rgbd_planes
} // namespace pcl
