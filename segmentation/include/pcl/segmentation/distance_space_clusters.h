// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/cluster_merging.h>
#include <pcl/segmentation/normal_space_clusters.h>

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
 * histogram, whose neighbouring bins are merged while their mean distances differ by no
 * more than a threshold. A relative error of a measured range is the same relative
 * error of that distance: hence logarithms.
 */
class PCL_RGBD_PLANES_EXPORTS DistanceSpaceClusters {
public:
  /** \brief Width of a bin relative to its distance. */
  static constexpr float bin_width = 0.01f;

  /** \brief Splits the clusters.
   * \param[in] relative_threshold largest difference between the mean distances of
   * merged bins, relative to the distance
   * \param[in] min_points clusters with fewer
   * points are dropped
   */
  void
  compute (const OrganizedPoints& points,
           const NormalSpaceClusters& normal_clusters,
           float relative_threshold,
           std::size_t min_points);

  /** \brief The cluster of each point, or NormalSpaceClusters::none. */
  const std::vector<std::int32_t>&
  labels () const
  {
    return labels_;
  }

  /** \brief The number of clusters. */
  std::size_t
  size () const
  {
    return clusters_;
  }

private:
  struct Bin {
    double sum = 0; // of the logarithms of distances
    std::size_t points = 0;

    Bin&
    operator+= (const Bin& other)
    {
      sum += other.sum;
      points += other.points;
      return *this;
    }
  };

  void
  fillHistograms (const OrganizedPoints& points,
                  const NormalSpaceClusters& normal_clusters);

  void
  mergeBins (float relative_threshold, std::size_t min_points);

  /** The histograms of all normal clusters, one after the other. */
  std::vector<Bin> bins_;
  /** Bin of each point, then its cluster. */
  std::vector<std::int32_t> labels_;
  ClusterMerging<Bin> merging_;
  std::size_t clusters_ = 0;
};

} // namespace rgbd_planes
} // namespace pcl
