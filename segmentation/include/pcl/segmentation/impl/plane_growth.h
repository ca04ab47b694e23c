// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/impl/plane_additions.h>
#include <pcl/segmentation/impl/plane_moments.h>
#include <pcl/segmentation/impl/plane_samples.h>
#include <pcl/segmentation/impl/sample_components.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

struct SurfaceTurn;

/** \brief Grows planes from connected parts of clusters, one after the other: a plane is
 * fitted to the points of a part, claims the free points on it that hang together with
 * the part in the image, and is fitted to these, until it claims the same ones.
 *
 * So the first, largest parts take the points from clusters that are no planes of their
 * own, such as in-between normals along creases. Parts of curved surfaces show in their
 * normals, which turn with the place on the part, and become no plane. Parts that reach over
 * several planes which meet at small angles, as a floor and a ramp, show in their errors, and
 * grow from one of these.
 */
class PCL_RGBD_PLANES_EXPORTS PlaneGrowth {
public:
  /** Of several planes that meet at small angles, one: the others may grow from the same
   * seed. */
  enum class Result { plane, side_of_bend, too_few_points, curved, claimed_by_larger };

  static constexpr std::int32_t none = -1, curved_surface = -2;

  /** \brief Starts with all samples free.
   * \param[in] min_points a plane has at least as many samples
   * \param[in] max_sigmas how far from it, in standard deviations of depth
   * \param[in] additions whether planes grow, and those on curved surfaces are
   * refused
   */
  void
  reset (const PlaneSamples& samples,
         double min_points,
         float max_sigmas,
         const PlaneAdditions& additions);

  /** \brief Grows a plane from \a seed. Its points are no longer free. */
  Result
  grow (PlaneSamples& samples, const SampleComponents::Component& seed);

  /** \brief The planes found so far, with the moments of their samples. */
  const std::vector<PlaneMoments>&
  moments () const
  {
    return moments_;
  }

  /** \brief The plane that each sample belongs to, \ref none or \ref curved_surface. */
  const std::vector<std::int32_t>&
  owners () const
  {
    return owners_;
  }

private:
  enum class Look : std::uint8_t { none, at_seed, done };

  PlaneMoments
  fitSeed (const PlaneSamples& samples, const SampleComponents::Component& seed);

  PlaneMoments
  keepLevel (const PlaneSamples& samples, const PlaneMoments& seed);

  template <typename Visit>
  void
  forEachClaim (std::uint32_t tile, const Visit& visit) const;

  /** A bit for each sample of a tile. */
  unsigned
  claimsIn (std::uint32_t tile) const;

  PlaneMoments
  sumSeed (const PlaneSamples& samples, std::size_t number);

  void
  claimSeed (const PlaneSamples& samples, const Plane& plane);

  bool
  claimUntilStable (const PlaneSamples& samples, Plane plane, float max_sigmas);

  void
  claimConnected (const PlaneSamples& samples, float max_sigmas);

  bool
  unbend (const PlaneSamples& samples, const Plane& start);

  Plane
  flatPart (const PlaneSamples& samples) const;

  SurfaceTurn
  turn (const PlaneSamples& samples) const;

  bool
  isCurved (const PlaneSamples& samples) const;

  void
  take (PlaneSamples& samples, std::int32_t owner);

  PlaneMoments
  sumOver (const PlaneSamples& samples,
           const std::vector<std::uint32_t>& tiles,
           std::size_t number) const;

  double min_points_ = 0.;
  float max_sigmas_ = 0.f;
  PlaneAdditions additions_;
  /** The number of free samples in each tile. */
  std::vector<std::uint8_t> free_;
  /** Of the plane that grows: weights of the samples on it, 0 for others, their number
   * in each tile, the tiles of its seed, those that it may have, and on the way there
   * those that were looked at and those that hang together. */
  std::vector<float> claimed_;
  std::vector<float> heights_; // of the samples of its seed, in standard deviations
  std::vector<std::uint8_t> counts_;
  std::vector<Look> looks_;
  std::vector<std::uint32_t> seed_tiles_, tiles_, seen_, connected_;
  Eigen::Vector3d reference_ = Eigen::Vector3d::Zero();
  Plane plane_;
  PlaneMoments sums_;
  std::vector<PlaneMoments> moments_;
  std::vector<std::int32_t> owners_;
};

} // namespace rgbd_planes
} // namespace pcl
