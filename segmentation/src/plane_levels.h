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

/** How many of a number of points are of a kind. */
struct Share {
  std::size_t part = 0;
  std::size_t all = 0;

  bool
  isMost () const
  {
    return 2 * part > all;
  }

  bool
  isAtLeast (double share) const
  {
    return static_cast<double> (part) >= share * static_cast<double> (all);
  }
};

/** The points of a decisive sample for which is_part (p) is true. */
template <typename Thing, typename IsPart>
Share
shareOf (const OrganizedPoints& points, const Thing& thing, const IsPart& is_part)
{
  Share share;
  samplePoints (points, thing, decisive_sample, [&] (const auto& p) {
    ++share.all;
    share.part += is_part (p.data());
  });
  return share;
}

} // namespace rgbd_planes
} // namespace pcl
