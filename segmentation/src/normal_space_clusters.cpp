// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/normal_space_clusters.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Bounds the memory of the grid: 68 cells along each axis. */
constexpr float min_cell_size = 0.03f;

} // namespace

void
NormalSpaceClusters::compute (const OrganizedNormals& normals,
                              const std::vector<std::uint8_t>& use,
                              float angular_threshold,
                              std::size_t min_cell_points)
{
  fillGrid (normals, use, std::max (0.5f * angular_threshold, min_cell_size));
  mergeCells (angular_threshold, std::max (min_cell_points, std::size_t{1}));
}

void
NormalSpaceClusters::fillGrid (const OrganizedNormals& normals,
                               const std::vector<std::uint8_t>& use,
                               float cell_size)
{
  cells_per_axis_ = static_cast<int> (std::ceil (2.f / cell_size)) + 1;
  const auto n = static_cast<std::size_t> (cells_per_axis_);
  grid_.assign (n * n * n, Cell{});
  labels_.assign (use.size(), none);
  const auto cellAlong = [&] (float component) {
    const float cell = (component + 1.f) / cell_size;
    return static_cast<int> (
        std::clamp (cell, 0.f, static_cast<float> (cells_per_axis_ - 1)));
  };
  for (std::size_t i = 0; i < use.size(); ++i) {
    if (!(use[i] & clustered))
      continue;
    const float* normal = normals.normal + i * normals.stride;
    const int cell = (cellAlong (normal[2]) * cells_per_axis_ + cellAlong (normal[1])) *
                         cells_per_axis_ +
                     cellAlong (normal[0]);
    Cell& sums = grid_[static_cast<std::size_t> (cell)];
    sums.sum += Eigen::Vector3d (normal[0], normal[1], normal[2]);
    ++sums.points;
    labels_[i] = cell;
  }
}

void
NormalSpaceClusters::mergeCells (float angular_threshold, std::size_t min_cell_points)
{
  std::vector<std::int32_t> cluster_of_cell (grid_.size(), none);
  std::vector<Cell> clusters;
  for (std::size_t i = 0; i < grid_.size(); ++i)
    if (grid_[i].points >= min_cell_points) {
      cluster_of_cell[i] = static_cast<std::int32_t> (clusters.size());
      clusters.push_back (grid_[i]);
    }
  const std::size_t count = clusters.size();
  merging_.reset (std::move (clusters));

  const int n = cells_per_axis_;
  const auto clusterAt = [&] (int x, int y, int z) {
    const bool inside = x >= 0 && x < n && y >= 0 && y < n && z >= 0 && z < n;
    return inside ? cluster_of_cell[static_cast<std::size_t> ((z * n + y) * n + x)]
                  : none;
  };
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const std::int32_t cluster = clusterAt (x, y, z);
        if (cluster == none)
          continue;
        // Half of the 26 neighbours: each pair once.
        for (int k = 14; k < 27; ++k) {
          const std::int32_t neighbour =
              clusterAt (x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1);
          if (neighbour != none)
            merging_.addNeighbours (static_cast<std::size_t> (cluster),
                                    static_cast<std::size_t> (neighbour));
        }
      }
  merging_.merge (angular_threshold, [] (const Cell& a, const Cell& b) {
    return static_cast<float> (
        std::atan2 (a.sum.cross (b.sum).norm(), a.sum.dot (b.sum)));
  });

  mean_normals_.clear();
  std::vector<std::int32_t> number (count, none);
  for (std::size_t i = 0; i < count; ++i)
    if (merging_.find (i) == i) {
      number[i] = static_cast<std::int32_t> (mean_normals_.size());
      mean_normals_.push_back (merging_[i].sum.normalized().cast<float>());
    }
  for (std::int32_t& cluster : cluster_of_cell)
    if (cluster != none)
      cluster = number[merging_.find (static_cast<std::size_t> (cluster))];
  for (std::int32_t& label : labels_)
    if (label != none)
      label = cluster_of_cell[static_cast<std::size_t> (label)];
}

} // namespace rgbd_planes
} // namespace pcl
