// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/impl/disjoint_sets.h>
#include <pcl/segmentation/impl/object_clusters.h>
#include <pcl/segmentation/impl/occlusion_steps.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Finds small clusters that are parts of a much larger one beside them, such as handles,
 * what edges without depth cut off, and the foot that a sensor smears where a thing stands.
 *
 * Things of their own stand on their plane or rest on another thing. Such parts do neither: they
 * hang beside the larger cluster, are on a slope of it too steep to rest on, such as caps of
 * bottles, or are hardly higher than noise and end below it.
 */
class PCL_RGBD_PLANES_EXPORTS AttachedParts {
public:
  /** \param[in] normals one for each point, or none
   * \param[in] occlusions of the same clusters
   * \param[in] supports the planes that the clusters refer to
   * \param[in,out] sets parts join the set of the larger cluster
   */
  void
  find (const OrganizedPoints& points,
        const OrganizedNormals& normals,
        const OcclusionSteps& occlusions,
        const SupportPlanes& supports,
        const ObjectParameters& parameters,
        const std::vector<ObjectCluster>& clusters,
        DisjointSets& sets);

private:
  /** A point of a cluster that is next to one of another cluster. */
  struct Contact {
    std::size_t other = 0;
    float height = 0.f;
    float cosine = 1.f; // of the slope of the other one's surface, or NaN
  };

  void
  findContacts (const ObjectCluster& cluster, const SupportSurface& support);

  bool
  isPart (const ObjectCluster& cluster,
          const SupportSurface& support,
          std::size_t other,
          const ObjectParameters& parameters);

  bool
  isSteep ();

  OrganizedPoints points_;
  OrganizedNormals normals_;
  const OcclusionSteps* occlusions_ = nullptr;
  std::vector<Contact> contacts_;
  std::vector<std::size_t> sizes_;         // of clusters, in points
  std::vector<std::size_t> contacts_with_; // each of the clusters
  std::vector<float> heights_, contact_heights_, contact_cosines_;
};

} // namespace rgbd_planes
} // namespace pcl
