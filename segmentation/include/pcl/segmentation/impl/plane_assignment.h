// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/impl/label_runs.h>
#include <pcl/segmentation/impl/plane_intersections.h>
#include <pcl/segmentation/impl/plane_moments.h>
#include <pcl/segmentation/impl/plane_samples.h>
#include <pcl/segmentation/impl/tile_parts.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl {
namespace rgbd_planes {

struct PointBlock;

/** The plane x, y, z * p + d = 0. */
struct PlaneEquation {
  float x, y, z, d;
};

/** A plane that the points of a tile may lie on. */
struct TilePlane {
  std::uint32_t number;
  /** For each sample of the tile, a bit: its normal agrees with that of the plane. */
  unsigned compatible;
};

/** All of them, in a row. */
struct TilePlanes {
  const TilePlane *first = nullptr, *last = nullptr;

  const TilePlane*
  begin () const
  {
    return first;
  }

  const TilePlane*
  end () const
  {
    return last;
  }

  std::size_t
  size () const
  {
    return static_cast<std::size_t> (last - first);
  }
};

/** \brief Gives each point the nearest one of the planes that are present around it in
 * the image.
 *
 * How near a plane is counts along the viewing ray, where depth errs, in standard
 * deviations of depth, as if no plane was seen at less than 6 degrees; beyond a tolerance it is
 * too far, for pixels 1.15 times that in tiles of which it owns all samples, and 0.9 times in
 * others. A plane is present in a tile of samples and in the eight around it when it owns at least
 * four samples of the tile;
 * it is out of the question for the pixels of a sample with a trusted normal that
 * disagrees, unless one beside it agrees and it is on another plane or disagrees by less
 * than 60 degrees; and for those of one on a curved surface. Where planes meet
 * (PlaneIntersections), points on both go to the one on their side. Where points
 * on no plane stand out in front of one, by a tenth of the pixels of a tile more than are behind
 * it, those in front of it by more than 0.35 times the tolerance, with another normal, may be on
 * the foot of that, and stay without a plane.
 */
class PCL_RGBD_PLANES_EXPORTS PlaneAssignment {
public:
  /** \brief Finds the planes around each tile.
   * \param[in] owners the plane of each sample, PlaneGrowth::none or curved_surface
   * \param[in] parts what each plane owns in each tile
   * \param[in] planes whose numbers the owners are
   */
  void
  findPlanes (const PlaneSamples& samples,
              const std::vector<std::int32_t>& owners,
              const std::vector<TilePart>& parts,
              const std::vector<Plane>& planes);

  /** \brief Leaves each sample, and the pixels of its cell, to its owner.
   * \param[in] owners the plane of each sample, negative for none
   */
  void
  keepOwners (const std::vector<std::int32_t>& owners);

  /** \brief Assigns samples to \a planes: those that were found, which may have been
   * fitted anew.
   * \param[in] tolerance how far from its plane a point may lie
   */
  void
  assignSamples (const PlaneSamples& samples,
                 const std::vector<Plane>& planes,
                 const DepthNoise& tolerance);

  /** \brief Looks for \a planes that meet, once samples were assigned: of all points on
   * both, each then goes to the one on its side of the line of intersection. */
  void
  findIntersections (const PlaneSamples& samples,
                     const std::vector<Plane>& planes,
                     const DepthNoise& tolerance);

  /** \brief Leaves the samples near lines of intersection out of the sums of the planes that
   * meet there, but for planes of which little would be left.
   *
   * Samples may be on the wrong side of a line that is not known yet; a few of them turn a
   * plane that is seen at a grazing angle.
   */
  void
  leaveOutUnclearSamples (const PlaneSamples& samples,
                          const std::vector<Plane>& planes,
                          const DepthNoise& tolerance);

  /** \brief Assigns all points.
   * \param[in] selected not 0 for the points to look at; empty for all
   * \param[in] max_sigmas the tolerance, in standard deviations of depth
   */
  void
  assignPixels (const OrganizedPoints& points,
                const std::vector<std::uint8_t>& selected,
                const PlaneSamples& samples,
                const std::vector<Plane>& planes,
                const DepthNoise& noise,
                float max_sigmas);

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

  /** \brief After all points were assigned, sums over those of each plane, with weights of
   * 1. */
  const std::vector<PlaneMoments>&
  moments () const
  {
    return moments_;
  }

  /** \brief The same, weighted as PlaneMoments says, with the same weight for all points
   * of a plane in a tile; after samples alone were assigned, sums over these. */
  const std::vector<PlaneMoments>&
  weightedMoments () const
  {
    return weighted_moments_;
  }

  /** \brief After samples were assigned, the share of the normals of a plane's samples,
   * trusted or not, that are as near to its own as on most points of a flat surface. */
  double
  nearNormals (std::size_t plane) const
  {
    const Normals& normals = normals_[plane];
    return normals.known > 0 ? static_cast<double> (normals.near) /
                                   static_cast<double> (normals.known)
                             : 1.;
  }

private:
  /** How many samples of a plane have a normal, and one near its own. */
  struct Normals {
    std::size_t known = 0, near = 0;
  };

  /** The pixels of a tile, row by row: their places from the first one of the tile on,
   * and in which samples' cells they lie. */
  struct TilePixels {
    int width = 0, height = 0;
    std::vector<std::int32_t> offsets, samples;
  };

  static constexpr std::size_t min_samples_in_tile = 4;

  void
  findPresentPlanes (std::size_t tiles, const std::vector<TilePart>& parts);

  void
  findCandidates (const PlaneSamples& samples,
                  const std::vector<std::int32_t>& owners,
                  std::size_t tile);

  bool
  findUnclear (const PointBlock& points, std::size_t tile, const DepthNoise& tolerance);

  void
  layOutTiles (const PlaneSamples& samples, const OrganizedPoints& points);

  void
  loadTile (const OrganizedPoints& points,
            const std::vector<std::uint8_t>& selected,
            const TilePixels& pixels,
            std::size_t first);

  void
  compareNormals (const PlaneSamples& samples, std::size_t tile, float scatter);

  void
  setEquations (const std::vector<Plane>& planes);

  TilePlanes
  planesOf (std::size_t tile) const
  {
    return {candidates_.data() + first_candidate_[tile],
            candidates_.data() + first_candidate_[tile + 1]};
  }

  void
  splitTile (const PointBlock& points, std::size_t tile, const DepthNoise& tolerance);

  void
  assignTile (const PointBlock& points,
              const std::int32_t* samples_of_points,
              std::size_t tile,
              const DepthNoise& tolerance);

  void
  sumSamples (const PlaneSamples& samples,
              std::size_t tile,
              std::vector<PlaneMoments>& moments) const;

  void
  sumPixels (const PointBlock& points,
             const TilePixels& pixels,
             const PlaneSamples& samples,
             std::size_t tile,
             const DepthNoise& noise,
             const DepthNoise& foot);

  bool
  leaveFeet (const PointBlock& points,
             const TilePixels& pixels,
             const PlaneSamples& samples,
             std::size_t tile,
             const TilePlane& plane,
             const DepthNoise& foot);

  /** Planes with enough samples in each tile: present_[first_present_[t] ...
   * first_present_[t + 1]); candidates likewise. */
  std::vector<std::uint32_t> present_;
  std::vector<TilePlane> candidates_;
  std::vector<std::size_t> first_present_, first_candidate_;
  /** Not 0 for tiles of which all samples belong to one plane. */
  std::vector<std::uint8_t> is_inner_;
  /** Of tiles inside of the image, and at its right, its lower, and both borders. */
  std::array<TilePixels, 4> layouts_;
  int image_width_ = 0, image_height_ = 0;
  std::vector<PlaneEquation> equations_;
  /** The points of a tile, and their labels. */
  std::vector<float> x_, y_, z_, ones_;
  std::vector<std::uint32_t> tile_labels_, sample_labels_;
  std::vector<std::uint32_t> labels_;
  std::vector<PlaneMoments> moments_, weighted_moments_;
  std::vector<PlaneMoments> unclear_moments_;
  std::vector<Normals> normals_;
  PlaneIntersections intersections_;
};

} // namespace rgbd_planes
} // namespace pcl
