// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "spread_sample.h"
#include <hwy/cache_control.h>

#include <pcl/features/impl/organized_view.h>
#include <pcl/segmentation/impl/linked_runs.h>
#include <pcl/types.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** So many points tell where a thing is as well as all. */
constexpr std::size_t max_points_of_thing = 300;
/** The part of them at either end that may be flying pixels. */
constexpr float trimmed_part = 0.02f;

inline std::size_t
pointsOf (const pcl::Indices& indices)
{
  return indices.size();
}

/** Calls use (value). Where that tells whether to go on, returns it, else true. */
template <typename Use, typename Value>
bool
goesOnAfter (const Use& use, const Value& value)
{
  if constexpr (std::is_void_v<decltype (use (value))>) {
    use (value);
    return true;
  }
  else
    return use (value);
}

/** Calls use (index) for one of each \a step inliers, evenly spread, until it returns false. */
template <typename Use>
void
sampleEvery (const pcl::Indices& inliers, std::size_t step, const Use& use)
{
  SpreadSample sample (step);
  for (std::size_t i = sample.next(); i < inliers.size(); i = sample.next())
    if (!goesOnAfter (use, static_cast<std::size_t> (inliers[i])))
      return;
}

/** The same for runs. */
template <typename Use>
void
sampleEvery (const std::vector<PointRun>& runs, std::size_t step, const Use& use)
{
  SpreadSample sample (step);
  std::size_t i = sample.next(), begin = 0;
  for (const PointRun& run : runs) {
    for (; i < begin + run.length; i = sample.next())
      if (!goesOnAfter (use, run.first + (i - begin)))
        return;
    begin += run.length;
  }
}

/** Of each so many points, one is of some \a count of the points of a thing. */
template <typename Thing>
std::size_t
stepOfSample (const Thing& thing, std::size_t count)
{
  return std::max<std::size_t> (pointsOf (thing) / count, 1);
}

/** Calls use (index) for some \a count of the points of a thing, up to twice as many, until it
 * returns false. */
template <typename Thing, typename Use>
void
sampleIndices (const Thing& thing, std::size_t count, const Use& use)
{
  sampleEvery (thing, stepOfSample (thing, count), use);
}

/** The same for \a count of them at most. */
template <typename Thing, typename Use>
void
sampleAtMost (const Thing& thing, std::size_t count, const Use& use)
{
  sampleEvery (thing, (pointsOf (thing) + count - 1) / count, use);
}

/** Calls use (p) for some \a count of the measured points of a thing, evenly spread. */
template <typename Thing, typename Use>
void
samplePoints (const OrganizedPoints& points,
              const Thing& thing,
              std::size_t count,
              const Use& use)
{
  const auto goesOnAfterPoint = [&] (std::size_t index) {
    return !isMeasured (points[index]) ||
           goesOnAfter (use, Eigen::Map<const Eigen::Vector3f> (points[index]));
  };
  // They are so far apart that the cache cannot foresee them: they wait until they are fetched.
  std::array<std::size_t, 16> waiting{};
  std::size_t number = 0;
  bool goes_on = true;
  sampleIndices (thing, count, [&] (std::size_t index) {
    hwy::Prefetch (points[index]);
    const std::size_t next = std::exchange (waiting[number % waiting.size()], index);
    goes_on = number++ < waiting.size() || goesOnAfterPoint (next);
    return goes_on;
  });
  for (std::size_t k = number - std::min (number, waiting.size());
       goes_on && k < number;
       ++k)
    goes_on = goesOnAfterPoint (waiting[k % waiting.size()]);
}

} // namespace rgbd_planes
} // namespace pcl
