// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_kernels.h"
#include "surface_turn.h"
#include "tile_bits.h"

#include <pcl/segmentation/impl/curved_patches.h>

#include <algorithm>
#include <utility>

namespace pcl {
namespace rgbd_planes {

namespace {

/** A surface goes on up to so many times as far from the plane as its points may lie, and
 * where its normals are less than 45 degrees off that of the plane. */
constexpr float reach = 3.f, least_cosine = 0.7071f;
/** Beside a patch it does so on at least this share of the samples... */
constexpr double min_continued = 0.4;
/** ... and turns at least this much, and this much per metre, in radians: less is the error
 * of depth on a far wall... */
constexpr double min_turn = 0.1, min_turn_per_metre = 0.8;
/** ... of which the patch turns this share per metre: what lies between creases does not. */
constexpr double min_own_share = 0.25;
/** Pipes and vaults turn this much per metre, as much on a patch as beside it but for this
 * factor, and this much in all for each metre of range: a wall that the error of depth bends
 * turns less, or turns back beside it. */
constexpr double min_even_turn_per_metre = 0.4, max_uneven = 1.25,
                 min_even_turn_of_range = 0.04;

/** What of a tile hangs together with a plane, as the surface that goes on from it. */
SamplesAtPlane
lookBeside (const PlaneSamples& samples,
            std::size_t tile,
            const Plane& plane,
            const DepthNoise& tolerance)
{
  return samplesAtPlane (samples,
                         tile * PlaneSamples::tile_size,
                         equationOf (plane),
                         tolerance.times (reach),
                         least_cosine);
}

/** Whether normals turn on a patch and on all of its surface as those of pipes do. */
bool
turnsEvenly (const SurfaceTurn& own, const SurfaceTurn& all, double range)
{
  return all.per_metre > min_even_turn_per_metre &&
         all.over_all > min_even_turn_of_range * range &&
         own.per_metre < max_uneven * all.per_metre &&
         all.per_metre < max_uneven * own.per_metre;
}

} // namespace

bool
CurvedPatches::Border::isMostlyContinued() const
{
  return continued > 0 && static_cast<double> (continued) >=
                              min_continued * static_cast<double> (samples);
}

void
CurvedPatches::find (const PlaneSamples& samples,
                     const std::vector<std::int32_t>& owners,
                     const std::vector<TilePart>& parts,
                     const std::vector<Plane>& planes,
                     const DepthNoise& tolerance)
{
  const auto ownersWhere = [&] (const TilePart& part, const auto& isWanted) {
    return samplesWhere (&owners[part.tile * PlaneSamples::tile_size], isWanted);
  };
  const auto goesOn = [&] (const TilePart& part, const SamplesAtPlane& at) {
    return at.along | ownersWhere (part, [] (std::int32_t owner) { return owner < 0; });
  };
  const auto goesOnInPatch = [&] (const TilePart& part, const SamplesAtPlane& at) {
    return at.along & ownersWhere (part, [this] (std::int32_t owner) {
             return owner >= 0 && is_patch_[static_cast<std::size_t> (owner)] != 0;
           });
  };
  countBorders (samples, parts, planes, tolerance, goesOn);
  turn_per_metre_.resize (planes.size());
  is_patch_.resize (planes.size());
  for (std::size_t k = 0; k < planes.size(); ++k)
    is_patch_[k] =
        borders_[k].isMostlyContinued() &&
        turns (samples, parts, static_cast<std::uint32_t> (k), planes[k], tolerance);
  if (std::find (is_patch_.begin(), is_patch_.end(), 1) == is_patch_.end())
    return;
  // What is left between patches is too small to turn much.
  countBorders (samples, parts, planes, tolerance, goesOnInPatch);
  for (std::size_t k = 0; k < planes.size(); ++k)
    if (borders_[k].isMostlyContinued() && turn_per_metre_[k] > min_even_turn_per_metre)
      is_patch_[k] = 1;
}

/** Counts samples beside planes, and those near enough to these for goesOn (part, at). */
template <typename GoesOn>
void
CurvedPatches::countBorders (const PlaneSamples& samples,
                             const std::vector<TilePart>& parts,
                             const std::vector<Plane>& planes,
                             const DepthNoise& tolerance,
                             const GoesOn& goesOn)
{
  borders_.assign (planes.size(), {});
  for (const TilePart& part : parts) {
    const unsigned beside = dilate (part.own) & ~part.own;
    if (beside == 0)
      continue;
    const SamplesAtPlane at =
        lookBeside (samples, part.tile, planes[part.plane], tolerance);
    Border& border = borders_[part.plane];
    border.samples += count (beside);
    border.continued += count (beside & at.near & goesOn (part, at));
  }
}

/** Whether a plane and the surface that goes on beside it turn as a patch does. Notes how much
 * they turn per metre. */
bool
CurvedPatches::turns (const PlaneSamples& samples,
                      const std::vector<TilePart>& parts,
                      std::uint32_t number,
                      const Plane& plane,
                      const DepthNoise& tolerance)
{
  findTiles (samples, parts, number);
  const Eigen::Vector3d reference =
      samples.nearestPoint (tiles_.front()).cast<double>();
  const auto turnWhere = [&] (const auto& samplesOf) {
    for (const std::uint32_t tile : tiles_) {
      const unsigned on = samplesOf (tile);
      const std::size_t begin = tile * PlaneSamples::tile_size;
      for (std::size_t k = 0; k < PlaneSamples::tile_size; ++k)
        weights_[begin + k] = on >> k & 1u ? samples.weight[begin + k] : 0.f;
    }
    double sums[22];
    sumNormals (samples, tiles_, weights_.data(), reference.data(), sums);
    return turnOf (sums, plane.normal);
  };
  const SurfaceTurn all = turnWhere ([&] (std::uint32_t tile) -> unsigned {
    const SamplesAtPlane at = lookBeside (samples, tile, plane, tolerance);
    return own_[tile] | (at.near & at.along);
  });
  turn_per_metre_[number] = all.per_metre;
  if (!(all.over_all > min_turn))
    return false;
  const SurfaceTurn own =
      turnWhere ([&] (std::uint32_t tile) -> unsigned { return own_[tile]; });
  return turnsEvenly (own, all, (reference + all.place).norm()) ||
         (all.per_metre > min_turn_per_metre &&
          own.per_metre > min_own_share * all.per_metre);
}

/** The tiles of a plane, what it has in them, and the tiles around. */
void
CurvedPatches::findTiles (const PlaneSamples& samples,
                          const std::vector<TilePart>& parts,
                          std::uint32_t plane)
{
  weights_.resize (samples.size());
  own_.assign (samples.tiles(), 0);
  is_listed_.assign (samples.tiles(), 0);
  tiles_.clear();
  const auto list = [this] (std::uint32_t tile) {
    if (!std::exchange (is_listed_[tile], std::uint8_t{1}))
      tiles_.push_back (tile);
  };
  for (const TilePart& part : parts)
    if (part.plane == plane) {
      own_[part.tile] = part.own;
      list (part.tile);
      samples.forEachTileAround (part.tile, list);
    }
}

} // namespace rgbd_planes
} // namespace pcl
