// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/distance_space_clusters.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Distances from 1 cm to 100 m; what lies beyond falls into the first or last bin. */
constexpr float min_distance = 0.01f;
constexpr float max_distance = 100.f;

} // namespace

void
DistanceSpaceClusters::compute (const OrganizedPoints& points,
                                const NormalSpaceClusters& normal_clusters,
                                float relative_threshold,
                                std::size_t min_points)
{
  fillHistograms (points, normal_clusters);
  mergeBins (relative_threshold, std::max (min_points, std::size_t{1}));
}

void
DistanceSpaceClusters::fillHistograms (const OrganizedPoints& points,
                                       const NormalSpaceClusters& normal_clusters)
{
  const float log_width = std::log1p (bin_width);
  const auto bins_per_cluster =
      static_cast<std::size_t> (std::log (max_distance / min_distance) / log_width) + 1;
  const auto& normals = normal_clusters.meanNormals();
  bins_.assign (normals.size() * bins_per_cluster, Bin{});
  labels_ = normal_clusters.labels();
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (labels_[i] == NormalSpaceClusters::none)
      continue;
    const auto cluster = static_cast<std::size_t> (labels_[i]);
    const Eigen::Map<const Eigen::Vector3f> point (points[i]);
    const float distance = std::abs (normals[cluster].dot (point));
    const float log_distance =
        std::log (std::clamp (distance, min_distance, max_distance) / min_distance);
    const auto bin = std::min (static_cast<std::size_t> (log_distance / log_width),
                               bins_per_cluster - 1);
    const std::size_t index = cluster * bins_per_cluster + bin;
    bins_[index].sum += log_distance;
    ++bins_[index].points;
    labels_[i] = static_cast<std::int32_t> (index);
  }
}

void
DistanceSpaceClusters::mergeBins (float relative_threshold, std::size_t min_points)
{
  const std::size_t count = bins_.size();
  merging_.reset (std::move (bins_));
  // The last bin of one histogram and the first of the next differ far too much to
  // merge.
  for (std::size_t i = 0; i + 1 < count; ++i)
    if (merging_[i].points > 0 && merging_[i + 1].points > 0)
      merging_.addNeighbours (i, i + 1);
  merging_.merge (std::log1p (relative_threshold), [] (const Bin& a, const Bin& b) {
    return static_cast<float> (std::abs (a.sum / static_cast<double> (a.points) -
                                         b.sum / static_cast<double> (b.points)));
  });

  clusters_ = 0;
  std::vector<std::int32_t> number (count, NormalSpaceClusters::none);
  for (std::size_t i = 0; i < count; ++i)
    if (merging_.find (i) == i && merging_[i].points >= min_points)
      number[i] = static_cast<std::int32_t> (clusters_++);
  for (std::int32_t& label : labels_)
    if (label != NormalSpaceClusters::none)
      label = number[merging_.find (static_cast<std::size_t> (label))];
}

} // namespace rgbd_planes
} // namespace pcl
