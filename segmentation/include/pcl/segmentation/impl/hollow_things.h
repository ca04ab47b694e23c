// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/impl/disjoint_sets.h>
#include <pcl/segmentation/impl/object_clusters.h>
#include <pcl/segmentation/impl/occlusion_steps.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Finds what is seen of a cup, a bowl, or a box without a lid from above: the outside,
 * and behind the rim, a step further away, the inside.
 *
 * Convex things that stand one behind the other bulge towards each other, so that along the
 * image the step between them is largest where one of the two ends. Behind a rim it is largest
 * in the middle, and small at the ends, where the rim turns back. Walls that are seen at such flat
 * angles that they are not measured leave two plates, one behind the other and equally wide; the
 * wall of a bowl leaves its foot, in front of the inside and within the circle of its rim.
 */
class PCL_RGBD_PLANES_EXPORTS HollowThings {
public:
  /** \param[in] pixel_angle the angle between the rays of neighbouring pixels, radians
   * \param[in] occlusions of the same clusters
   * \param[in] supports the planes that the clusters refer to
   * \param[in,out] sets clusters of one thing are joined
   */
  void
  find (const OrganizedPoints& points,
        float pixel_angle,
        const OcclusionSteps& occlusions,
        const std::vector<SupportSurface>& supports,
        const std::vector<ObjectCluster>& clusters,
        DisjointSets& sets);

private:
  /** \brief From one cluster to one behind it. */
  using Steps = std::vector<OcclusionStep>::const_iterator;

  bool
  isHollow (Steps first, Steps last);

  bool
  isRim (Steps first, Steps last);

  bool
  areWalls (Steps first, Steps last);

  bool
  isFoot (Steps first, Steps last);

  float
  heightOf (std::uint32_t point) const;

  template <typename Number>
  float
  median (Steps first, Steps last, const Number& number);

  float
  medianHeight (Steps first, Steps last, std::uint32_t OcclusionStep::*point);

  OrganizedPoints points_;
  float pixel_angle_ = 0.f;
  const OcclusionSteps* occlusions_ = nullptr;
  const SupportSurface* support_ = nullptr; // of the cluster in front
  std::vector<float> numbers_;
  std::vector<bool> is_inside_; // clusters that are behind a rim
};

} // namespace rgbd_planes
} // namespace pcl
