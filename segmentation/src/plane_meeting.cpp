// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// What PlaneAssignment does where planes meet.

#include "plane_kernels.h"
#include "tile_bits.h"

#include <pcl/segmentation/plane_assignment.h>

#include <algorithm>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Planes are known by their clear samples alone if these are so many of all. */
constexpr double min_clear_share = 0.3;

} // namespace

void
PlaneAssignment::findIntersections (const PlaneSamples& samples,
                                    const std::vector<Plane>& planes,
                                    const DepthNoise& noise,
                                    float max_sigmas)
{
  for (std::size_t tile = 0; tile < samples.tiles(); ++tile) {
    if (first_candidate_[tile + 1] < first_candidate_[tile] + 2)
      continue;
    const std::size_t begin = tile * PlaneSamples::tile_size;
    const PointBlock points = samplesFrom (samples, begin);
    findTilePlanes (planes, tile);
    const std::uint32_t* labels = &sample_labels_[begin];
    for (const TilePlane& plane : tile_planes_) {
      const auto is_own = [&] (std::uint32_t label) { return label == plane.number; };
      if (samplesWhere (labels, is_own) == 0)
        continue;
      for (const TilePlane& other : tile_planes_) {
        if (plane.number == other.number)
          continue;
        const SideCounts counts =
            countSides (points, labels, plane, other.equation, noise, max_sigmas);
        if (counts.nearer + counts.farther > 0)
          intersections_.add (plane.number, other.number, counts);
      }
    }
  }
  intersections_.find();
}

void
PlaneAssignment::sumClearSamples (const PlaneSamples& samples,
                                  const std::vector<Plane>& planes,
                                  const DepthNoise& noise,
                                  float max_sigmas)
{
  clear_moments_.assign (planes.size(), PlaneMoments{});
  clear_weighted_moments_.assign (planes.size(), PlaneMoments{});
  for (std::size_t tile = 0; tile < samples.tiles(); ++tile) {
    if (first_candidate_[tile] == first_candidate_[tile + 1])
      continue;
    const std::size_t begin = tile * PlaneSamples::tile_size;
    const PointBlock points = samplesFrom (samples, begin);
    findTilePlanes (planes, tile);
    std::copy_n (&sample_labels_[begin], PlaneSamples::tile_size, tile_labels_.begin());
    for (const TilePlane& plane : tile_planes_)
      for (const TilePlane& other : tile_planes_) {
        const SeenPlane seen = intersections_.between (plane.number, other.number);
        if (seen != SeenPlane::unknown)
          dropUnclear (points,
                       plane,
                       other,
                       noise,
                       max_sigmas,
                       seen,
                       unlabelled,
                       tile_labels_.data());
      }
    sumTile (points, samples, tile, noise, clear_moments_, clear_weighted_moments_);
  }
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const auto clear = static_cast<double> (clear_moments_[k].points);
    if (clear < min_clear_share * static_cast<double> (moments_[k].points))
      continue;
    moments_[k] = clear_moments_[k];
    weighted_moments_[k] = clear_weighted_moments_[k];
  }
}

/** Gives points on two planes that meet to the one on their side. */
void
PlaneAssignment::splitTile (const PointBlock& points,
                            const DepthNoise& noise,
                            float max_sigmas)
{
  for (auto a = tile_planes_.begin(); a != tile_planes_.end(); ++a)
    for (auto b = a + 1; b != tile_planes_.end(); ++b) {
      const SeenPlane seen = intersections_.between (a->number, b->number);
      if (seen != SeenPlane::unknown)
        splitPoints (points, *a, *b, noise, max_sigmas, seen, tile_labels_.data());
    }
}

} // namespace rgbd_planes
} // namespace pcl
