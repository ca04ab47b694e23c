// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/normal_space_clusters.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Bounds the memory of the grid: 67 cells along each axis. */
constexpr float min_cell_size = 0.03f;

/** The index of the cell of \a value in [0, 1]. */
int
cellOf (float value, int cells)
{
  return std::min (std::max (static_cast<int> (value * static_cast<float> (cells)), 0),
                   cells - 1);
}

} // namespace

void
NormalSpaceClusters::compute (const PlaneSamples& samples,
                              NormalSpaceGrid grid,
                              float angular_threshold,
                              std::size_t min_cell_points)
{
  const float cell_size = std::max (0.5f * angular_threshold, min_cell_size);
  if (grid == NormalSpaceGrid::voxels) {
    cells_per_axis_ = static_cast<int> (std::ceil (2.f / cell_size));
    const int n = cells_per_axis_;
    fillGrid (
        samples, static_cast<std::size_t> (n * n * n), [n] (float x, float y, float z) {
          return (cellOf (0.5f * (z + 1.f), n) * n + cellOf (0.5f * (y + 1.f), n)) * n +
                 cellOf (0.5f * (x + 1.f), n);
        });
  }
  else {
    layOutSphere (cell_size);
    fillGrid (samples, latitudes_.back(), [this] (float x, float y, float z) {
      const float theta = std::atan2 (z, std::hypot (x, y));
      const float phi = std::atan2 (y, x);
      const auto latitude =
          static_cast<std::size_t> (cellOf (theta / static_cast<float> (M_PI) + 0.5f,
                                            static_cast<int> (latitudes_.size()) - 1));
      const int cells =
          static_cast<int> (latitudes_[latitude + 1] - latitudes_[latitude]);
      return static_cast<int> (latitudes_[latitude]) +
             cellOf (0.5f * phi / static_cast<float> (M_PI) + 0.5f, cells);
    });
  }
  startMerging (std::max (min_cell_points, std::size_t{1}));
  if (grid == NormalSpaceGrid::voxels)
    addNeighboursOfVoxels();
  else
    addNeighboursOnSphere();
  finishMerging (samples, angular_threshold);
}

/** Circles of latitude are as wide as cells; towards the poles they hold fewer cells. */
void
NormalSpaceClusters::layOutSphere (float cell_size)
{
  const double latitudes = std::ceil (M_PI / cell_size);
  latitudes_.assign (1, 0);
  for (double k = 0.5; k < latitudes; ++k) {
    const double circumference = 2. * M_PI * std::sin (M_PI * k / latitudes);
    latitudes_.push_back (latitudes_.back() +
                          static_cast<std::size_t> (
                              std::max (1., std::round (circumference / cell_size))));
  }
}

template <typename CellOf>
void
NormalSpaceClusters::fillGrid (const PlaneSamples& samples,
                               std::size_t cells,
                               const CellOf& cell_of)
{
  grid_.assign (cells, Cell{});
  labels_.assign (samples.size(), none);
  for (const std::uint32_t i : samples.seeds) {
    const float x = samples.normal_x[i], y = samples.normal_y[i],
                z = samples.normal_z[i];
    const int cell = cell_of (x, y, z);
    Cell& sums = grid_[static_cast<std::size_t> (cell)];
    sums.sum += Eigen::Vector3f (x, y, z);
    ++sums.points;
    labels_[i] = cell;
  }
}

void
NormalSpaceClusters::startMerging (std::size_t min_cell_points)
{
  cluster_of_cell_.assign (grid_.size(), none);
  cells_.clear();
  places_.clear();
  for (std::size_t i = 0; i < grid_.size(); ++i)
    if (grid_[i].points >= min_cell_points) {
      cluster_of_cell_[i] = static_cast<std::int32_t> (cells_.size());
      cells_.push_back ({grid_[i].sum, grid_[i].sum.normalized()});
      places_.push_back (i);
    }
  merging_.reset (cells_);
}

void
NormalSpaceClusters::addNeighbours (std::size_t cell, std::size_t other)
{
  const std::int32_t a = cluster_of_cell_[cell], b = cluster_of_cell_[other];
  if (a != none && b != none && a != b)
    merging_.addNeighbours (static_cast<std::size_t> (a), static_cast<std::size_t> (b));
}

void
NormalSpaceClusters::addNeighboursOfVoxels()
{
  const int n = cells_per_axis_;
  for (const std::size_t cell : places_) {
    const int place = static_cast<int> (cell);
    const int x = place % n, y = place / n % n, z = place / (n * n);
    // Half of the 26 neighbours: each pair once.
    for (int k = 14; k < 27; ++k) {
      const int u = x + k % 3 - 1, v = y + k / 3 % 3 - 1, w = z + k / 9 - 1;
      if (u >= 0 && u < n && v >= 0 && v < n && w < n)
        addNeighbours (cell, static_cast<std::size_t> ((w * n + v) * n + u));
    }
  }
}

void
NormalSpaceClusters::addNeighboursOnSphere()
{
  for (std::size_t latitude = 0; latitude + 1 < latitudes_.size(); ++latitude) {
    const std::size_t begin = latitudes_[latitude], end = latitudes_[latitude + 1];
    const std::size_t cells = end - begin;
    for (std::size_t k = 0; k < cells; ++k) {
      addNeighbours (begin + k, begin + (k + 1) % cells);
      if (latitude + 2 == latitudes_.size())
        continue;
      // Those of the next circle that touch it, with the ones beside them.
      const std::size_t others = latitudes_[latitude + 2] - end;
      const std::size_t first = k * others / cells + others - 1;
      const std::size_t last = ((k + 1) * others - 1) / cells + others + 1;
      for (std::size_t other = first; other <= last; ++other)
        addNeighbours (begin + k, end + other % others);
    }
  }
}

void
NormalSpaceClusters::finishMerging (const PlaneSamples& samples,
                                    float angular_threshold)
{
  // The length of the chord between unit vectors grows with their angle.
  const float max_chord = 2.f * std::sin (0.5f * angular_threshold);
  merging_.merge (max_chord, [] (const Cluster& a, const Cluster& b) {
    return (a.mean_normal - b.mean_normal).norm();
  });
  mean_normals_.clear();
  numbers_.assign (cells_.size(), none);
  for (std::size_t i = 0; i < cells_.size(); ++i)
    if (merging_.find (i) == i) {
      numbers_[i] = static_cast<std::int32_t> (mean_normals_.size());
      mean_normals_.push_back (merging_[i].mean_normal);
    }
  points_.assign (mean_normals_.size(), 0);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const std::int32_t cluster = numbers_[merging_.find (i)];
    cluster_of_cell_[places_[i]] = cluster;
    points_[static_cast<std::size_t> (cluster)] += grid_[places_[i]].points;
  }
  for (const std::uint32_t i : samples.seeds)
    labels_[i] = cluster_of_cell_[static_cast<std::size_t> (labels_[i])];
}

} // namespace rgbd_planes
} // namespace pcl
