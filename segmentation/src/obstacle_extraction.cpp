// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "obstacle_kernels.h"

#include <pcl/segmentation/obstacle_extraction.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl {
namespace rgbd_planes {

void
ObstacleExtraction::compute (const OrganizedPoints& points,
                             const OrganizedNormals& normals,
                             const LabelledPlanes& planes,
                             const std::uint8_t* selected,
                             const pcl::Indices* excluded,
                             const ObstacleParameters& parameters,
                             std::vector<Obstacle>& obstacles)
{
  const DepthNoise& noise = parameters.points.noise;
  floor_.find (points,
               planes,
               parameters.camera_to_base,
               noise,
               parameters.floor_angle,
               parameters.floor_height);
  classify ({points, normals, planes, floor_}, selected, parameters);
  if (excluded)
    exclude (*excluded);
  const std::size_t min_points = parameters.min_cluster_size != 0
                                     ? parameters.min_cluster_size
                                     : std::max<std::size_t> (points.size() / 20000, 2);
  clusters_.compute (points, links_, noise, min_points, classes_);
  collect (points, parameters, obstacles);
}

void
ObstacleExtraction::classify (const ObstacleFrame& frame,
                              const std::uint8_t* selected,
                              const ObstacleParameters& parameters)
{
  const DepthNoise& noise = parameters.points.noise;
  classes_.resize (frame.points.size());
  links_.resize (frame.points);
  point_classes_.start (frame, parameters.points);
  rows_[1].load (frame.points, 0);
  for (int v = 0; v < frame.points.height; ++v) {
    PointRow &row = rows_[v % 2], &row_above = rows_[1 - v % 2];
    row.load (frame.points, v, selected);
    links_.addRow (v, row, row_above, noise);
    if (floor_.isFound())
      point_classes_.addRow (frame, v, row, classes_);
  }
  if (floor_.isFound()) {
    point_classes_.finish (frame, classes_);
    return;
  }
  for (std::size_t i = 0; i < classes_.size(); ++i)
    classes_[i] = isUsable (frame.points[i], noise) && (!selected || selected[i])
                      ? ObstacleClass::obstacle
                      : ObstacleClass::unmeasured;
}

void
ObstacleExtraction::exclude (const pcl::Indices& excluded)
{
  for (const pcl::index_t index : excluded) {
    ObstacleClass& result = classes_[static_cast<std::size_t> (index)];
    if (result != ObstacleClass::unmeasured)
      result = ObstacleClass::excluded;
  }
}

void
ObstacleExtraction::collect (const OrganizedPoints& points,
                             const ObstacleParameters& parameters,
                             std::vector<Obstacle>& obstacles)
{
  const auto& sizes = clusters_.sizes();
  obstacles.resize (sizes.size());
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    obstacles[k].indices.clear();
    obstacles[k].indices.reserve (sizes[k]);
  }
  nearest_.assign (sizes.size(), std::numeric_limits<float>::infinity());
  scan_builder_.start (parameters.scan, scan_);
  const auto width = static_cast<std::size_t> (points.width);
  const auto& runs = clusters_.runs();
  for (std::size_t run = 0, next; run < runs.size(); run = next) {
    const std::size_t row = runs[run].first / width;
    for (next = run + 1; next < runs.size() && runs[next].first / width == row;)
      ++next;
    addRow (
        points, &runs[run], &runs[next - 1] + 1, parameters.camera_to_base, obstacles);
  }
  scan_builder_.finish();
  for (auto& obstacle : obstacles) {
    obstacle.distance = obstacle.nearest.head<2>().norm();
    obstacle.direction = std::atan2 (obstacle.nearest.y(), obstacle.nearest.x());
  }
  std::sort (
      obstacles.begin(), obstacles.end(), [] (const Obstacle& a, const Obstacle& b) {
        return a.distance != b.distance ? a.distance < b.distance
                                        : a.indices.front() < b.indices.front();
      });
}

void
ObstacleExtraction::addRow (const OrganizedPoints& points,
                            const ObstacleClusters::Run* begin,
                            const ObstacleClusters::Run* end,
                            const Eigen::Affine3f& camera_to_base,
                            std::vector<Obstacle>& obstacles)
{
  const auto width = static_cast<std::size_t> (points.width);
  const std::size_t row = begin->first / width;
  rows_[0].load (points, static_cast<int> (row));
  for (auto* values : {&base_.x, &base_.y, &base_.z, &base_.squares})
    values->resize (rows_[0].size());
  moveRow (rows_[0],
           camera_to_base,
           base_.x.data(),
           base_.y.data(),
           base_.z.data(),
           base_.squares.data());
  const auto leaveOut = [&] (std::size_t from, std::size_t to) {
    std::fill (base_.x.begin() + static_cast<std::ptrdiff_t> (from),
               base_.x.begin() + static_cast<std::ptrdiff_t> (to),
               std::numeric_limits<float>::quiet_NaN());
  };
  std::size_t column = 0;
  for (const auto* run = begin; run != end; ++run) {
    if (run->cluster == ObstacleClusters::none)
      continue;
    const std::size_t first = run->first - row * width;
    leaveOut (column, first);
    column = first + run->length;
    if (classes_[run->first] == ObstacleClass::drop_off)
      followToFloor (points, *run, first, camera_to_base.translation());
    addRun (*run, first, obstacles[run->cluster]);
  }
  leaveOut (column, rows_[0].size());
  scan_builder_.addRow (
      base_.x.data(), base_.y.data(), base_.z.data(), rows_[0].size());
}

/** Moves points of a drop-off along their rays to where these meet the floor. */
void
ObstacleExtraction::followToFloor (const OrganizedPoints& points,
                                   const ObstacleClusters::Run& run,
                                   std::size_t column,
                                   const Eigen::Vector3f& camera)
{
  const Eigen::Vector4f& floor = floor_.coefficients();
  for (std::size_t i = 0; i < run.length; ++i) {
    const float height = heightAbove (floor, points[run.first + i]);
    const float scale = floor[3] / (floor[3] - height);
    float &x = base_.x[column + i], &y = base_.y[column + i], &z = base_.z[column + i];
    x = camera.x() + scale * (x - camera.x());
    y = camera.y() + scale * (y - camera.y());
    z = camera.z() + scale * (z - camera.z());
    base_.squares[column + i] = x * x + y * y;
  }
}

void
ObstacleExtraction::addRun (const ObstacleClusters::Run& run,
                            std::size_t column,
                            Obstacle& obstacle)
{
  obstacle.kind = classes_[run.first] == ObstacleClass::drop_off
                      ? Obstacle::Kind::drop_off
                      : Obstacle::Kind::obstacle;
  const std::size_t before = obstacle.indices.size();
  obstacle.indices.resize (before + run.length);
  std::iota (obstacle.indices.begin() + static_cast<std::ptrdiff_t> (before),
             obstacle.indices.end(),
             static_cast<pcl::index_t> (run.first));
  const float* squares = &base_.squares[column];
  const float nearest = minimum (squares, run.length);
  if (!(nearest < nearest_[run.cluster]))
    return;
  nearest_[run.cluster] = nearest;
  const auto i = static_cast<std::size_t> (
      std::find (squares, squares + run.length, nearest) - squares);
  obstacle.nearest = {base_.x[column + i], base_.y[column + i], base_.z[column + i]};
}

} // namespace rgbd_planes
} // namespace pcl
