// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/obstacle_evaluation.h>
#include <pcl/apps/statistics.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr float max_gap_m = 0.1f;
constexpr float min_height_m = 0.01f;
constexpr float max_sigmas = 3.f;
constexpr std::size_t min_points_divisor = 6000;

bool
areConnected (const TruthPoint& a, const TruthPoint& b)
{
  return a.obstacle != 0 && b.obstacle != 0 && a.object == b.object &&
         (a.getVector3fMap() - b.getVector3fMap()).norm() <= max_gap_m;
}

/** What is known of a true obstacle. */
struct TrueObstacle {
  float top = 0.f; // above the floor
  double squared_ranges = 0.;
  std::size_t points = 0;
  std::size_t found = 0;
};

} // namespace

std::vector<std::uint32_t>
numberObstacles (const pcl::PointCloud<TruthPoint>& truth)
{
  std::vector<std::uint32_t> numbers (truth.size(), 0);
  std::vector<std::size_t> open;
  const std::size_t width = truth.width;
  std::uint32_t last = 0;
  for (std::size_t seed = 0; seed < truth.size(); ++seed) {
    if (truth[seed].obstacle == 0 || numbers[seed] != 0)
      continue;
    numbers[seed] = ++last;
    open.push_back (seed);
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      const auto visit = [&] (std::size_t neighbour) {
        if (numbers[neighbour] == 0 && areConnected (truth[i], truth[neighbour])) {
          numbers[neighbour] = last;
          open.push_back (neighbour);
        }
      };
      if (i % width > 0)
        visit (i - 1);
      if (i % width + 1 < width)
        visit (i + 1);
      if (i >= width)
        visit (i - width);
      if (i + width < truth.size())
        visit (i + width);
    }
  }
  return numbers;
}

void
ObstacleEvaluation::add (const ObstacleTruth& frame,
                         const std::vector<ObstacleClass>& classes)
{
  std::vector<TrueObstacle> all;
  const std::size_t floor_points_before = floor_points;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const TruthPoint& truth = frame.truth[i];
    if (!isMeasured (frame.points[i]) || !std::isfinite (truth.z))
      continue;
    const bool is_obstacle =
        classes[i] == ObstacleClass::obstacle || classes[i] == ObstacleClass::drop_off;
    const std::size_t number = frame.obstacles[i];
    if (number == 0) {
      addFloorPoint (frame.points[i], truth, is_obstacle);
      continue;
    }
    all.resize (std::max (all.size(), number));
    TrueObstacle& obstacle = all[number - 1];
    obstacle.top =
        std::max (obstacle.top, (frame.camera_to_base * truth.getVector3fMap()).z());
    obstacle.squared_ranges += truth.getVector3fMap().squaredNorm();
    ++obstacle.points;
    obstacle.found += is_obstacle;
  }

  if (floor_points == floor_points_before)
    return;
  for (const auto& obstacle : all) {
    if (obstacle.points * min_points_divisor < classes.size())
      continue;
    const double squared_range =
        obstacle.squared_ranges / static_cast<double> (obstacle.points);
    const float sigma = noise_.sigmaAtSquare (static_cast<float> (squared_range));
    constexpr float rounding = 1e-4f;
    if (obstacle.top < std::max (min_height_m, max_sigmas * sigma) - rounding)
      continue;
    ++obstacles;
    found_obstacles += 2 * obstacle.found >= obstacle.points;
  }
}

void
ObstacleEvaluation::addFloorPoint (const float* point,
                                   const TruthPoint& truth,
                                   bool is_obstacle)
{
  ++all_floor_points;
  all_false_points += is_obstacle;
  const float sigma = noise_.sigmaAtSquare (truth.getVector3fMap().squaredNorm());
  if (std::abs (point[2] - truth.z) > max_sigmas * sigma)
    return;
  ++floor_points;
  false_points += is_obstacle;
}

double
ObstacleEvaluation::obstaclesPercent() const
{
  return percentOf (found_obstacles, obstacles);
}

double
ObstacleEvaluation::falsePointsPercent() const
{
  return percentOf (false_points, floor_points);
}

} // namespace rgbd_planes
} // namespace pcl
