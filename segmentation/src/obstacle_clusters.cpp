// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "link_kernels.h"

#include <pcl/segmentation/obstacle_clusters.h>

#include <algorithm>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr float max_gap_m = 0.05f;
constexpr float max_gap_sigmas = 3.f;

bool
isAnObstacle (ObstacleClass c)
{
  return c == ObstacleClass::obstacle || c == ObstacleClass::drop_off;
}

LinkLimit
linkLimit (const DepthNoise& noise)
{
  LinkLimit limit;
  limit.constant = max_gap_m;
  limit.sigmas = max_gap_sigmas;
  limit.noise = noise;
  return limit;
}

} // namespace

void
ObstacleLinks::resize (const OrganizedPoints& points)
{
  width_ = static_cast<std::size_t> (points.width);
  // The last block of a row may end in the next one, which is linked later.
  for (auto* links : {&to_left_, &to_above_})
    links->resize (points.size() + PointRow::block_size);
}

void
ObstacleLinks::addRow (int v,
                       const PointRow& row,
                       const PointRow& row_above,
                       const DepthNoise& noise)
{
  const std::size_t first = static_cast<std::size_t> (v) * width_;
  linkRow (
      row, row_above, linkLimit (noise), nullptr, &to_left_[first], &to_above_[first]);
}

void
ObstacleClusters::compute (const OrganizedPoints& points,
                           const ObstacleLinks& links,
                           const DepthNoise& noise,
                           std::size_t min_points,
                           std::vector<ObstacleClass>& classes)
{
  runs_.clear();
  const auto width = static_cast<std::size_t> (points.width);
  const auto isBridged = [&] (std::size_t above, std::size_t below) {
    return classes[above + width] == ObstacleClass::unmeasured &&
           linkLimit (noise).allows (points[below], points[above]);
  };
  const auto isLinked = [&] (std::size_t, std::size_t below) {
    return links.toAbove (below);
  };
  std::size_t before_last = 0, last = 0; // where the rows above begin
  for (std::size_t row = 0; row < points.size(); row += width) {
    const std::size_t now = runs_.size();
    findRuns (points, links, noise, row, classes);
    joinRows ({last, now}, now, width, classes, isLinked);
    joinRows ({before_last, last}, now, 2 * width, classes, isBridged);
    before_last = last;
    last = now;
  }
  numberClusters (min_points, classes);
}

void
ObstacleClusters::findRuns (const OrganizedPoints& points,
                            const ObstacleLinks& links,
                            const DepthNoise& noise,
                            std::size_t row,
                            const std::vector<ObstacleClass>& classes)
{
  const std::size_t end = row + static_cast<std::size_t> (points.width);
  std::size_t i = row;
  while (i < end) {
    if (!isAnObstacle (classes[i])) {
      ++i;
      continue;
    }
    const std::size_t first = i++;
    while (i < end && classes[i] == classes[first] && links.toLeft (i))
      ++i;
    const auto run = static_cast<std::uint32_t> (runs_.size());
    sets_.resize (run + 1);
    sets_.add (run);
    runs_.push_back ({first, i - first, none});
    if (first >= row + 2 && classes[first - 2] == classes[first] &&
        classes[first - 1] == ObstacleClass::unmeasured &&
        linkLimit (noise).allows (points[first], points[first - 2]))
      sets_.join (run - 1, run);
  }
}

/** Joins runs [above.first, above.second) with those of the last row, [below, end), where
 * points are connected that are \a offset apart. */
template <typename AreConnected>
void
ObstacleClusters::joinRows (std::pair<std::size_t, std::size_t> above,
                            std::size_t below,
                            std::size_t offset,
                            const std::vector<ObstacleClass>& classes,
                            const AreConnected& areConnected)
{
  std::size_t a = above.first, b = below;
  while (a < above.second && b < runs_.size()) {
    const std::size_t end_a = runs_[a].first + runs_[a].length;
    const std::size_t first_b = runs_[b].first - offset;
    const std::size_t end_b = first_b + runs_[b].length;
    if (classes[runs_[a].first] == classes[runs_[b].first])
      for (std::size_t i = std::max (runs_[a].first, first_b);
           i < std::min (end_a, end_b);
           ++i)
        if (areConnected (i, i + offset)) {
          sets_.join (static_cast<std::uint32_t> (a), static_cast<std::uint32_t> (b));
          break;
        }
    end_a < end_b ? ++a : ++b;
  }
}

void
ObstacleClusters::numberClusters (std::size_t min_points,
                                  std::vector<ObstacleClass>& classes)
{
  points_.assign (runs_.size(), 0);
  for (std::uint32_t i = 0; i < runs_.size(); ++i)
    points_[sets_.root (i)] += runs_[i].length;
  sizes_.clear();
  for (std::uint32_t i = 0; i < runs_.size(); ++i) {
    // The root of a cluster is its first run.
    const std::uint32_t first = sets_.root (i);
    if (points_[first] < min_points) {
      std::fill_n (classes.begin() + static_cast<std::ptrdiff_t> (runs_[i].first),
                   runs_[i].length,
                   ObstacleClass::speck);
      continue;
    }
    if (first == i) {
      runs_[i].cluster = static_cast<std::uint32_t> (sizes_.size());
      sizes_.push_back (points_[i]);
    }
    else
      runs_[i].cluster = runs_[first].cluster;
  }
}

} // namespace rgbd_planes
} // namespace pcl
