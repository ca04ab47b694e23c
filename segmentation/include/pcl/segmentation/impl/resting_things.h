// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/impl/disjoint_sets.h>
#include <pcl/segmentation/impl/occlusion_steps.h>
#include <pcl/segmentation/impl/support_planes.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Finds what rests on another thing instead of their plane, and how high, and what
 * is one thing with the stem that holds it, such as a goblet.
 *
 * Its lower end is seen, well above the plane: in mid-air, or next to other things over which it
 * lies. What stands behind a thing and touches it does not lie over that. A stem is seen below
 * a small part of the lower end, within the outline of what it holds, and is slender.
 */
class PCL_RGBD_PLANES_EXPORTS RestingThings {
public:
  /** \param[in] pixel_angle the one between the rays of neighbouring pixels, in radians
   * \param[in] occlusions of the clusters that things consist of
   * \param[in] supports the planes that the things refer to
   * \param[in] thing_of for each cluster, its thing
   * \param[in,out] things get their bottoms
   * \param[in,out] sets things are joined with their stems
   */
  void
  find (const OrganizedPoints& points,
        float pixel_angle,
        const OcclusionSteps& occlusions,
        const std::vector<SupportSurface>& supports,
        const ObjectParameters& parameters,
        const std::vector<std::size_t>& thing_of,
        std::vector<ObjectCluster>& things,
        DisjointSets& sets);

private:
  /** \brief What is below a thing, in lines of the image. */
  struct LowerEnd {
    std::size_t lines = 0;
    /** Another thing that is next to it. */
    std::size_t touching = 0;
    /** Something that is next to it, well above the plane, and of no thing or support. */
    std::size_t on_no_thing = 0;
    /** Something farther, and it does not end higher than elsewhere. */
    std::size_t farther = 0;
    /** Of these, where one looks under it. Seen from above, one looks past it. */
    std::size_t in_air = 0;
  };

  /** \brief The heights of a thing above its plane, but for a few points. */
  struct Extent {
    float low = 0.f, high = 0.f;
    /** Where the lower end of a ball or a lying cylinder is seen, in parts of its height. */
    float low_if_round = 0.f;
    float sigma = 0.f;                                /**< of depth */
    Eigen::Vector2f middle = Eigen::Vector2f::Zero(); /**< on the plane */
  };

  /** \brief What is no lower than this above its plane may rest on something else. */
  float
  minLow (const Extent& extent) const;

  bool
  isOnSupport (const float* point) const;

  Extent
  extentOf (const ObjectCluster& thing, const SupportSurface& support);

  LowerEnd
  lowerEnd (std::size_t thing, const SupportSurface& support, const Extent& extent);

  void
  lookBelow (std::uint32_t lowest,
             std::ptrdiff_t down,
             std::size_t thing,
             const SupportSurface& support,
             const Extent& extent,
             LowerEnd& end);

  bool
  liesOverOthers (const ObjectCluster& thing, const SupportSurface& support);

  void
  joinStems (std::size_t thing,
             const SupportSurface& support,
             const Extent& extent,
             DisjointSets& sets);

  float
  areaOf (const ObjectCluster& thing) const;

  void
  addToGround (const std::vector<PointRun>& runs, const SupportSurface& support);

  OrganizedPoints points_;
  float pixel_angle_ = 0.f;
  const OcclusionSteps* occlusions_ = nullptr;
  const std::vector<SupportSurface>* supports_ = nullptr;
  ObjectParameters parameters_;
  const std::vector<std::size_t>* thing_of_ = nullptr;
  const std::vector<ObjectCluster>* things_ = nullptr;
  std::vector<std::size_t> touched_;  // things below the one at hand
  std::vector<std::uint32_t> behind_; // their points next to its lower end, not nearer
  std::vector<float> heights_;
  std::vector<Eigen::Vector2f> ground_;
  ConvexOutline outline_;
};

} // namespace rgbd_planes
} // namespace pcl
