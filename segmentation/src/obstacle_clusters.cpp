// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

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

bool
areConnected (const float* a, const float* b, const DepthNoise& noise)
{
  const float x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  const float squared_range = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
  const float max_gap = max_gap_m + max_gap_sigmas * noise.sigma (squared_range);
  return x * x + y * y + z * z <= max_gap * max_gap;
}

} // namespace

void
ObstacleClusters::compute (const OrganizedPoints& points,
                           const DepthNoise& noise,
                           std::size_t min_points,
                           std::vector<ObstacleClass>& classes)
{
  runs_.clear();
  const auto width = static_cast<std::size_t> (points.width);
  std::size_t before_last = 0, last = 0; // where the rows above begin
  for (std::size_t row = 0; row < points.size(); row += width) {
    const std::size_t now = runs_.size();
    findRuns (points, noise, row, classes);
    joinRows (points, noise, {last, now}, now, 1, classes);
    joinRows (points, noise, {before_last, last}, now, 2, classes);
    before_last = last;
    last = now;
  }
  numberClusters (min_points, classes);
}

void
ObstacleClusters::findRuns (const OrganizedPoints& points,
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
    while (i < end && classes[i] == classes[first] &&
           areConnected (points[i - 1], points[i], noise))
      ++i;
    const auto run = static_cast<std::uint32_t> (runs_.size());
    sets_.resize (run + 1);
    sets_.add (run);
    runs_.push_back ({first, i - first, none});
    if (first >= row + 2 && classes[first - 2] == classes[first] &&
        classes[first - 1] == ObstacleClass::unmeasured &&
        areConnected (points[first - 2], points[first], noise))
      sets_.join (run - 1, run);
  }
}

/** Connects runs [above.first, above.second) with those of the last row, [below, end),
 * which is \a distance further down. */
void
ObstacleClusters::joinRows (const OrganizedPoints& points,
                            const DepthNoise& noise,
                            std::pair<std::size_t, std::size_t> above,
                            std::size_t below,
                            std::size_t distance,
                            const std::vector<ObstacleClass>& classes)
{
  const std::size_t offset = distance * static_cast<std::size_t> (points.width);
  const auto isBridged = [&] (std::size_t i) {
    return distance == 1 || classes[i + offset / 2] == ObstacleClass::unmeasured;
  };
  std::size_t a = above.first, b = below;
  while (a < above.second && b < runs_.size()) {
    const std::size_t end_a = runs_[a].first + runs_[a].length;
    const std::size_t first_b = runs_[b].first - offset;
    const std::size_t end_b = first_b + runs_[b].length;
    if (classes[runs_[a].first] == classes[runs_[b].first])
      for (std::size_t i = std::max (runs_[a].first, first_b);
           i < std::min (end_a, end_b);
           ++i)
        if (isBridged (i) && areConnected (points[i], points[i + offset], noise)) {
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
