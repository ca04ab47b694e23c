// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "link_kernels.h"
#include "plane_levels.h"

#include <pcl/segmentation/impl/object_clusters.h>

#include <algorithm>
#include <utility>

namespace pcl {
namespace rgbd_planes {

namespace {

/** So many points above the higher plane tell what stands beside it from its side. */
constexpr double side_share = 0.25;

} // namespace

/** The bases of the points of a thing may be two: it stands beside a higher one, or sticks out
 * over a lower one. */
void
ObjectClusters::joinAcrossBases (const LinkLimit& limit)
{
  meetings_.clear();
  if (bases_.size() > 1)
    findMeetings (limit);
  for (const auto& [run, other] : meetings_) {
    std::uint32_t higher = runs_.root (run), lower = runs_.root (other);
    const auto placeOf = [this] (std::uint32_t root) {
      return place_[runs_.runs()[root].first];
    };
    if (higher == lower)
      continue;
    if (placeOf (higher) > placeOf (lower))
      std::swap (higher, lower);
    runsOf (higher, on_higher_);
    runsOf (lower, on_lower_);
    const SupportSurface &high_base = *bases_[placeOf (higher) - std::size_t{above}],
                         &low_base = *bases_[placeOf (lower) - std::size_t{above}];
    if (standsBeside (on_higher_, on_lower_, high_base, low_base))
      moveTo (on_higher_, placeOf (lower));
    else if (isOver (on_lower_, high_base))
      moveTo (on_lower_, placeOf (higher));
    else
      continue;
    runs_.join (higher, lower);
  }
}

/** Where runs of different bases are close to each other. */
void
ObjectClusters::findMeetings (const LinkLimit& limit)
{
  const auto& runs = runs_.runs();
  for (std::uint32_t k = 0; k < runs.size(); ++k) {
    const PointRun& run = runs[k];
    const auto lookAt = [&] (std::uint32_t i, std::uint32_t j) {
      if (place_[j] <= outside || place_[j] == place_[i] ||
          !limit.allows (points_[i], points_[j]))
        return;
      const auto after = std::upper_bound (
          runs.begin(), runs.end(), j, [] (std::uint32_t at, const PointRun& other) {
            return at < other.first;
          });
      meetings_.emplace_back (
          runs_.root (k),
          runs_.root (static_cast<std::uint32_t> (after - runs.begin()) - 1));
    };
    if (run.first % width_ > 0)
      lookAt (run.first, run.first - 1);
    if (run.first >= width_)
      for (std::uint32_t i = run.first; i < run.first + run.length; ++i)
        lookAt (i, i - width_);
  }
  std::sort (meetings_.begin(), meetings_.end());
  meetings_.erase (std::unique (meetings_.begin(), meetings_.end()), meetings_.end());
}

/** The runs that hang together with \a root. */
void
ObjectClusters::runsOf (std::uint32_t root, std::vector<PointRun>& thing)
{
  thing.clear();
  for (std::uint32_t k = root; k < runs_.runs().size(); ++k)
    if (runs_.root (k) == root)
      thing.push_back (runs_.runs()[k]);
}

void
ObjectClusters::moveTo (const std::vector<PointRun>& thing, std::uint8_t place)
{
  for (const PointRun& run : thing)
    std::fill_n (place_.begin() + run.first, run.length, place);
}

/** Whether a thing beside a plane is nowhere lower than that, as what sticks out. */
bool
ObjectClusters::isOver (const std::vector<PointRun>& thing,
                        const SupportSurface& base) const
{
  return isShareAtLeast (nearly_all, points_, thing, [&] (const float* p) {
    const float height = base.plane.distance (p);
    return height > 0.f || mayBeOnPlane (p, base.plane, height, parameters_);
  });
}

/** Whether what is above the higher plane, and what is above the lower one, is a thing that
 * stands on the lower one: over the margin of the higher hull only, but higher than that also
 * beside it, as the side of that is not. */
bool
ObjectClusters::standsBeside (const std::vector<PointRun>& on_higher,
                              const std::vector<PointRun>& on_lower,
                              const SupportSurface& higher,
                              const SupportSurface& lower) const
{
  const auto isInMargin = [&] (const float* p) {
    return higher.outline.depthOf (higher.project (p)) <= 0.f &&
           lower.plane.distance (p) <= parameters_.max_object_height;
  };
  const auto isAbove = [&] (const float* p) { return higher.plane.distance (p) > 0.f; };
  return isShareAtLeast (nearly_all, points_, on_higher, isInMargin) &&
         isShareAtLeast (side_share, points_, on_lower, isAbove);
}

} // namespace rgbd_planes
} // namespace pcl
