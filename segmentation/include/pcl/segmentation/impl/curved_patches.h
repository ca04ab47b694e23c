// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/impl/plane_moments.h>
#include <pcl/segmentation/impl/plane_samples.h>
#include <pcl/segmentation/impl/tile_parts.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Finds planes that are patches of curved surfaces, such as people.
 *
 * The normals of a patch hardly turn, but those of the surface do, and it goes on beside
 * the patch: samples there are free, or belong to patches with nearly the same normal,
 * and lie a little off its plane. Planes end at creases and edges of depth. What is left
 * between patches is one, too.
 */
class PCL_RGBD_PLANES_EXPORTS CurvedPatches {
public:
  /** \brief Looks at all planes.
   * \param[in] owners for each sample the plane it belongs to, or less than 0
   * \param[in] parts what each plane owns in each tile
   * \param[in] tolerance how far from its plane a point may lie
   */
  void
  find (const PlaneSamples& samples,
        const std::vector<std::int32_t>& owners,
        const std::vector<TilePart>& parts,
        const std::vector<Plane>& planes,
        const DepthNoise& tolerance);

  bool
  isPatch (std::size_t plane) const
  {
    return is_patch_[plane] != 0;
  }

private:
  /** The samples beside those of a plane, in their tiles. */
  struct Border {
    std::size_t samples = 0;
    /** Those on which the surface goes on. */
    std::size_t continued = 0;

    bool
    isMostlyContinued () const;
  };

  template <typename GoesOn>
  void
  countBorders (const PlaneSamples& samples,
                const std::vector<TilePart>& parts,
                const std::vector<Plane>& planes,
                const DepthNoise& tolerance,
                const GoesOn& goesOn);

  bool
  turns (const PlaneSamples& samples,
         const std::vector<TilePart>& parts,
         std::uint32_t number,
         const Plane& plane,
         const DepthNoise& tolerance);

  void
  findTiles (const PlaneSamples& samples,
             const std::vector<TilePart>& parts,
             std::uint32_t plane);

  std::vector<Border> borders_;
  /** Of the plane that is looked at: its tiles and those around, what it has in each tile,
   * and the weights of its samples and those on which the surface goes on. */
  std::vector<std::uint32_t> tiles_;
  std::vector<std::uint8_t> is_listed_;
  std::vector<unsigned> own_;
  std::vector<float> weights_;
  /** Of planes beside which the surface goes on: how much both turn. */
  std::vector<double> turn_per_metre_;
  std::vector<std::uint8_t> is_patch_;
};

} // namespace rgbd_planes
} // namespace pcl
