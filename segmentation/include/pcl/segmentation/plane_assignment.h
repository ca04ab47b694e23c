// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/plane_moments.h>
#include <pcl/segmentation/plane_samples.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl {
namespace rgbd_planes {

struct TilePlane;

/** \brief The label of points that lie on no plane. */
constexpr std::uint32_t unlabelled = std::numeric_limits<std::uint32_t>::max();

/** \brief Gives each point the nearest one of the planes that are present around it in
 * the image.
 *
 * How near a plane is counts along the viewing ray, where depth errs, in standard
 * deviations of depth; beyond \a max_sigmas it is too far. A plane is present in a tile
 * of samples and in the eight around it when it owns at least four samples of the tile;
 * it is out of the question for the pixels of a sample with a trusted normal that
 * disagrees, and of one on a curved surface.
 */
class PCL_RGBD_PLANES_EXPORTS PlaneAssignment {
public:
  /** \brief Which points to assign: all, or those that are samples. */
  enum class Pixels { all, samples };

  /** \brief Assigns points.
   * \param[in] selected not 0 for the points to look at; empty for all
   * \param[in] owners the plane of each sample, PlaneGrowth::none or curved_surface
   * \param[in] planes whose numbers the labels are
   */
  void
  compute (const OrganizedPoints& points,
           const std::vector<std::uint8_t>& selected,
           const PlaneSamples& samples,
           const std::vector<std::int32_t>& owners,
           const std::vector<Plane>& planes,
           const DepthNoise& noise,
           float max_sigmas,
           Pixels which);

  /** \brief After all points were assigned, the plane of each point, or \ref unlabelled. */
  std::vector<std::uint32_t>&
  labels ()
  {
    return labels_;
  }

  const std::vector<std::uint32_t>&
  labels () const
  {
    return labels_;
  }

  /** \brief Sums over the points of each plane, with weights of 1. */
  const std::vector<PlaneMoments>&
  moments () const
  {
    return moments_;
  }

  /** \brief The same, weighted as PlaneMoments says. */
  const std::vector<PlaneMoments>&
  weightedMoments () const
  {
    return weighted_moments_;
  }

private:
  static constexpr std::size_t min_samples_in_tile = 4;
  /** How many a tile and the eight around it can have. */
  static constexpr std::size_t max_planes_around =
      9 * PlaneSamples::tile_size / min_samples_in_tile;

  std::size_t
  findPlanesAround (const PlaneSamples& samples,
                    const std::vector<std::int32_t>& owners,
                    const std::vector<Plane>& planes,
                    int tile_u,
                    int tile_v,
                    TilePlane* around) const;

  void
  findPresentPlanes (const PlaneSamples& samples,
                     const std::vector<std::int32_t>& owners);

  /** Planes with enough samples in each tile: present_[first_[t] ... first_[t + 1]). */
  std::vector<std::uint32_t> present_;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> labels_;
  std::vector<PlaneMoments> moments_, weighted_moments_;
};

} // namespace rgbd_planes
} // namespace pcl
