// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

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
  for (auto* coordinate : {&base_.x, &base_.y, &base_.z})
    coordinate->resize (static_cast<std::size_t> (points.width));
  scan_builder_.start (parameters.scan, scan_);
  for (const auto& run : clusters_.runs())
    if (run.cluster != ObstacleClusters::none) {
      moveToBase (points, run, parameters.camera_to_base);
      addRun (run, obstacles[run.cluster]);
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
                                const ObstacleClusters::Run& run,
                                const Eigen::Affine3f& camera_to_base)
{
  const Eigen::Matrix4f m = camera_to_base.matrix();
  const Eigen::Vector4f floor = floor_.coefficients();
  // The ray to a drop-off is followed to where it meets the floor.
  const bool is_drop_off = classes_[run.first] == ObstacleClass::drop_off;
  float* x = base_.x.data();
  float* y = base_.y.data();
  float* z = base_.z.data();
  for (std::size_t i = 0; i < run.length; ++i) {
    const float* p = points[run.first + i];
    const float to_floor = floor[3] / (floor[3] - heightAbove (floor, p));
    const float scale = is_drop_off ? to_floor : 1.f;
    x[i] = scale * (m (0, 0) * p[0] + m (0, 1) * p[1] + m (0, 2) * p[2]) + m (0, 3);
    y[i] = scale * (m (1, 0) * p[0] + m (1, 1) * p[1] + m (1, 2) * p[2]) + m (1, 3);
    z[i] = scale * (m (2, 0) * p[0] + m (2, 1) * p[1] + m (2, 2) * p[2]) + m (2, 3);
  }
}

void
ObstacleExtraction::addRun (const ObstacleClusters::Run& run, Obstacle& obstacle)
{
  obstacle.kind = classes_[run.first] == ObstacleClass::drop_off
                      ? Obstacle::Kind::drop_off
                      : Obstacle::Kind::obstacle;
  const std::size_t before = obstacle.indices.size();
  obstacle.indices.resize (before + run.length);
  std::iota (obstacle.indices.begin() + static_cast<std::ptrdiff_t> (before),
             obstacle.indices.end(),
             static_cast<pcl::index_t> (run.first));
  scan_builder_.add (base_.x.data(), base_.y.data(), base_.z.data(), run.length);
  float nearest = nearest_[run.cluster];
  for (std::size_t i = 0; i < run.length; ++i) {
    const float x = base_.x[i], y = base_.y[i], z = base_.z[i];
    const float squared = x * x + y * y;
    if (squared < nearest) {
      nearest = squared;
      obstacle.nearest = {x, y, z};
    }
  }
  nearest_[run.cluster] = nearest;
}

} // namespace rgbd_planes
} // namespace pcl
