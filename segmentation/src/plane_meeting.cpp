// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// What PlaneAssignment does where planes meet.

#include "plane_kernels.h"
#include "tile_bits.h"

#include <pcl/segmentation/impl/plane_assignment.h>

#include <algorithm>
#include <utility>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Planes are known by their clear samples alone if these are so many of all. */
constexpr double min_clear_share = 0.3;

} // namespace

void
PlaneAssignment::findIntersections (const PlaneSamples& samples,
                                    const std::vector<Plane>& planes,
                                    const DepthNoise& tolerance)
{
  setEquations (planes);
  for (std::size_t tile = 0; tile < samples.tiles(); ++tile) {
    const TilePlanes around = planesOf (tile);
    if (around.size() < 2)
      continue;
    const std::size_t begin = tile * PlaneSamples::tile_size;
    const PointBlock points = samplesFrom (samples, begin);
    const std::uint32_t* labels = &sample_labels_[begin];
    for (const TilePlane& plane : around) {
      const auto is_own = [&] (std::uint32_t label) { return label == plane.number; };
      if (samplesWhere (labels, is_own) == 0)
        continue;
      for (const TilePlane& other : around) {
        if (plane.number == other.number)
          continue;
        const SideCounts counts = countSides (points,
                                              labels,
                                              plane.number,
                                              equations_[plane.number],
                                              equations_[other.number],
                                              tolerance);
        if (counts.nearer + counts.farther > 0)
          intersections_.add (plane.number, other.number, counts);
      }
    }
  }
  intersections_.find();
}

void
PlaneAssignment::leaveOutUnclearSamples (const PlaneSamples& samples,
                                         const std::vector<Plane>& planes,
                                         const DepthNoise& tolerance)
{
  setEquations (planes);
  unclear_moments_.assign (planes.size(), PlaneMoments{});
  for (std::size_t tile = 0; tile < samples.tiles(); ++tile) {
    const PointBlock points = samplesFrom (samples, tile * PlaneSamples::tile_size);
    if (findUnclear (points, tile, tolerance))
      sumSamples (samples, tile, unclear_moments_);
  }
  for (std::size_t k = 0; k < planes.size(); ++k) {
    PlaneMoments& moments = weighted_moments_[k];
    const std::size_t clear = moments.points - unclear_moments_[k].points;
    if (static_cast<double> (clear) >=
        min_clear_share * static_cast<double> (moments.points))
      moments -= unclear_moments_[k];
  }
}

/** Leaves the labels of the samples of a tile that are near a line of intersection, and no
 * others. */
bool
PlaneAssignment::findUnclear (const PointBlock& points,
                              std::size_t tile,
                              const DepthNoise& tolerance)
{
  const std::uint32_t* own = &sample_labels_[tile * PlaneSamples::tile_size];
  bool is_any = false;
  const TilePlanes around = planesOf (tile);
  for (const TilePlane& plane : around)
    for (const TilePlane& other : around) {
      if (plane.number == other.number)
        continue;
      const SeenPlane seen = intersections_.between (plane.number, other.number);
      if (seen == SeenPlane::unknown)
        continue;
      if (!std::exchange (is_any, true))
        std::copy_n (own, PlaneSamples::tile_size, tile_labels_.begin());
      dropUnclear (points,
                   plane.number,
                   equations_[plane.number],
                   equations_[other.number],
                   tolerance,
                   seen,
                   tile_labels_.data());
    }
  for (std::size_t k = 0; is_any && k < PlaneSamples::tile_size; ++k)
    tile_labels_[k] = tile_labels_[k] == unlabelled ? own[k] : unlabelled;
  return is_any;
}

/** Gives points on two planes that meet to the one on their side. */
void
PlaneAssignment::splitTile (const PointBlock& points,
                            std::size_t tile,
                            const DepthNoise& tolerance)
{
  const TilePlanes around = planesOf (tile);
  for (const TilePlane* a = around.begin(); a != around.end(); ++a)
    for (const TilePlane* b = a + 1; b != around.end(); ++b) {
      const SeenPlane seen = intersections_.between (a->number, b->number);
      if (seen != SeenPlane::unknown)
        splitPoints (points,
                     a->number,
                     b->number,
                     equations_.data(),
                     tolerance,
                     seen,
                     tile_labels_.data());
    }
}

} // namespace rgbd_planes
} // namespace pcl
