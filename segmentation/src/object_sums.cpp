// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "link_kernels.h"

#include <pcl/segmentation/impl/object_clusters.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** A point so many standard deviations above a plane is not there by noise. */
constexpr float clear_sigmas = 3.f;
/** Bumps of a plane, by correlated noise or warp, are lower than so many in half of their points
 * at least, */
constexpr float high_sigmas = 6.f;
constexpr double high_of_points = 0.5;
/** and pass into it along so many of their tops. */
constexpr double tops_of_bump = 0.5;
/** Objects have so many clear points, in parts of min_points and of their own points. */
constexpr double clear_of_min_points = 0.6;
constexpr double clear_of_points = 0.25;
/** A cluster that hangs together with the outside in more than a few points, at least two or a
 * part of min_points, and along more than a part of its width, the square root of its points,
 * is cut off from something larger; so is a strip that does so along half of its short side. */
constexpr double few_leaks = 2.;
constexpr double leaks_of_min_points = 0.1;
constexpr double leaks_of_width = 0.1;
constexpr double leaks_across = 0.5;
/** What hangs together with a plane behind it stands out from that and from its support by
 * more than what the warp of a camera makes of planes, in standard deviations of depth. */
constexpr float off_background_sigmas = 5.f;
/** What ends, along a larger part of its tops, at something nearer may go on behind it: a leg
 * of a table, below the edge of its top. What does not end there, however thin, goes on: a pole. */
constexpr double may_go_on = 0.4;
/** Objects have more points, by this factor, than a line of pixels across their extent. */
constexpr double min_width = 1.25;

} // namespace

void
ObjectClusters::sumUp()
{
  findSets();
  const auto forEachRun = [this] (const auto& use) {
    for (std::size_t k = 0; k < set_of_run_.size(); ++k)
      use (runs_.runs()[k], sums_[set_of_run_[k]]);
  };
  // Where pixels share their errors, one lifts many of them.
  const float scatter = std::pow (parameters_.noise.normal_scatter, 0.25f);
  forEachRun ([&] (const PointRun& run, Sums& sums) {
    if (isLarge (sums) && !isClear (sums))
      sums.clear +=
          pointsBeyond (clear_sigmas * scatter, run, supports_->planes()[sums.support]);
  });
  const LinkLimit limit = linkLimit();
  forEachRun ([&] (const PointRun& run, Sums& sums) {
    if (!isLarge (sums) || !isClear (sums))
      return;
    if (!isHigh (sums))
      sums.high +=
          pointsBeyond (high_sigmas * scatter, run, supports_->planes()[sums.support]);
    sums.over_hull += pointsOverHull (run, supports_->planes()[sums.support]);
    const std::ptrdiff_t up = stepUpwards (run.first);
    if (const std::size_t at_border = pointsAtBorder (run)) {
      sums.at_border += at_border;
      sums.cut_tops += pointsAtBorder (run, up);
    }
    lookAtMargin (run, up, limit, sums);
  });
  forEachRun ([this] (const PointRun& run, Sums& sums) {
    if (sums.at_background > 0)
      sums.off_background +=
          pointsOffBackground (run, supports_->planes()[sums.support]);
    if (isCutAbove (sums))
      sums.well_inside += pointsWellInside (run, supports_->planes()[sums.support]);
  });
}

/** Which runs hang together, and how many points these have. */
void
ObjectClusters::findSets()
{
  for (const PointRun& run : runs_.runs()) {
    const auto k = static_cast<std::uint32_t> (set_of_run_.size());
    const std::uint32_t root = runs_.root (k);
    if (root == k) {
      set_of_run_.push_back (static_cast<std::uint32_t> (sums_.size()));
      sums_.emplace_back();
      sums_.back().support = static_cast<std::size_t> (
          bases_[place_[run.first] - std::size_t{above}] - supports_->planes().data());
    }
    else
      set_of_run_.push_back (set_of_run_[root]);
    Sums& sums = sums_[set_of_run_.back()];
    sums.points += run.length;
    const int first = static_cast<int> (run.first);
    const Eigen::Vector2i begin (first % points_.width, first / points_.width);
    sums.pixels.extend (begin);
    sums.pixels.extend (begin + Eigen::Vector2i (static_cast<int> (run.length) - 1, 0));
  }
}

std::size_t
ObjectClusters::pointsBeyond (float sigmas,
                              const PointRun& run,
                              const SupportSurface& support) const
{
  const std::uint32_t v = run.first / width_, u = run.first % width_;
  std::size_t count = 0;
  for (std::uint32_t k = 0; k < run.length; ++k) {
    const float* p = points_[run.first + k];
    const float height = heightAbove (support, v, u + k);
    count += height >= parameters_.min_object_height &&
             !isWithinNoise (p, support.plane, height, sigmas, parameters_.noise);
  }
  return count;
}

std::size_t
ObjectClusters::pointsOffBackground (const PointRun& run,
                                     const SupportSurface& support) const
{
  const std::uint32_t v = run.first / width_, u = run.first % width_;
  std::size_t count = 0;
  for (std::uint32_t k = 0; k < run.length; ++k) {
    const float* p = points_[run.first + k];
    const auto isNear = [&] (const Plane& plane, float height) {
      return isWithinNoise (p, plane, height, off_background_sigmas, parameters_.noise);
    };
    count += !isNear (support.plane, heightAbove (support, v, u + k)) &&
             std::none_of (supports_->background().begin(),
                           supports_->background().end(),
                           [&] (const SegmentedPlane& wall) {
                             return isNear (wall.plane, wall.plane.distance (p));
                           });
  }
  return count;
}

std::size_t
ObjectClusters::pointsOverHull (const PointRun& run,
                                const SupportSurface& support) const
{
  const auto isOver = [&] (std::uint32_t i) {
    return support.outline.contains (support.project (points_[i]));
  };
  const std::uint32_t end = run.first + run.length;
  // Hulls are convex.
  if (isOver (run.first) && isOver (end - 1))
    return run.length;
  std::size_t count = 0;
  for (std::uint32_t i = run.first; i < end; ++i)
    count += isOver (i);
  return count;
}

/** Those further inside of the hull than noise explains of what stands at its border. */
std::size_t
ObjectClusters::pointsWellInside (const PointRun& run,
                                  const SupportSurface& support) const
{
  std::size_t count = 0;
  for (std::uint32_t i = run.first; i < run.first + run.length; ++i)
    count +=
        support.outline.depthOf (support.project (points_[i])) >
        parameters_.hull_tolerance +
            clear_sigmas * parameters_.noise.sigmaAtSquare (squaredRange (points_[i]));
  return count;
}

/** Sides that are seen so flatly that each row or column of their pixels is on its own are
 * not. */
bool
ObjectClusters::isLarge (const Sums& sums) const
{
  return sums.points >= parameters_.min_points &&
         static_cast<double> (sums.points) >=
             min_width * (sums.pixels.sizes().sum() + 1);
}

bool
ObjectClusters::isClear (const Sums& sums) const
{
  const auto clear = static_cast<double> (sums.clear);
  return clear >= clear_of_min_points * parameters_.min_points &&
         clear >= clear_of_points * static_cast<double> (sums.points);
}

bool
ObjectClusters::isHigh (const Sums& sums)
{
  return static_cast<double> (sums.high) >=
         high_of_points * static_cast<double> (sums.points);
}

bool
ObjectClusters::isBump (const Sums& sums)
{
  return !isHigh (sums) && static_cast<double> (sums.passing) >
                               tops_of_bump * static_cast<double> (sums.tops);
}

bool
ObjectClusters::isCutAbove (const Sums& sums)
{
  return sums.cut_tops > sums.tops;
}

bool
ObjectClusters::isObject (const Sums& sums) const
{
  const auto points = static_cast<double> (sums.points);
  const double width = points / (sums.pixels.sizes().maxCoeff() + 1);
  const double max_leaks =
      std::min (std::max (few_leaks, leaks_of_min_points * parameters_.min_points) +
                    leaks_of_width * std::sqrt (points),
                leaks_across * width);
  return isLarge (sums) && isClear (sums) && !isBump (sums) &&
         static_cast<double> (sums.points - sums.over_hull) <=
             (isTruncated (sums.at_border) ? max_leaks
                                           : (1. - over_hull_share) * points) &&
         static_cast<double> (sums.going_on) <=
             may_go_on * static_cast<double> (sums.tops) &&
         static_cast<double> (sums.leaks) <= max_leaks &&
         (!isCutAbove (sums) ||
          static_cast<double> (sums.well_inside) >= over_hull_share * points) &&
         (static_cast<double> (sums.at_background) <= max_leaks ||
          static_cast<double> (sums.off_background) >= clear_of_points * points);
}

} // namespace rgbd_planes
} // namespace pcl
