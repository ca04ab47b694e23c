// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/disjoint_sets.h>
#include <pcl/segmentation/plane_samples.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The parts of clusters that hang together in the image, largest first. */
class PCL_RGBD_PLANES_EXPORTS SampleComponents {
public:
  /** \brief The samples of a component. */
  struct Component {
    const std::uint32_t* begin;
    const std::uint32_t* end;
    std::int32_t cluster;

    std::size_t
    size () const
    {
      return static_cast<std::size_t> (end - begin);
    }
  };

  /** \brief Finds components of at least \a min_points samples, each touching the next
   * along a side or a corner.
   * \param[in] clustered the samples that may have a cluster
   * \param[in] clusters the cluster of each sample, negative for none
   * \param[in] connected false takes each cluster for one component
   */
  void
  compute (const PlaneSamples& samples,
           const std::vector<std::uint32_t>& clustered,
           const std::vector<std::int32_t>& clusters,
           std::size_t min_points,
           bool connected);

  const std::vector<Component>&
  components () const
  {
    return components_;
  }

private:
  void
  joinNeighbours (const PlaneSamples& samples,
                  const std::vector<std::uint32_t>& clustered,
                  const std::vector<std::int32_t>& clusters);

  void
  joinClusters (const std::vector<std::uint32_t>& clustered,
                const std::vector<std::int32_t>& clusters);

  DisjointSets sets_;
  /** The first sample of the component of each. */
  std::vector<std::uint32_t> roots_;
  /** The number of samples of a component at its first one, then where they are. */
  std::vector<std::uint32_t> places_;
  std::vector<std::uint32_t> members_;
  std::vector<Component> components_;
};

} // namespace rgbd_planes
} // namespace pcl
