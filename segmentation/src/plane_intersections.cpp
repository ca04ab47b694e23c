// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/plane_intersections.h>

#include <algorithm>
#include <tuple>

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
  found_ = false;
}

void
PlaneIntersections::add (std::uint32_t own,
                         std::uint32_t other,
                         const SideCounts& points)
{
  if (own < other)
    pairs_.push_back ({own, other, points, {}, SeenPlane::unknown});
  else
    pairs_.push_back ({other, own, {}, points, SeenPlane::unknown});
}

void
PlaneIntersections::find()
{
  std::sort (pairs_.begin(), pairs_.end(), [] (const Pair& p, const Pair& q) {
    return std::tie (p.a, p.b) < std::tie (q.a, q.b);
  });
  std::size_t number = 0;
  for (const Pair& pair : pairs_) {
    Pair* last = number > 0 ? &pairs_[number - 1] : nullptr;
    if (last && last->a == pair.a && last->b == pair.b) {
      last->of_a += pair.of_a;
      last->of_b += pair.of_b;
    }
    else
      pairs_[number++] = pair;
  }
  pairs_.resize (number);
  for (Pair& pair : pairs_) {
    const auto& [a, b] = std::tie (pair.of_a, pair.of_b);
    if (agree (a.nearer, a.farther) && agree (b.nearer, b.farther))
      pair.seen = SeenPlane::nearer;
    else if (agree (a.farther, a.nearer) && agree (b.farther, b.nearer))
      pair.seen = SeenPlane::farther;
  }
  found_ = true;
}

SeenPlane
PlaneIntersections::between (std::uint32_t a, std::uint32_t b) const
{
  if (!found_)
    return SeenPlane::unknown;
  const auto key = std::minmax (a, b);
  const auto pair = std::lower_bound (
      pairs_.begin(), pairs_.end(), key, [] (const Pair& p, const auto& k) {
        return std::tie (p.a, p.b) < std::tie (k.first, k.second);
      });
  const bool is_known =
      pair != pairs_.end() && pair->a == key.first && pair->b == key.second;
  return is_known ? pair->seen : SeenPlane::unknown;
}

} // namespace rgbd_planes
} // namespace pcl
