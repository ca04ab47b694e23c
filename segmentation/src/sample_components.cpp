// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "tile_bits.h"

#include <pcl/segmentation/impl/sample_components.h>

#include <algorithm>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr std::uint32_t nowhere = 0xffffffff;

/** The samples of \a own that hang together with its first one. */
unsigned
firstPiece (unsigned own)
{
  unsigned piece = own & -own, before = 0;
  while (piece != before) {
    before = piece;
    piece = dilate (piece) & own;
  }
  return piece;
}

} // namespace

void
SampleComponents::findPieces (const PlaneSamples& samples, bool connected)
{
  pieces_.clear();
  first_of_tile_.clear();
  for (TilePart part : parts_) {
    first_of_tile_.resize (part.tile + 1, static_cast<std::uint32_t> (pieces_.size()));
    while (part.own != 0) {
      const unsigned piece = connected ? firstPiece (part.own) : part.own;
      pieces_.push_back ({part.plane, part.tile, piece});
      part.own &= ~piece;
    }
  }
  first_of_tile_.resize (samples.tiles() + 1,
                         static_cast<std::uint32_t> (pieces_.size()));
  sets_.start (pieces_.size());
}

/** Joins pieces with those in the tiles to the left and above that they touch. */
void
SampleComponents::joinNeighbours (const PlaneSamples& samples)
{
  const auto columns = static_cast<std::uint32_t> (samples.tiles_u);
  for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
    const TilePart piece = pieces_[k];
    // Tiles from \a first on, and where pieces in these would touch this one.
    const auto joinIn =
        [&] (std::uint32_t first, std::uint32_t tiles, const unsigned* touched) {
          for (std::uint32_t other = first_of_tile_[first];
               other < first_of_tile_[first + tiles];
               ++other)
            if (pieces_[other].plane == piece.plane &&
                (pieces_[other].own & touched[pieces_[other].tile - first]) != 0)
              sets_.join (other, k);
        };
    const TouchedSamples touched = samplesTouchedBy (piece.own);
    const std::uint32_t column = piece.tile % columns;
    const std::uint32_t left = column > 0, right = column + 1 < columns;
    if (left && touched.left)
      joinIn (piece.tile - 1, 1, &touched.left);
    if (piece.tile >= columns)
      joinIn (piece.tile - columns - left, left + 1 + right, touched.above + 1 - left);
  }
}

void
SampleComponents::joinClusters (const PlaneSamples& samples)
{
  first_of_cluster_.assign (samples.size(), nowhere);
  for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
    std::uint32_t& first = first_of_cluster_[pieces_[k].plane];
    if (first == nowhere)
      first = k;
    sets_.join (first, k);
  }
}

void
SampleComponents::compute (const PlaneSamples& samples,
                           const std::vector<std::int32_t>& clusters,
                           std::size_t min_points,
                           bool connected)
{
  findTileParts (clusters, parts_);
  findPieces (samples, connected);
  if (connected)
    joinNeighbours (samples);
  else
    joinClusters (samples);
  listComponents (min_points);
}

void
SampleComponents::listComponents (std::size_t min_points)
{
  samples_.assign (pieces_.size(), 0);
  places_.assign (pieces_.size(), 0);
  roots_.resize (pieces_.size());
  for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
    const std::uint32_t root = roots_[k] = sets_.root (k);
    samples_[root] += static_cast<std::uint32_t> (count (pieces_[k].own));
    ++places_[root];
  }
  members_.resize (pieces_.size());
  components_.clear();
  std::uint32_t end = 0;
  for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
    const std::uint32_t number = places_[k];
    if (number == 0)
      continue;
    places_[k] = samples_[k] >= min_points ? end : nowhere;
    if (samples_[k] >= min_points) {
      components_.push_back ({end, number, samples_[k]});
      end += number;
    }
  }
  for (std::uint32_t k = 0; k < pieces_.size(); ++k)
    if (std::uint32_t& place = places_[roots_[k]]; place != nowhere)
      members_[place++] = pieces_[k];
  std::sort (
      components_.begin(), components_.end(), [] (const Members& a, const Members& b) {
        return a.samples != b.samples ? a.samples > b.samples : a.first < b.first;
      });
}

} // namespace rgbd_planes
} // namespace pcl
