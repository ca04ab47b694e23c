// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_kernels.h"
#include "tile_bits.h"

#include <pcl/segmentation/impl/plane_assignment.h>
#include <pcl/segmentation/impl/plane_growth.h>

#include <algorithm>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Normals at creases may be off by 35 degrees, where their estimator averages over them.
 */
constexpr float max_min_cosine = 0.82f;
/** Trusted normals that are farther off, by 60 degrees, are those of another surface. */
constexpr float other_surface_cosine = 0.5f;

} // namespace

void
PlaneAssignment::findPlanes (const PlaneSamples& samples,
                             const std::vector<std::int32_t>& owners,
                             const std::vector<TilePart>& parts,
                             const std::vector<Plane>& planes)
{
  findPresentPlanes (samples.tiles(), parts);
  setEquations (planes);
  candidates_.clear();
  first_candidate_.clear();
  for (std::size_t tile = 0; tile < samples.tiles(); ++tile) {
    first_candidate_.push_back (candidates_.size());
    findCandidates (samples, owners, tile);
  }
  first_candidate_.push_back (candidates_.size());
}

void
PlaneAssignment::keepOwners (const std::vector<std::int32_t>& owners)
{
  intersections_.clear();
  candidates_.clear();
  first_candidate_.clear();
  is_inner_.assign (owners.size() / PlaneSamples::tile_size, 0);
  for (std::size_t i = 0; i < owners.size(); ++i) {
    const std::size_t sample = i % PlaneSamples::tile_size;
    if (sample == 0)
      first_candidate_.push_back (candidates_.size());
    if (owners[i] < 0)
      continue;
    const auto plane = static_cast<std::uint32_t> (owners[i]);
    auto candidate = std::find_if (
        candidates_.begin() + static_cast<std::ptrdiff_t> (first_candidate_.back()),
        candidates_.end(),
        [plane] (const TilePlane& known) { return known.number == plane; });
    if (candidate == candidates_.end())
      candidate = candidates_.insert (candidate, {plane, 0});
    candidate->compatible |= 1u << sample;
  }
  first_candidate_.push_back (candidates_.size());
}

void
PlaneAssignment::findPresentPlanes (std::size_t tiles,
                                    const std::vector<TilePart>& parts)
{
  present_.clear();
  first_present_.clear();
  is_inner_.assign (tiles, 0);
  for (const TilePart& part : parts) {
    first_present_.resize (part.tile + 1, present_.size());
    const std::size_t number = count (part.own);
    if (number >= min_samples_in_tile)
      present_.push_back (part.plane);
    is_inner_[part.tile] |= number == PlaneSamples::tile_size;
  }
  first_present_.resize (tiles + 1, present_.size());
}

/** The planes of the tile and of the eight around it. */
void
PlaneAssignment::findCandidates (const PlaneSamples& samples,
                                 const std::vector<std::int32_t>& owners,
                                 std::size_t tile)
{
  const std::size_t first = candidates_.size(), begin = tile * PlaneSamples::tile_size;
  const unsigned on_none =
      samplesWhere (&owners[begin], [] (std::int32_t owner) { return owner < 0; });
  samples.forEachRowAround (tile, [&] (std::size_t left, std::size_t end) {
    for (std::size_t k = first_present_[left]; k < first_present_[end]; ++k) {
      const std::uint32_t plane = present_[k];
      const auto is_known = [plane] (const TilePlane& candidate) {
        return candidate.number == plane;
      };
      if (std::any_of (candidates_.begin() + static_cast<std::ptrdiff_t> (first),
                       candidates_.end(),
                       is_known))
        continue;
      const unsigned agree =
          compatibleSamples (samples, begin, equations_[plane], max_min_cosine);
      // A crease may run between a sample and its pixels...
      unsigned compatible = dilate (agree);
      // ... but not to the foot of what stands on a plane and is on none.
      if (on_none != 0)
        compatible &=
            ~on_none |
            compatibleSamples (samples, begin, equations_[plane], other_surface_cosine);
      candidates_.push_back ({plane, compatible});
    }
  });
  if (on_none == 0)
    return;
  const unsigned curved = samplesWhere (&owners[begin], [] (std::int32_t owner) {
    return owner == PlaneGrowth::curved_surface;
  });
  for (std::size_t k = first; k < candidates_.size(); ++k)
    candidates_[k].compatible &= ~curved;
}

} // namespace rgbd_planes
} // namespace pcl
