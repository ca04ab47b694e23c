// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/impl/disjoint_sets.h>
#include <pcl/segmentation/impl/plane_samples.h>
#include <pcl/segmentation/impl/tile_parts.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The parts of clusters that hang together in the image, largest first.
 *
 * Found tile by tile, not sample by sample: a tile seldom has more than one or two. */
class PCL_RGBD_PLANES_EXPORTS SampleComponents {
public:
  /** \brief Samples of one cluster: what of each tile, tile after tile. */
  struct Component {
    const TilePart* first;
    const TilePart* last;
  };

  /** \brief Finds components of at least \a min_points samples, each touching the next
   * along a side or a corner.
   * \param[in] clusters the cluster of each sample, negative for none
   * \param[in] connected false takes each cluster for one component
   */
  void
  compute (const PlaneSamples& samples,
           const std::vector<std::int32_t>& clusters,
           std::size_t min_points,
           bool connected);

  std::size_t
  size () const
  {
    return components_.size();
  }

  Component
  operator[] (std::size_t component) const
  {
    const Members& members = components_[component];
    return {&members_[members.first], &members_[members.first] + members.number};
  }

private:
  /** Those of a component, in \ref members_. */
  struct Members {
    std::uint32_t first, number;
    std::size_t samples;
  };

  void
  findPieces (const PlaneSamples& samples, bool connected);

  void
  joinNeighbours (const PlaneSamples& samples);

  void
  joinClusters (const PlaneSamples& samples);

  void
  listComponents (std::size_t min_points);

  /** What clusters have in each tile, and the connected pieces of that. */
  std::vector<TilePart> parts_, pieces_;
  /** The number of the first piece of each tile and of each cluster. */
  std::vector<std::uint32_t> first_of_tile_, first_of_cluster_;
  DisjointSets sets_; // pieces that hang together
  /** The first piece of the component of each piece. */
  std::vector<std::uint32_t> roots_;
  /** For the first piece of each component, the number of samples; the number of pieces, and then
   * where these go in \ref members_. */
  std::vector<std::uint32_t> samples_, places_;
  std::vector<TilePart> members_;
  std::vector<Members> components_;
};

} // namespace rgbd_planes
} // namespace pcl
