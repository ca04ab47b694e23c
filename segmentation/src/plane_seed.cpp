// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "each_bit.h"
#include "plane_kernels.h"
#include "surface_turn.h"
#include "tile_bits.h"

#include <pcl/segmentation/impl/plane_growth.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Levels are told up to so many standard deviations apart. */
constexpr int max_level = 64;
/** A level reaches so many of them up and down. */
constexpr std::size_t level_width = 3;
/** Flat parts of bent claims are made of so many strips, and have this share of the points of a
 * plane; one plane fits where the mean square of the errors, in standard deviations, is
 * smaller. */
constexpr std::size_t flat_strips = 16;
constexpr double min_flat_share = 0.2, max_flat_error = 1.2;

/** The numbers of points at each height, in standard deviations. */
class Levels {
public:
  void
  add (float height)
  {
    ++numbers_[binOf (height)];
  }

  /** Finds the highest peak after smoothing. */
  void
  findPeak ()
  {
    std::uint32_t most = 0;
    for (std::size_t i = 1; i + 1 < numbers_.size(); ++i) {
      const std::uint32_t smoothed =
          numbers_[i - 1] + 2 * numbers_[i] + numbers_[i + 1];
      if (smoothed > most) {
        most = smoothed;
        peak_ = i;
      }
    }
  }

  bool
  isAtPeak (float height) const
  {
    const std::size_t bin = binOf (height);
    return bin <= peak_ + level_width && peak_ <= bin + level_width;
  }

private:
  static std::size_t
  binOf (float height)
  {
    constexpr auto limit = static_cast<float> (max_level);
    // In this order, what is not a number becomes a limit.
    const float inside = std::min (std::max (-limit, height), limit);
    return static_cast<std::size_t> (inside + limit + 1.5f);
  }

  std::array<std::uint32_t, 2 * max_level + 3> numbers_{};
  std::size_t peak_ = 1;
};

} // namespace

PlaneMoments
PlaneGrowth::fitSeed (const PlaneSamples& samples,
                      const SampleComponents::Component& seed)
{
  seed_tiles_.clear();
  std::size_t number = 0;
  for (const TilePart* part = seed.first; part != seed.last;) {
    const std::uint32_t tile = part->tile;
    unsigned own = 0;
    for (; part != seed.last && part->tile == tile; ++part)
      own |= part->own;
    const unsigned claimed = claimPart (samples, tile, own, claimed_.data());
    if (claimed == 0)
      continue;
    if (number == 0) {
      const std::size_t first = tile * PlaneSamples::tile_size + lowestBit (claimed);
      reference_ = {samples.x[first], samples.y[first], samples.z[first]};
    }
    seed_tiles_.push_back (tile);
    number += count (claimed);
  }
  return sumSeed (samples, number);
}

/** Sums are relative to the mean of the seed from now on. */
PlaneMoments
PlaneGrowth::sumSeed (const PlaneSamples& samples, std::size_t number)
{
  const PlaneMoments moments = sumOver (samples, seed_tiles_, number);
  if (number > 0)
    reference_ = moments.mean().cast<float>().cast<double>();
  return moments;
}

unsigned
PlaneGrowth::claimsIn (std::uint32_t tile) const
{
  return samplesWhere (&claimed_[tile * PlaneSamples::tile_size],
                       [] (float weight) { return weight > 0.f; });
}

template <typename Visit>
void
PlaneGrowth::forEachClaim (std::uint32_t tile, const Visit& visit) const
{
  forEachBit (claimsIn (tile),
              [&] (std::size_t bit) { visit (tile * PlaneSamples::tile_size + bit); });
}

/** Leaves those of a seed on which most points are of several planes one above the other, as
 * those of a step are, which no single plane fits. */
PlaneMoments
PlaneGrowth::keepLevel (const PlaneSamples& samples, const PlaneMoments& seed)
{
  const auto forEachOfSeed = [this] (const auto& visit) {
    for (const std::uint32_t tile : seed_tiles_)
      forEachClaim (tile, visit);
  };
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  forEachOfSeed ([&] (std::size_t i) {
    normal +=
        Eigen::Vector3f (samples.normal_x[i], samples.normal_y[i], samples.normal_z[i]);
  });
  const float mean = normal.dot (seed.mean().cast<float>());
  const float unit = 1.f / std::abs (mean);
  heights_.resize (samples.size());
  Levels levels;
  forEachOfSeed ([&] (std::size_t i) {
    const float distance =
        normal[0] * samples.x[i] + normal[1] * samples.y[i] + normal[2] * samples.z[i];
    heights_[i] = unit * (distance - mean) / samples.relative_sigma[i];
    levels.add (heights_[i]);
  });
  levels.findPeak();
  std::size_t number = 0;
  forEachOfSeed ([&] (std::size_t i) {
    if (levels.isAtPeak (heights_[i]))
      ++number;
    else
      claimed_[i] = 0.f;
  });
  const auto isEmpty = [this] (std::uint32_t tile) { return claimsIn (tile) == 0; };
  seed_tiles_.erase (std::remove_if (seed_tiles_.begin(), seed_tiles_.end(), isEmpty),
                     seed_tiles_.end());
  return sumSeed (samples, number);
}

/** The plane of the largest part of the claims that one plane fits, between two lines across
 * the direction in which their normals turn; if none does, of the part which it fits best. */
Plane
PlaneGrowth::flatPart (const PlaneSamples& samples) const
{
  const Eigen::Vector3f direction = turn (samples).direction.cast<float>();
  const auto forEachPlace = [&] (const auto& visit) {
    for (const std::uint32_t tile : tiles_)
      forEachClaim (tile, [&] (std::size_t i) {
        visit (i,
               direction[0] * samples.x[i] + direction[1] * samples.y[i] +
                   direction[2] * samples.z[i]);
      });
  };
  float first = std::numeric_limits<float>::infinity(), last = -first;
  forEachPlace ([&] (std::size_t, float place) {
    first = std::min (first, place);
    last = std::max (last, place);
  });
  std::array<PlaneMoments, flat_strips> strips;
  constexpr float min_extent = 1e-6f;
  const float strips_per_place = flat_strips / std::max (last - first, min_extent);
  forEachPlace ([&] (std::size_t i, float place) {
    const float p[] = {samples.x[i], samples.y[i], samples.z[i]};
    const auto strip = static_cast<std::size_t> (strips_per_place * (place - first));
    strips[std::min (strip, flat_strips - 1)].add (p, claimed_[i]);
  });

  Plane best = plane_;
  double least = std::numeric_limits<double>::infinity();
  std::size_t most = 0;
  for (std::size_t begin = 0; begin < flat_strips; ++begin) {
    PlaneMoments part;
    for (std::size_t end = begin; end < flat_strips; ++end) {
      part += strips[end];
      if (static_cast<double> (part.points) <
          std::max (4., min_flat_share * min_points_))
        continue;
      const Eigen::Vector3d m = part.inverseDistance();
      const double error = std::max (part.meanSquaredError (m), max_flat_error);
      if (error < least || (error == least && part.points > most)) {
        least = error;
        most = part.points;
        best = planeOf (m);
      }
    }
  }
  return best;
}

} // namespace rgbd_planes
} // namespace pcl
