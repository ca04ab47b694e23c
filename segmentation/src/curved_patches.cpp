// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_kernels.h"
#include "surface_turn.h"
#include "tile_bits.h"

#include <pcl/segmentation/curved_patches.h>

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
constexpr double min_own_share = 0.35;

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

} // namespace

void
CurvedPatches::find (const PlaneSamples& samples,
                     const std::vector<std::int32_t>& owners,
                     const std::vector<TilePart>& parts,
                     const std::vector<Plane>& planes,
                     const DepthNoise& tolerance)
{
  borders_.assign (planes.size(), {});
  for (const TilePart& part : parts) {
    const unsigned beside = dilate (part.own) & ~part.own & 0xffffu;
    if (beside == 0)
      continue;
    const unsigned free = samplesWhere (&owners[part.tile * PlaneSamples::tile_size],
                                        [] (std::int32_t owner) { return owner < 0; });
    const SamplesAtPlane at =
        lookBeside (samples, part.tile, planes[part.plane], tolerance);
    Border& border = borders_[part.plane];
    border.samples += count (beside);
    border.continued += count (beside & at.near & (free | at.along));
  }
  is_patch_.resize (planes.size());
  for (std::size_t k = 0; k < planes.size(); ++k)
    is_patch_[k] = goesOnAndTurns (
        samples, parts, static_cast<std::uint32_t> (k), planes[k], tolerance);
}

/** Whether the surface goes on beside the plane, and turns on both together. */
bool
CurvedPatches::goesOnAndTurns (const PlaneSamples& samples,
                               const std::vector<TilePart>& parts,
                               std::uint32_t number,
                               const Plane& plane,
                               const DepthNoise& tolerance)
{
  const Border& border = borders_[number];
  if (static_cast<double> (border.continued) <
      std::max (min_continued * static_cast<double> (border.samples), 1.))
    return false;
  findTiles (samples, parts, number);
  const Eigen::Vector3d reference =
      samples.measuredPoint (tiles_.front()).cast<double>();
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
  if (!(all.over_all > min_turn && all.per_metre > min_turn_per_metre))
    return false;
  const SurfaceTurn own =
      turnWhere ([&] (std::uint32_t tile) -> unsigned { return own_[tile]; });
  return own.per_metre > min_own_share * all.per_metre;
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
