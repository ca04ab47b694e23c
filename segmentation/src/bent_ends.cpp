// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "each_bit.h"
#include "plane_levels.h"

#include <pcl/segmentation/impl/bent_ends.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Besides the numbers of parts. */
constexpr std::int32_t none = -1, outside = -2;
/** Planes have so many times the points of their ends. */
constexpr std::size_t min_ratio = 20;
/** Of what is next to an end, such a part of other planes is its plane, and such a part of all;
 * and so much of it is outside. */
constexpr double min_of_planes = 0.9, min_of_all = 0.25, min_outside = 0.2;
/** How far they are off their planes, in standard deviations: in the root mean square of all, and
 * of what is next to the plane. */
constexpr double max_error = 5.3, max_error_beside = 4.3;
/** They are turned by no more than 20 degrees. */
constexpr double min_cosine = 0.94;

constexpr std::array<std::array<int, 2>, 4> directions{
    {{0, -1}, {-1, 0}, {1, 0}, {0, 1}}};

/** The part that is next to the sample in (u, v) in a direction, or \ref none or \ref outside. */
std::int32_t
partBeside (const PlaneSamples& samples,
            const std::vector<std::int32_t>& owners,
            int u,
            int v,
            const std::array<int, 2>& step)
{
  const auto ownerAt = [&] (int steps) {
    const int x = u + steps * step[0], y = v + steps * step[1];
    if (x < 0 || y < 0 || x >= samples.width || y >= samples.height)
      return outside;
    const std::size_t i = samples.at (x, y);
    if (owners[i] >= 0)
      return owners[i];
    return samples.weight[i] > 0.f ? none : outside;
  };
  const std::int32_t beside = ownerAt (1);
  return beside == none ? ownerAt (2)
                        : beside; // samples between planes may be of neither
}

} // namespace

void
BentEnds::find (const PlaneSamples& samples,
                const std::vector<std::int32_t>& owners,
                const std::vector<TilePart>& tile_parts,
                const std::vector<PlaneMoments>& parts)
{
  std::size_t most = 0;
  for (const PlaneMoments& part : parts)
    most = std::max (most, part.points);
  is_small_.resize (parts.size());
  for (std::size_t k = 0; k < parts.size(); ++k)
    is_small_[k] = min_ratio * parts[k].points <= most;
  lookAround (samples, owners, tile_parts, parts);
  planes_.clear();
  plane_of_part_.assign (parts.size(), none);
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (!isEnd (k, parts)) {
      plane_of_part_[k] = static_cast<std::int32_t> (planes_.size());
      planes_.push_back (parts[k]);
    }
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (plane_of_part_[k] == none)
      plane_of_part_[k] = plane_of_part_[static_cast<std::size_t> (around_[k].plane)];
}

/** Which plane most of what is beside a small part is of, and how far that is off it there. */
void
BentEnds::lookAround (const PlaneSamples& samples,
                      const std::vector<std::int32_t>& owners,
                      const std::vector<TilePart>& tile_parts,
                      const std::vector<PlaneMoments>& parts)
{
  around_.assign (parts.size(), Surroundings());
  meetings_.clear();
  for (const TilePart& part : tile_parts)
    if (is_small_[part.plane])
      forEachBit (part.own, [&] (std::size_t bit) {
        lookBeside (samples, owners, part.tile * PlaneSamples::tile_size + bit);
      });
  for (Surroundings& around : around_)
    if (around.plane != none)
      around.inverse_distance =
          parts[static_cast<std::size_t> (around.plane)].inverseDistance();
  for (const auto& [i, beside] : meetings_) {
    Surroundings& around = around_[static_cast<std::size_t> (owners[i])];
    if (beside != around.plane)
      continue;
    const Eigen::Vector3f p (samples.x[i], samples.y[i], samples.z[i]);
    const double error = 1. - around.inverse_distance.dot (p.cast<double>());
    around.squared_errors += error * error * static_cast<double> (samples.weight[i]);
    ++around.of_plane;
  }
}

void
BentEnds::lookBeside (const PlaneSamples& samples,
                      const std::vector<std::int32_t>& owners,
                      std::size_t i)
{
  Surroundings& around = around_[static_cast<std::size_t> (owners[i])];
  const auto [u, v] = samples.placeOf (i);
  for (const auto& step : directions) {
    const std::int32_t beside = partBeside (samples, owners, u, v, step);
    if (beside == owners[i])
      continue;
    ++around.all;
    around.outside += beside == outside;
    if (beside < 0)
      continue;
    ++around.of_planes;
    meetings_.push_back ({i, beside});
    // The vote of a majority (R. S. Boyer, J. S. Moore, MJRTY, 1991).
    if (around.votes == 0)
      around.plane = beside;
    around.votes += beside == around.plane ? 1 : -1;
  }
}

bool
BentEnds::isEnd (std::size_t part, const std::vector<PlaneMoments>& parts) const
{
  const Surroundings& around = around_[part];
  const auto plane = static_cast<std::size_t> (around.plane);
  if (around.of_plane == 0 || is_small_[plane])
    return false;
  const Eigen::Vector3d normal = around.inverse_distance.normalized();
  return min_ratio * parts[part].points <= parts[plane].points &&
         Share{around.of_plane, around.of_planes}.isAtLeast (min_of_planes) &&
         Share{around.of_plane, around.all}.isAtLeast (min_of_all) &&
         Share{around.outside, around.all}.isAtLeast (min_outside) &&
         parts[part].inverseDistance().normalized().dot (normal) >= min_cosine &&
         parts[part].meanSquaredError (around.inverse_distance) <=
             max_error * max_error &&
         around.squared_errors <= max_error_beside * max_error_beside *
                                      static_cast<double> (around.of_plane);
}

} // namespace rgbd_planes
} // namespace pcl
