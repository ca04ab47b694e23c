// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/plane_intersections.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace pcl {
namespace rgbd_planes {

namespace {

/** So many points of either plane, and this share of them, lie on the side that is seen. */
constexpr std::size_t min_points = 4;
constexpr double min_share = 0.8;

bool
agree (std::size_t points, std::size_t others)
{
  return points >= min_points && static_cast<double> (points) >=
                                     min_share * static_cast<double> (points + others);
}

SideCounts&
operator+= (SideCounts& sum, const SideCounts& counts)
{
  sum.nearer += counts.nearer;
  sum.farther += counts.farther;
  return sum;
}

} // namespace

void
PlaneIntersections::clear()
{
  pairs_.clear();
  last_of_.clear();
}

void
PlaneIntersections::add (std::uint32_t own,
                         std::uint32_t other,
                         const SideCounts& points)
{
  const auto [a, b] = std::minmax (own, other);
  std::size_t pair = placeOf (a, b);
  if (pair == none) {
    if (a >= last_of_.size())
      last_of_.resize (a + 1, none);
    pair = pairs_.size();
    pairs_.push_back ({a, b, std::exchange (last_of_[a], pair), {}, {}});
  }
  (own == a ? pairs_[pair].of_a : pairs_[pair].of_b) += points;
}

void
PlaneIntersections::find()
{
  last_of_.assign (last_of_.size(), none);
  std::size_t known = 0;
  for (Pair& pair : pairs_) {
    const auto& [a, b] = std::tie (pair.of_a, pair.of_b);
    if (agree (a.nearer, a.farther) && agree (b.nearer, b.farther))
      pair.seen = SeenPlane::nearer;
    else if (agree (a.farther, a.nearer) && agree (b.farther, b.nearer))
      pair.seen = SeenPlane::farther;
    else
      continue;
    pair.before = std::exchange (last_of_[pair.a], known);
    pairs_[known++] = pair;
  }
  pairs_.resize (known);
}

} // namespace rgbd_planes
} // namespace pcl
