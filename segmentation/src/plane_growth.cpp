// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_kernels.h"
#include "surface_turn.h"
#include "tile_bits.h"

#include <pcl/segmentation/impl/plane_growth.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr int max_iterations = 4;
/** The claimed points no longer change when their number changes by less. */
constexpr double stable_share = 0.02;
/** Shares of the points of a plane that its seed, its claim on the way, and its last
 * claim need: parts of a plane, to be joined, may be smaller. */
constexpr double min_seed_share = 0.15, min_claim_share = 0.2, min_part_share = 0.4;
/** A tile belongs to a plane with so many samples. */
constexpr std::uint8_t min_tile_points = 3;
/** The points of a seed may be on several levels where the mean square of their errors, in
 * standard deviations, is larger. */
constexpr double max_seed_error = 1.;
/** Those of a plane may be on several that meet at small angles where it is larger. They are
 * where those that the plane of one side claims have at most such an error, which is at most
 * this share of what it was, and normals that turn by less. */
constexpr double min_error_if_bent = 1.5, max_error_of_side = 2.5,
                 max_share_of_side = 0.7, max_turn_of_side = 0.05;
/** Normals of a plane turn, from one side to the other, by less than this root mean
 * square, in radians at the sensor and for each metre of range; and by less than this
 * per metre on the surface, where they turn noticeably. */
constexpr double max_turn = 0.15, max_turn_per_metre = 0.012, max_bend = 3.,
                 min_bent_turn = 0.08;

} // namespace

void
PlaneGrowth::reset (const PlaneSamples& samples,
                    double min_points,
                    float max_sigmas,
                    const PlaneAdditions& additions)
{
  additions_ = additions;
  min_points_ = min_points;
  max_sigmas_ = max_sigmas;
  moments_.clear();
  owners_.assign (samples.size(), none);
  claimed_.assign (samples.size(), 0.f);
  const std::size_t tiles = samples.tiles();
  counts_.assign (tiles, 0);
  looks_.assign (tiles, Look::none);
  free_.resize (tiles);
  for (std::size_t tile = 0; tile < tiles; ++tile)
    free_[tile] = static_cast<std::uint8_t> (
        count (samplesWhere (&samples.sigma[tile * PlaneSamples::tile_size],
                             [] (float sigma) { return sigma >= 0.f; })));
}

PlaneGrowth::Result
PlaneGrowth::grow (PlaneSamples& samples, const SampleComponents::Component& seed)
{
  PlaneMoments moments = fitSeed (samples, seed);
  Eigen::Vector3d m = moments.inverseDistance();
  if (additions_.peaks && moments.points > 3 &&
      moments.meanSquaredError (m) > max_seed_error) {
    moments = keepLevel (samples, moments);
    m = moments.inverseDistance();
  }
  if (static_cast<double> (moments.points) <
      std::max (3., min_seed_share * min_points_))
    return Result::claimed_by_larger;
  const Plane plane = planeOf (m);
  if (!claimUntilStable (samples, plane, max_sigmas_))
    return Result::too_few_points;
  bool is_side = false;
  if (isCurved (samples)) {
    // Steps look curved to those who reach too far.
    if (!claimUntilStable (samples, plane, 0.5f * max_sigmas_) || isCurved (samples)) {
      take (samples, curved_surface);
      return Result::curved;
    }
  }
  else if (additions_.bends)
    is_side = unbend (samples, plane);
  if (static_cast<double> (sums_.points) < min_part_share * min_points_)
    return Result::too_few_points;
  take (samples, static_cast<std::int32_t> (moments_.size()));
  moments_.push_back (sums_);
  return is_side ? Result::side_of_bend : Result::plane;
}

/** Leaves the plane, its claims, and their sums. */
void
PlaneGrowth::claimSeed (const PlaneSamples& samples, const Plane& plane)
{
  plane_ = plane;
  tiles_ = seed_tiles_;
  std::size_t number = 0;
  for (const std::uint32_t tile : tiles_) {
    counts_[tile] = static_cast<std::uint8_t> (count (claimsIn (tile)));
    number += counts_[tile];
  }
  sums_ = sumOver (samples, tiles_, number);
}

/** Leaves the plane, its claims, and their sums. */
bool
PlaneGrowth::claimUntilStable (const PlaneSamples& samples,
                               Plane plane,
                               float max_sigmas)
{
  if (!additions_.growth) {
    claimSeed (samples, plane);
    return true;
  }
  const double min_claim = std::max (3., min_claim_share * min_points_);
  double before = 0.;
  for (int i = 0;; ++i) {
    plane_ = plane;
    if (!plane.normal.allFinite() || !std::isfinite (plane.d))
      return false;
    claimConnected (samples, max_sigmas);
    std::size_t number = 0;
    for (const std::uint32_t tile : tiles_)
      number += counts_[tile];
    const auto now = static_cast<double> (number);
    if (now < min_claim)
      return false;
    sums_ = sumOver (samples, tiles_, number);
    if (i == max_iterations ||
        (i > 0 && std::abs (now - before) < stable_share * before))
      return true;
    before = now;
    plane = planeOf (sums_.inverseDistance());
  }
}

/** Claims the samples on the plane in the tiles that hang together with those of its seed,
 * and in the tiles around them. */
void
PlaneGrowth::claimConnected (const PlaneSamples& samples, float max_sigmas)
{
  const PlaneEquation plane = equationOf (plane_);
  connected_.clear();
  tiles_.clear();
  seen_.clear();
  const auto lookAt = [&] (std::uint32_t tile) {
    seen_.push_back (tile);
    counts_[tile] = free_[tile] > 0
                        ? claimTile (samples, tile, plane, max_sigmas, claimed_.data())
                        : 0;
    if (counts_[tile] >= min_tile_points)
      connected_.push_back (tile);
  };
  for (const std::uint32_t tile : seed_tiles_) {
    lookAt (tile);
    looks_[tile] = Look::at_seed;
  }
  for (std::size_t k = 0; k < connected_.size(); ++k)
    samples.forEachTileAround (connected_[k], [&] (std::uint32_t tile) {
      if (looks_[tile] == Look::done)
        return;
      if (std::exchange (looks_[tile], Look::done) == Look::none)
        lookAt (tile);
      if (counts_[tile] > 0)
        tiles_.push_back (tile);
    });
  for (const std::uint32_t tile : seen_)
    looks_[tile] = Look::none;
}

PlaneMoments
PlaneGrowth::sumOver (const PlaneSamples& samples,
                      const std::vector<std::uint32_t>& tiles,
                      std::size_t number) const
{
  double sums[10];
  sumSamples (samples, tiles, claimed_.data(), reference_.data(), sums);
  shiftSums (reference_, sums);
  PlaneMoments moments;
  moments.add (sums, number);
  return moments;
}

/** Where the claims of \a start are on several planes that meet at small angles, grows one of
 * them instead.
 * \return whether they are */
bool
PlaneGrowth::unbend (const PlaneSamples& samples, const Plane& start)
{
  const auto errorNow = [this] {
    return sums_.meanSquaredError (sums_.inverseDistance());
  };
  const double error = errorNow();
  if (static_cast<double> (sums_.points) < min_points_ || !(error > min_error_if_bent))
    return false;
  const double max_error = std::min (max_error_of_side, max_share_of_side * error);
  if (claimUntilStable (samples, flatPart (samples), max_sigmas_) &&
      errorNow() < max_error && turn (samples).over_all < max_turn_of_side)
    return true;
  claimUntilStable (samples, start, max_sigmas_);
  return false;
}

SurfaceTurn
PlaneGrowth::turn (const PlaneSamples& samples) const
{
  double sums[22];
  sumNormals (samples, tiles_, claimed_.data(), reference_.data(), sums);
  return turnOf (sums, plane_.normal);
}

bool
PlaneGrowth::isCurved (const PlaneSamples& samples) const
{
  if (!additions_.curved)
    return false;
  const SurfaceTurn now = turn (samples);
  return now.over_all > max_turn + max_turn_per_metre * reference_.norm() ||
         (now.per_metre > max_bend && now.over_all > min_bent_turn);
}

void
PlaneGrowth::take (PlaneSamples& samples, std::int32_t owner)
{
  for (const std::uint32_t tile : tiles_) {
    takeTile (samples, tile, claimed_.data(), owner, owners_.data());
    free_[tile] = static_cast<std::uint8_t> (free_[tile] - counts_[tile]);
  }
}

} // namespace rgbd_planes
} // namespace pcl
