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
  classify ({points, normals, planes, floor_, selected}, excluded, parameters);
  const std::size_t min_points = parameters.min_cluster_size != 0
                                     ? parameters.min_cluster_size
                                     : std::max<std::size_t> (points.size() / 20000, 2);
  clusters_.compute (points, noise, min_points, classes_);
  collect (points, parameters, obstacles);
}

void
ObstacleExtraction::classify (const ObstacleFrame& frame,
                              const pcl::Indices* excluded,
                              const ObstacleParameters& parameters)
{
  if (floor_.isFound())
    point_classes_.classify (frame, parameters.points, classes_);
  else {
    classes_.resize (frame.points.size());
    for (std::size_t i = 0; i < classes_.size(); ++i)
      classes_[i] = isUsable (frame.points[i], parameters.points.noise) &&
                            (!frame.selected || frame.selected[i])
                        ? ObstacleClass::obstacle
                        : ObstacleClass::unmeasured;
  }
  if (!excluded)
    return;
  for (const pcl::index_t index : *excluded) {
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
  std::size_t row_end = 0;
  for (const auto& run : clusters_.runs()) {
    if (run.cluster == ObstacleClusters::none)
      continue;
    const auto width = static_cast<std::size_t> (points.width);
    if (run.first >= row_end) {
      moveToBase (points, run.first / width, parameters.camera_to_base);
      row_end = (run.first / width + 1) * width;
    }
    const std::size_t column = run.first + width - row_end;
    if (classes_[run.first] == ObstacleClass::drop_off)
      followToFloor (points, run, column, parameters.camera_to_base.translation());
    addRun (run, column, obstacles[run.cluster]);
  }
  scan_builder_.finish();
  for (auto& obstacle : obstacles) {
    obstacle.distance = obstacle.nearest.head<2>().norm();
    obstacle.direction = std::atan2 (obstacle.nearest.y(), obstacle.nearest.x());
  }
  std::stable_sort (
      obstacles.begin(), obstacles.end(), [] (const Obstacle& a, const Obstacle& b) {
        return a.distance < b.distance;
      });
}

void
ObstacleExtraction::moveToBase (const OrganizedPoints& points,
                                std::size_t row,
                                const Eigen::Affine3f& camera_to_base)
{
  row_.load (points, static_cast<int> (row));
  for (auto& coordinate : base_)
    coordinate.resize (row_.size());
  moveRow (row_, camera_to_base, {base_[0].data(), base_[1].data(), base_[2].data()});
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
    for (int k = 0; k < 3; ++k) {
      float& coordinate = base_[static_cast<std::size_t> (k)][column + i];
      coordinate = camera[k] + scale * (coordinate - camera[k]);
    }
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
  const float *x = &base_[0][column], *y = &base_[1][column], *z = &base_[2][column];
  scan_builder_.add (x, y, z, run.length);
  float nearest = nearest_[run.cluster];
  for (std::size_t i = 0; i < run.length; ++i) {
    const float squared = x[i] * x[i] + y[i] * y[i];
    if (squared < nearest) {
      nearest = squared;
      obstacle.nearest = {x[i], y[i], z[i]};
    }
  }
  nearest_[run.cluster] = nearest;
}

} // namespace rgbd_planes
} // namespace pcl
