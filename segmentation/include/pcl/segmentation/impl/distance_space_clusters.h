// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/impl/cluster_merging.h>
#include <pcl/segmentation/impl/normal_space_clusters.h>
#include <pcl/segmentation/impl/plane_samples.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Splits clusters of similar normals into planes: the second stage of the
 * segmentation (Holz et al. 2011, section 4.2).
 *
 * Each point of a normal cluster has a distance from the origin to the plane through it
 * with the mean normal of the cluster. The distances are collected in a logarithmic
 * histogram: a relative error of a measured range is the same relative error of that
 * distance. Instead of merging bins up to a threshold, which the tilt of the mean normal
 * of a large cluster defeats, the histogram is smoothed and cut at its minima, so that
 * each of its peaks is a cluster.
 */
class PCL_RGBD_PLANES_EXPORTS DistanceSpaceClusters {
public:
  /** \brief Splits the clusters; the distances of clusters with fewer than \a min_points
   * points are not looked at.
   * \param[in] at_minima false merges neighbouring bins instead, as the paper does
   */
  void
  compute (const PlaneSamples& samples,
           const NormalSpaceClusters& normal_clusters,
           std::size_t min_points,
           bool at_minima);

  /** \brief The cluster of each point, or NormalSpaceClusters::none. */
  const std::vector<std::int32_t>&
  labels () const
  {
    return labels_;
  }

private:
  /** Points, and the sum of their distances as numbers of bins. */
  struct Bin {
    float sum = 0.f, points = 0.f;

    Bin&
    operator+= (const Bin& other)
    {
      sum += other.sum;
      points += other.points;
      return *this;
    }
  };

  void
  splitAtMinima (std::size_t histogram);

  void
  mergeNeighbours (std::size_t histogram);

  /** Which histogram a normal cluster has, or none. */
  std::vector<std::int32_t> histogram_of_;
  /** The histograms of all normal clusters, one after the other. */
  std::vector<std::uint32_t> bins_;
  /** The cluster of each bin. */
  std::vector<std::int32_t> cluster_of_bin_;
  /** Bin of each point, then its cluster. */
  std::vector<std::int32_t> labels_;
  std::int32_t clusters_ = 0; // so far
  std::vector<Bin> merged_bins_;
  ClusterMerging<Bin> merging_;
};

} // namespace rgbd_planes
} // namespace pcl
