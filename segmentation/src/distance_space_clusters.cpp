// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/distance_space_clusters.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Distances from 1 / 128 to 128 m; what lies beyond falls into the first or last bin. */
constexpr float min_distance = 0.0078125f;
constexpr int octaves = 14;
/** A float holds a logarithm: its exponent, and in the mantissa the 64 parts of an
 * octave. Bins are 0.8 to 1.6 % wide. */
constexpr int mantissa_bits_left_out = 17;
constexpr int bins_per_octave = 64;
constexpr std::size_t bins_per_histogram = octaves * bins_per_octave;
/** Merged clusters differ by no more bins: as with normals, a cell is half as
 * wide. */
constexpr float max_bins_apart = 2.f;

std::size_t
binOf (float distance)
{
  const auto bits = [] (float value) {
    std::int32_t result;
    std::memcpy (&result, &value, sizeof result);
    return result >> mantissa_bits_left_out;
  };
  const std::int32_t bin = bits (distance) - bits (min_distance);
  return static_cast<std::size_t> (
      std::clamp (bin, 0, static_cast<std::int32_t> (bins_per_histogram) - 1));
}

} // namespace

void
DistanceSpaceClusters::compute (const PlaneSamples& samples,
                                const NormalSpaceClusters& normal_clusters,
                                std::size_t min_points,
                                bool at_minima)
{
  const auto& normals = normal_clusters.meanNormals();
  labels_ = normal_clusters.labels();
  histogram_of_.assign (normals.size(), NormalSpaceClusters::none);
  std::size_t histograms = 0;
  for (std::size_t k = 0; k < normals.size(); ++k)
    if (normal_clusters.points()[k] >= min_points)
      histogram_of_[k] = static_cast<std::int32_t> (histograms++);

  bins_.assign (histograms * bins_per_histogram, 0);
  for (const std::uint32_t i : samples.seeds) {
    if (labels_[i] == NormalSpaceClusters::none)
      continue;
    const auto cluster = static_cast<std::size_t> (labels_[i]);
    const std::int32_t histogram = histogram_of_[cluster];
    labels_[i] = NormalSpaceClusters::none;
    if (histogram == NormalSpaceClusters::none)
      continue;
    const Eigen::Vector3f& n = normals[cluster];
    const float distance =
        std::abs (n[0] * samples.x[i] + n[1] * samples.y[i] + n[2] * samples.z[i]);
    const std::size_t bin =
        static_cast<std::size_t> (histogram) * bins_per_histogram + binOf (distance);
    ++bins_[bin];
    labels_[i] = static_cast<std::int32_t> (bin);
  }

  cluster_of_bin_.resize (bins_.size());
  clusters_ = 0;
  for (std::size_t histogram = 0; histogram < histograms; ++histogram)
    if (at_minima)
      splitAtMinima (histogram);
    else
      mergeNeighbours (histogram);
  for (const std::uint32_t i : samples.seeds)
    if (labels_[i] != NormalSpaceClusters::none)
      labels_[i] = cluster_of_bin_[static_cast<std::size_t> (labels_[i])];
}

void
DistanceSpaceClusters::splitAtMinima (std::size_t histogram)
{
  std::size_t begin = histogram * bins_per_histogram;
  std::size_t end = begin + bins_per_histogram;
  while (begin < end && bins_[begin] == 0)
    ++begin;
  while (end > begin && bins_[end - 1] == 0)
    --end;
  const auto smoothed = [&] (std::size_t i) {
    return 2 * bins_[i] + (i > begin ? bins_[i - 1] : 0) +
           (i + 1 < end ? bins_[i + 1] : 0);
  };
  std::uint32_t before = 0;
  bool falling = true;
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint32_t now = smoothed (i);
    clusters_ += now > before && falling;
    if (now != before)
      falling = now < before;
    before = now;
    cluster_of_bin_[i] = clusters_ - 1;
  }
}

void
DistanceSpaceClusters::mergeNeighbours (std::size_t histogram)
{
  const std::size_t begin = histogram * bins_per_histogram;
  merged_bins_.resize (bins_per_histogram);
  for (std::size_t i = 0; i < bins_per_histogram; ++i) {
    const auto points = static_cast<float> (bins_[begin + i]);
    merged_bins_[i] = {points * static_cast<float> (i), points};
  }
  merging_.reset (merged_bins_);
  for (std::size_t i = 1; i < bins_per_histogram; ++i)
    if (merged_bins_[i - 1].points > 0.f && merged_bins_[i].points > 0.f)
      merging_.addNeighbours (i - 1, i);
  merging_.merge (max_bins_apart, [] (const Bin& a, const Bin& b) {
    return std::abs (a.sum / a.points - b.sum / b.points);
  });
  // Neighbours alone were merged: a cluster ends where the next one begins.
  for (std::size_t i = 0; i < bins_per_histogram; ++i) {
    clusters_ +=
        bins_[begin + i] > 0 && (i == 0 || merging_.find (i) != merging_.find (i - 1));
    cluster_of_bin_[begin + i] = clusters_ - 1;
  }
}

} // namespace rgbd_planes
} // namespace pcl
