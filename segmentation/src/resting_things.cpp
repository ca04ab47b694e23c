// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "link_kernels.h"
#include "plane_levels.h"
#include "point_sample.h"

#include <pcl/segmentation/impl/ground_rectangle.h>
#include <pcl/segmentation/impl/pixel_lines.h>
#include <pcl/segmentation/impl/resting_things.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** What rests on another thing ends at least so many times the least height of objects above the
 * plane, and so many standard deviations of depth. */
constexpr float min_heights = 2.f;
constexpr float min_sigmas = 10.f;
/** So much of its lower end is seen. */
constexpr double min_seen = 0.75;
/** Either such a part of that is in mid-air, higher in parts of its height, by so much, than
 * that of a round thing on the plane would be: seen at a flat angle, surfaces lack depth. */
constexpr double min_in_air = 0.25;
constexpr float above_round = 0.25f;
/** ... or touches other things, over which so many of its points lie. */
constexpr double min_touching = 0.5;
constexpr double min_over = 0.5;
/** What touches something else there, that is no object, is a part of that. */
constexpr double min_on_no_thing = 0.5;
/** What is next to each other differs in range by noise, and by so many widths of a pixel. */
constexpr float sigmas = 3.f;
constexpr float stretch = 1.5f;
/** Stems are no wider in the mean, in metres, and so many times as high as they are wide. */
constexpr float max_stem_width = 0.02f;
constexpr float min_slenderness = 2.f;

} // namespace

void
RestingThings::find (const OrganizedPoints& points,
                     float pixel_angle,
                     const OcclusionSteps& occlusions,
                     const std::vector<SupportSurface>& supports,
                     const ObjectParameters& parameters,
                     const std::vector<std::size_t>& thing_of,
                     std::vector<ObjectCluster>& things,
                     DisjointSets& sets)
{
  points_ = points;
  pixel_angle_ = pixel_angle;
  occlusions_ = &occlusions;
  supports_ = &supports;
  parameters_ = parameters;
  thing_of_ = &thing_of;
  things_ = &things;
  for (std::size_t k = 0; k < things.size(); ++k) {
    const SupportSurface& support = supports[things[k].support];
    const Extent extent = extentOf (things[k], support);
    if (extent.low <= minLow (extent))
      continue;
    const LowerEnd end = lowerEnd (k, support, extent);
    const bool is_in_air =
        Share{end.in_air, end.lines}.isAtLeast (min_in_air) &&
        extent.low > (extent.low_if_round + above_round) * extent.high;
    if (Share{end.farther + end.touching, end.lines}.isAtLeast (min_seen) &&
        (is_in_air || (Share{end.touching, end.lines}.isAtLeast (min_touching) &&
                       liesOverOthers (things[k], support))))
      things[k].bottom = extent.low;
    things[k].is_part = Share{end.on_no_thing, end.lines}.isAtLeast (min_on_no_thing);
    joinStems (k, support, extent, sets);
  }
}

RestingThings::Extent
RestingThings::extentOf (const ObjectCluster& thing, const SupportSurface& support)
{
  heights_.clear();
  Extent extent;
  float squared_range = 0.f, rise = 0.f;
  sampleAtMost (thing.runs, max_points_of_thing, [&] (std::size_t i) {
    heights_.push_back (support.plane.distance (points_[i]));
    squared_range += squaredRange (points_[i]);
    rise += elevationOf (points_[i], support.plane.normal);
    extent.middle += support.project (points_[i]);
  });
  const auto count = static_cast<float> (heights_.size());
  const CoordinateRange heights = trimmedRange (heights_);
  extent.low = heights.low;
  extent.high = heights.high;
  extent.middle /= count;
  extent.sigma = parameters_.noise.sigmaAtSquare (squared_range / count);
  rise = std::min (std::fabs (rise / count), 1.f);
  extent.low_if_round = 0.5f * (1.f - std::sqrt (1.f - rise * rise));
  return extent;
}

float
RestingThings::minLow (const Extent& extent) const
{
  return std::max (min_heights * parameters_.min_object_height,
                   min_sigmas * extent.sigma);
}

bool
RestingThings::isOnSupport (const float* point) const
{
  return std::any_of (supports_->begin(), supports_->end(), [&] (const auto& support) {
    return mayBeOnPlane (
        point, support.plane, support.plane.distance (point), parameters_);
  });
}

RestingThings::LowerEnd
RestingThings::lowerEnd (std::size_t thing,
                         const SupportSurface& support,
                         const Extent& extent)
{
  LowerEnd end;
  touched_.clear();
  behind_.clear();
  for (std::size_t c = 0; c < thing_of_->size(); ++c)
    if ((*thing_of_)[c] == thing)
      occlusions_->forEachLowest (c, [&] (std::uint32_t lowest, std::ptrdiff_t down) {
        lookBelow (lowest, down, thing, support, extent, end);
      });
  return end;
}

void
RestingThings::lookBelow (std::uint32_t lowest,
                          std::ptrdiff_t down,
                          std::size_t thing,
                          const SupportSurface& support,
                          const Extent& extent,
                          LowerEnd& end)
{
  const auto below = nextMeasured (points_, lowest, down);
  const std::uint32_t owner = below ? occlusions_->ownerOf (below->pixel) : 0;
  const std::size_t other = owner == 0 ? things_->size() : (*thing_of_)[owner - 1];
  if (other == thing) // another cluster of the same thing
    return;
  ++end.lines;
  if (!below)
    return;
  const Eigen::Map<const Eigen::Vector3f> from (points_[lowest]),
      to (points_[below->pixel]);
  const float range = from.norm();
  const float rise = std::max (
      LinkLimit::min_rise, std::fabs (elevationOf (from.data(), support.plane.normal)));
  const float pixels = stretch * static_cast<float> (below->steps);
  const float limit = sigmas * extent.sigma + pixels * pixel_angle_ * range / rise;
  // Edges lack depth, and their pixels may be of nothing.
  const auto next = occlusions_->nextCluster (lowest, down, 2 * occlusions_->maxGap());
  if (next && (*thing_of_)[next->cluster] != thing &&
      std::sqrt (squaredRange (points_[next->point])) >= range - limit)
    behind_.push_back (next->point);
  if (to.norm() > range + limit) {
    const Eigen::Vector2f border = support.project (from.data());
    const Eigen::Vector2f behind = support.project (to.data());
    ++end.farther;
    const float under =
        (behind - border).dot ((extent.middle - border).stableNormalized());
    end.in_air += under > pixels * pixel_angle_ * range;
  }
  else if (to.norm() >= range - limit && other == things_->size())
    end.on_no_thing += support.plane.distance (to.data()) > minLow (extent) &&
                       !isOnSupport (to.data());
  else if (to.norm() >= range - limit) {
    ++end.touching;
    if (std::find (touched_.begin(), touched_.end(), other) == touched_.end())
      touched_.push_back (other);
  }
}

bool
RestingThings::liesOverOthers (const ObjectCluster& thing,
                               const SupportSurface& support)
{
  ground_.clear();
  for (const std::size_t other : touched_)
    addToGround ((*things_)[other].runs, support);
  outline_.compute (ground_, 0.f);
  Share over;
  sampleAtMost (thing.runs, max_points_of_thing, [&] (std::size_t i) {
    over.part += outline_.contains (support.project (points_[i]));
    ++over.all;
  });
  return over.isAtLeast (min_over);
}

/** Joins a thing with the thin ones that are seen under it. */
void
RestingThings::joinStems (std::size_t thing,
                          const SupportSurface& support,
                          const Extent& extent,
                          DisjointSets& sets)
{
  if (behind_.empty())
    return;
  ground_.clear();
  addToGround ((*things_)[thing].runs, support);
  outline_.compute (ground_, 0.f);
  const float max_width = std::min (max_stem_width, extent.low / min_slenderness);
  for (const std::uint32_t i : behind_) {
    const std::size_t other = (*thing_of_)[occlusions_->ownerOf (i) - 1];
    const ObjectCluster& stem = (*things_)[other];
    if (stem.support == (*things_)[thing].support &&
        outline_.contains (support.project (points_[i])) &&
        areaOf (stem) <= max_width * extent.low)
      sets.join (static_cast<std::uint32_t> (thing),
                 static_cast<std::uint32_t> (other));
  }
}

/** What is seen of it, in square metres. */
float
RestingThings::areaOf (const ObjectCluster& thing) const
{
  float area = 0.f;
  for (const PointRun& run : thing.runs)
    area += static_cast<float> (run.length) * pixel_angle_ * pixel_angle_ *
            squaredRange (points_[run.first]);
  return area;
}

void
RestingThings::addToGround (const std::vector<PointRun>& runs,
                            const SupportSurface& support)
{
  sampleAtMost (runs, max_points_of_thing, [&] (std::size_t i) {
    ground_.push_back (support.project (points_[i]));
  });
}

} // namespace rgbd_planes
} // namespace pcl
