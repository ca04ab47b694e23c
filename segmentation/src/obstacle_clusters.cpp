// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "obstacle_kernels.h"
#include "row_bits.h"

#include <pcl/segmentation/impl/obstacle_clusters.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Points that an excluded object is connected with are part of it if they are so many times
 * fewer. */
constexpr std::size_t rim_ratio = 4;

/** \param[in] angle between the rays to the points */
bool
areClose (const float* p, const float* q, const DepthNoise& noise, float angle)
{
  const float way[] = {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
  const float square = squaredRange (p);
  const float gap = std::max (max_gap_m, max_gap_pixels * angle * std::sqrt (square));
  const float limit = gap + max_gap_sigmas * noise.sigmaAtSquare (square);
  return squaredRange (way) <= limit * limit;
}

/** Word \a k of the points of a row that are both thing, or both drop-off, with the point of
 * \a other that is \a aside columns further right. */
std::uint64_t
sameThing (const ClassBits& row, const ClassBits& other, std::size_t k, int aside)
{
  return (row.thing[k] & moved (other.thing, k, aside)) |
         (row.drop_off[k] & moved (other.drop_off, k, aside));
}

} // namespace

void
ObstacleClusters::start (const OrganizedPoints& points,
                         const DepthNoise& noise,
                         const PixelAngles& angles,
                         std::size_t min_points,
                         std::size_t small_points,
                         bool has_excluded)
{
  noise_ = noise;
  angles_ = angles;
  has_excluded_ = has_excluded;
  min_points_ = min_points;
  small_points_ = std::max (min_points, small_points);
  width_ = static_cast<std::size_t> (points.width);
  const std::size_t words = wordsFor (width_);
  candidates_.resize (words);
  linked_.resize (words);
  for (auto& row : rows_) {
    for (auto* bits :
         {&row.classes.unmeasured, &row.classes.drop_off, &row.classes.thing})
      bits->resize (words);
    row.classes.excluded.resize (has_excluded ? words : 0);
  }
  number_of_rows_ = 0;
  runs_.clear();
  points_.clear();
}

void
ObstacleClusters::addRow (const OrganizedPoints& points,
                          const ObstacleClass* classes,
                          const RowLinks& links)
{
  const std::size_t v = number_of_rows_++;
  Row &row = rows_[v % 3], &above = rows_[(v + 2) % 3], &before = rows_[(v + 1) % 3];
  findClasses (classes, width_, row.classes);
  row.first = v * width_;
  findRuns (points, links.to_left, row);
  if (v >= 1) {
    for (std::size_t k = 0; k < linked_.size(); ++k)
      linked_[k] = links.to_above[k] & sameThing (row.classes, above.classes, k, 0);
    joinRows (above, row, linked_, 0, [] (std::size_t) { return true; });
    joinDiagonals (points, above, row);
  }
  if (v >= 2) {
    for (std::size_t k = 0; k < candidates_.size(); ++k)
      candidates_[k] =
          above.classes.unmeasured[k] & sameThing (row.classes, before.classes, k, 0);
    joinRows (before, row, candidates_, 0, [&] (std::size_t u) {
      return areClose (points[row.first + u],
                       points[before.first + u],
                       noise_,
                       2.f * angles_.in_column);
    });
  }
  points_.resize (runs_.size(), 0);
  for (std::size_t k = row.runs; k < row.end_of_runs; ++k)
    points_[sets_.root (static_cast<std::uint32_t> (k))] += runs_[k].length;
}

void
ObstacleClusters::findRuns (const OrganizedPoints& points,
                            const RowBits& to_left,
                            Row& row)
{
  const ClassBits& classes = row.classes;
  const auto any = [&] (std::size_t k) {
    return classes.thing[k] | classes.drop_off[k];
  };
  row.runs = row.end_of_runs = runs_.size();
  std::size_t ends = row.runs; // runs whose length is known
  std::uint64_t last_of_word = 0;
  for (std::size_t k = 0; k < to_left.size(); ++k) {
    const std::uint64_t joined = to_left[k] & sameThing (classes, classes, k, -1);
    const std::uint64_t changes =
        has_excluded_ ? classes.excluded[k] ^ moved (classes.excluded, k, -1) : 0;
    const std::uint64_t continued = joined & ~changes;
    const std::uint64_t starts = any (k) & ~continued;
    const std::uint64_t bridged = starts & sameThing (classes, classes, k, -2) &
                                  moved (classes.unmeasured, k, -1);
    const std::size_t first = row.first + k * bits_in_word;
    forEachBit (starts, [&] (std::size_t bit) {
      const auto run = static_cast<std::uint32_t> (runs_.size());
      sets_.resize (run + 1);
      sets_.add (run);
      runs_.emplace_back();
      runs_.back().first = first + bit;
      if (joined >> bit & 1 || (bridged >> bit & 1 && areClose (points[first + bit],
                                                                points[first + bit - 2],
                                                                noise_,
                                                                2.f * angles_.in_row)))
        sets_.join (run - 1, run);
    });
    forEachBit ((any (k) << 1 | last_of_word) & ~continued, [&] (std::size_t bit) {
      runs_[ends].length = first + bit - runs_[ends].first;
      ++ends;
    });
    last_of_word = any (k) >> (bits_in_word - 1);
  }
  if (ends < runs_.size())
    runs_[ends].length = row.first + width_ - runs_[ends].first;
  row.end_of_runs = runs_.size();
}

template <typename IsConnected>
void
ObstacleClusters::joinRows (const Row& above,
                            const Row& below,
                            const RowBits& candidates,
                            int aside,
                            const IsConnected& isConnected)
{
  std::size_t a = above.runs, b = below.runs;
  // Where points of the row below are beyond the runs at hand.
  const auto endAbove = [&] {
    return runs_[a].first + runs_[a].length - above.first - aside;
  };
  const auto endBelow = [&] { return runs_[b].first + runs_[b].length - below.first; };
  for (std::size_t u = nextBit (candidates, 0); u < width_;) {
    while (endAbove() <= u)
      ++a;
    while (endBelow() <= u)
      ++b;
    const bool is_connected = isConnected (u);
    if (is_connected)
      sets_.join (static_cast<std::uint32_t> (a), static_cast<std::uint32_t> (b));
    u = nextBit (candidates, is_connected ? std::min (endAbove(), endBelow()) : u + 1);
  }
}

void
ObstacleClusters::joinDiagonals (const OrganizedPoints& points,
                                 const Row& above,
                                 const Row& below)
{
  const float angle = std::hypot (angles_.in_row, angles_.in_column);
  for (const int aside : {-1, 1}) {
    for (std::size_t k = 0; k < candidates_.size(); ++k)
      candidates_[k] = sameThing (below.classes, above.classes, k, aside) &
                       ~(linked_[k] | moved (linked_, k, aside));
    joinRows (above, below, candidates_, aside, [&] (std::size_t u) {
      return areClose (
          points[below.first + u], points[above.first + u + aside], noise_, angle);
    });
  }
}

void
ObstacleClusters::finish (std::vector<ObstacleClass>& classes)
{
  const auto isExcluded = [&] (const Run& run) {
    return has_excluded_ && classes[run.first] == ObstacleClass::excluded;
  };
  points_.assign (runs_.size(), 0);
  excluded_points_.assign (has_excluded_ ? runs_.size() : 0, 0);
  for (std::uint32_t i = 0; i < runs_.size(); ++i)
    (isExcluded (runs_[i]) ? excluded_points_ : points_)[sets_.root (i)] +=
        runs_[i].length;
  sizes_.clear();
  for (std::uint32_t i = 0; i < runs_.size(); ++i) {
    // The root of a cluster is its first run.
    const std::uint32_t first = sets_.root (i);
    const bool is_rim =
        has_excluded_ && rim_ratio * points_[first] < excluded_points_[first];
    if (is_rim || points_[first] < min_points_) {
      if (!isExcluded (runs_[i]))
        std::fill_n (classes.begin() + static_cast<std::ptrdiff_t> (runs_[i].first),
                     runs_[i].length,
                     is_rim ? ObstacleClass::excluded : ObstacleClass::speck);
      runs_[i].cluster = none;
      continue;
    }
    if (first == i) {
      runs_[i].cluster = static_cast<std::uint32_t> (sizes_.size());
      sizes_.push_back (points_[i]);
    }
    else
      runs_[i].cluster = runs_[first].cluster;
  }
  if (has_excluded_)
    for (Run& run : runs_)
      if (isExcluded (run))
        run.cluster = none;
}

void
ObstacleClusters::makeFloor (const std::vector<bool>& are_floor,
                             std::vector<ObstacleClass>& classes)
{
  std::uint32_t number = 0;
  numbers_.assign (are_floor.size(), none);
  for (std::size_t k = 0; k < are_floor.size(); ++k)
    if (!are_floor[k]) {
      sizes_[number] = sizes_[k];
      numbers_[k] = number++;
    }
  sizes_.resize (number);
  for (Run& run : runs_) {
    if (run.cluster == none)
      continue;
    if (are_floor[run.cluster])
      std::fill_n (classes.begin() + static_cast<std::ptrdiff_t> (run.first),
                   run.length,
                   ObstacleClass::floor);
    run.cluster = numbers_[run.cluster];
  }
}

} // namespace rgbd_planes
} // namespace pcl
