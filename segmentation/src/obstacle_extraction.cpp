// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "image_lines.h"
#include "obstacle_kernels.h"
#include "row_bits.h"

#include <pcl/segmentation/impl/obstacle_extraction.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

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
  const Eigen::Affine3f& camera_to_base = parameters.camera_to_base;
  floor_.find (points,
               planes,
               camera_to_base,
               noise,
               parameters.floor_angle,
               parameters.floor_height);
  const ObstacleFrame frame{points, normals, planes, floor_};
  start (frame, excluded, parameters);
  int finished = 0;
  for (int v = 0; v < points.height; ++v) {
    Row& row = rowAt (v);
    row.points.load (points, v, selected);
    const PointRow& above = rowAt (std::max (v - 1, 0)).points;
    const int final =
        point_classes_.addRow (frame, v, row.points, above, row.links, classes_);
    for (; finished < final; ++finished)
      finishRow (points, finished, camera_to_base);
  }
  clusters_.finish (classes_);
  if (floor_.isFound()) {
    bumps_.find (points, floor_.coefficients(), noise, clusters_, classes_);
    clusters_.makeFloor (bumps_.areBumps(), classes_);
  }
  scanLateRuns (points, camera_to_base);
  scan_builder_.finish();
  collect (points, camera_to_base, obstacles);
}

void
ObstacleExtraction::start (const ObstacleFrame& frame,
                           const pcl::Indices* excluded,
                           const ObstacleParameters& parameters)
{
  const OrganizedPoints& points = frame.points;
  const auto width = static_cast<std::size_t> (points.width);
  const std::size_t min_points = parameters.min_cluster_size != 0
                                     ? parameters.min_cluster_size
                                     : std::max<std::size_t> (points.size() / 20000, 2);
  classes_.resize (points.size());
  excluded_.assign (excluded ? points.size() : 0, 0);
  if (excluded)
    for (const pcl::index_t index : *excluded)
      excluded_[static_cast<std::size_t> (index)] = 1;
  extents_.clear();
  const PixelAngles angles = pixelAngles (points);
  point_classes_.start (frame, parameters.points, angles);
  clusters_.start (points,
                   parameters.points.noise,
                   angles,
                   min_points,
                   FloorBumps::maxPoints (points),
                   excluded != nullptr);
  scan_builder_.start (parameters.scan, width, scan_);
  rows_.resize (static_cast<std::size_t> (point_classes_.maxWaiting()));
  for (auto& row : rows_)
    for (auto* links : {&row.links.to_left, &row.links.to_above})
      links->resize (wordsFor (width));
}

void
ObstacleExtraction::finishRow (const OrganizedPoints& points,
                               int v,
                               const Eigen::Affine3f& camera_to_base)
{
  const auto width = static_cast<std::size_t> (points.width);
  const std::size_t first = static_cast<std::size_t> (v) * width;
  if (!excluded_.empty())
    exclude (first, first + width);
  const Row& row = rowAt (v);
  clusters_.addRow (points, &classes_[first], row.links);
  const std::size_t first_run = extents_.size();
  extents_.resize (clusters_.runs().size());
  scan_runs_.clear();
  // What is part of an excluded object is only known in the end.
  if (!excluded_.empty())
    return;
  for (std::size_t k = first_run; k < extents_.size(); ++k)
    if (!clusters_.isSmall (k))
      addToScan (k, first);
  scan_builder_.add (row.points, camera_to_base, floor_.reference(), scan_runs_);
}

void
ObstacleExtraction::addToScan (std::size_t run, std::size_t first)
{
  const auto& [begin, length, cluster] = clusters_.runs()[run];
  scan_runs_.push_back ({begin - first,
                         begin - first + length,
                         classes_[begin] == ObstacleClass::drop_off,
                         &extents_[run]});
}

void
ObstacleExtraction::exclude (std::size_t first, std::size_t end)
{
  for (std::size_t i = first; i < end; ++i)
    if (excluded_[i] && classes_[i] != ObstacleClass::unmeasured)
      classes_[i] = ObstacleClass::excluded;
}

void
ObstacleExtraction::scanLateRuns (const OrganizedPoints& points,
                                  const Eigen::Affine3f& camera_to_base)
{
  const auto width = static_cast<std::size_t> (points.width);
  const auto& runs = clusters_.runs();
  for (std::size_t k = 0; k < runs.size();) {
    const std::size_t v = runs[k].first / width, first = v * width;
    scan_runs_.clear();
    for (; k < runs.size() && runs[k].first < first + width; ++k)
      if (std::isinf (extents_[k].nearest_square) &&
          runs[k].cluster != ObstacleClusters::none) {
        addToScan (k, first);
        const ScanRun& run = scan_runs_.back();
        late_row_.load (points, static_cast<int> (v), run.begin, run.end);
      }
    scan_builder_.add (late_row_, camera_to_base, floor_.reference(), scan_runs_);
  }
}

void
ObstacleExtraction::collect (const OrganizedPoints& points,
                             const Eigen::Affine3f& camera_to_base,
                             std::vector<Obstacle>& obstacles)
{
  using Count = boost::counting_iterator<pcl::index_t>;
  const auto& sizes = clusters_.sizes();
  const auto& runs = clusters_.runs();
  obstacles.resize (sizes.size());
  nearest_runs_.assign (sizes.size(), runs.size());
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    obstacles[k].indices.clear();
    obstacles[k].indices.reserve (sizes[k]);
    obstacles[k].min_height = std::numeric_limits<float>::infinity();
    obstacles[k].max_height = -std::numeric_limits<float>::infinity();
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto& [first, length, cluster] = runs[i];
    if (cluster == ObstacleClusters::none)
      continue;
    Obstacle& obstacle = obstacles[cluster];
    obstacle.indices.insert (obstacle.indices.end(),
                             Count (static_cast<pcl::index_t> (first)),
                             Count (static_cast<pcl::index_t> (first + length)));
    std::size_t& nearest = nearest_runs_[cluster];
    const Extent& extent = extents_[i];
    if (nearest == runs.size() ||
        extent.nearest_square < extents_[nearest].nearest_square)
      nearest = i;
    obstacle.min_height = std::min (obstacle.min_height, extent.lowest);
    obstacle.max_height = std::max (obstacle.max_height, extent.highest);
  }
  for (std::size_t k = 0; k < sizes.size(); ++k)
    describe (points, runs[nearest_runs_[k]], camera_to_base, obstacles[k]);
  std::sort (
      obstacles.begin(), obstacles.end(), [] (const Obstacle& a, const Obstacle& b) {
        return a.distance != b.distance ? a.distance < b.distance
                                        : a.indices.front() < b.indices.front();
      });
}

void
ObstacleExtraction::describe (const OrganizedPoints& points,
                              const ObstacleClusters::Run& run,
                              const Eigen::Affine3f& camera_to_base,
                              Obstacle& obstacle) const
{
  const bool is_drop_off = classes_[run.first] == ObstacleClass::drop_off;
  obstacle.kind = is_drop_off ? Obstacle::Kind::drop_off : Obstacle::Kind::obstacle;
  obstacle.distance = std::numeric_limits<float>::infinity();
  for (std::size_t i = run.first; i < run.first + run.length; ++i) {
    Eigen::Vector3f p (points[i]);
    if (is_drop_off) {
      const Eigen::Vector4f& floor = floor_.reference();
      p *= floor[3] / (floor[3] - heightAbove (floor, points[i]));
    }
    p = camera_to_base * p;
    const float distance = p.head<2>().norm();
    if (distance < obstacle.distance) {
      obstacle.distance = distance;
      obstacle.nearest = p;
    }
  }
  obstacle.direction = std::atan2 (obstacle.nearest.y(), obstacle.nearest.x());
}

} // namespace rgbd_planes
} // namespace pcl
