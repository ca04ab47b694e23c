// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/impl/attached_parts.h>
#include <pcl/segmentation/impl/hollow_things.h>
#include <pcl/segmentation/impl/resting_things.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Joins clusters that are pieces of one thing: see HollowThings, AttachedParts and
 * RestingThings. */
class PCL_RGBD_PLANES_EXPORTS WholeThings {
public:
  /** \param[in] normals one for each point, or none
   * \param[in] clustering of the same points
   * \param[in] supports the planes that the clusters refer to
   */
  void
  compute (const OrganizedPoints& points,
           const OrganizedNormals& normals,
           const ObjectClusters& clustering,
           const SupportPlanes& supports,
           const ObjectParameters& parameters,
           const std::vector<ObjectCluster>& clusters);

  /** \brief The clusters, in the order of the first ones of what was joined. */
  const std::vector<ObjectCluster>&
  things () const
  {
    return things_;
  }

private:
  void
  collect (const std::vector<ObjectCluster>& pieces,
           std::vector<ObjectCluster>& things);

  OcclusionSteps occlusions_;
  HollowThings hollow_things_;
  AttachedParts attached_parts_;
  RestingThings resting_things_;
  DisjointSets sets_;
  std::vector<std::size_t> piece_of_; // of what was joined last, for each part
  std::vector<ObjectCluster> pieces_; // things without their stems
  std::vector<ObjectCluster> things_;
};

} // namespace rgbd_planes
} // namespace pcl
