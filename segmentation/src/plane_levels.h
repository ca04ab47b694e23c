// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "point_sample.h"

#include <pcl/segmentation/impl/support_planes.h>

#include <cstddef>

namespace pcl {
namespace rgbd_planes {

/** Where a point is with respect to a supporting plane. */
enum class Level { elsewhere, on_plane, above };

/** How far a plane reaches. */
enum class Reach { outline, surroundings };

/** Whether \a p lies on a plane, or up to the largest height of an object above it, in
 * both cases where the plane reaches. */
Level
levelOf (const float* p,
         const SupportSurface& support,
         Reach reach,
         const ObjectParameters& parameters);

/** So many points of a thing tell where most of it is. */
constexpr std::size_t decisive_sample = 100;

/** A thing has such a share of its points, at least, where it is said to be. */
constexpr double nearly_all = 0.9;
/** More than half, of up to 500 points. */
constexpr double majority = 0.501;

/** How many of a number of points are of a kind. */
struct Share {
  std::size_t part = 0;
  std::size_t all = 0;

  bool
  isAtLeast (double share) const
  {
    return static_cast<double> (part) >= share * static_cast<double> (all);
  }
};

/** Whether is_part (p) is true of \a share, at least, of a decisive sample of the points of a
 * thing. Looks at no more of these than it takes to tell. */
template <typename Thing, typename IsPart>
bool
isShareAtLeast (double share,
                const OrganizedPoints& points,
                const Thing& thing,
                const IsPart& is_part)
{
  const std::size_t step = stepOfSample (thing, decisive_sample);
  const auto size = static_cast<double> ((pointsOf (thing) + step - 1) / step);
  constexpr double rounding = 1e-9;
  const double enough = share * size + rounding;
  const double too_many = (1. - share) * size + rounding;
  Share found;
  samplePoints (points, thing, decisive_sample, [&] (const auto& p) {
    ++found.all;
    found.part += is_part (p.data());
    return static_cast<double> (found.part) < enough &&
           static_cast<double> (found.all - found.part) < too_many;
  });
  return found.isAtLeast (share);
}

} // namespace rgbd_planes
} // namespace pcl
