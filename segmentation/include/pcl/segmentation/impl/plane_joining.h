// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/impl/plane_moments.h>
#include <pcl/segmentation/impl/tile_parts.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Moments with what joining needs of them again and again. */
struct FittedMoments {
  explicit FittedMoments (const PlaneMoments& of);

  PlaneMoments moments;
  Eigen::Matrix3d inverse_of_second;
  Eigen::Vector3d plane; // its inverse distance
  double squared_error;  // of the points, in the mean
};

/** \brief Joins parts that lie on one plane: its unconnected parts (Holz et al. 2011,
 * section 4.1), and those that were grown apart.
 *
 * One plane must explain the points of two parts almost as well as one for each, and the
 * plane of the larger part must not miss the smaller one, where that plane is known well
 * enough to tell: tops of boxes far from each other stay planes of their own. It may miss it
 * by more where the error of depth bends a wall, but not as a step does: the planes of both
 * sides of a step see each other on opposite sides, where the smaller one is known well enough.
 * A part joins the one larger than itself that it fits best, and so do the planes of what was
 * joined, until none fits any more.
 */
class PCL_RGBD_PLANES_EXPORTS PlaneJoining {
public:
  /** \brief Joins \a parts, or leaves each a plane of its own. */
  void
  compute (const std::vector<PlaneMoments>& parts, bool join);

  /** \brief Joins parts whose samples alternate in the image, as no two surfaces do but as
   * noise has it that is larger than the model says; where errors are that large, a few that
   * alternate are enough.
   * \param[in] tile_parts what each part owns in each tile, tile after tile
   */
  void
  computeAlternating (const std::vector<PlaneMoments>& parts,
                      const std::vector<TilePart>& tile_parts);

  /** \brief Joins parts once more when the sides of steps are known, but those not with each
   * other: before, a plane across the step missed other parts of its planes.
   * \param[in] are_sides for each part whether it is one
   */
  void
  computeSides (const std::vector<PlaneMoments>& parts,
                const std::vector<bool>& are_sides);

  /** \brief Joins strips, such as the front sides of two legs of a table, that lie apart:
   * how they are turned about their long sides is not known well enough to tell whether the
   * plane of one meets the other. */
  void
  computeStrips (const std::vector<PlaneMoments>& parts);

  /** \brief The planes. */
  const std::vector<PlaneMoments>&
  planes () const
  {
    return planes_;
  }

  /** \brief The plane that a part belongs to. */
  const std::vector<std::int32_t>&
  planeOfPart () const
  {
    return plane_of_part_;
  }

private:
  /** How many samples of a part lie between two of another one, in a tile. */
  struct Between {
    std::size_t part = 0, of = 0, in_row = 0, in_column = 0;
  };

  static bool
  byPart (const Between& a, const Between& b)
  {
    return a.part < b.part;
  }

  void
  findBetween (const std::vector<TilePart>& tile_parts);

  /** \brief Joins parts where \a mismatch (plane, part) is 0 for a perfect match, up to 1. */
  template <typename Mismatch>
  void
  join (const std::vector<PlaneMoments>& parts, const Mismatch& mismatch);

  std::vector<std::size_t> order_;
  std::vector<FittedMoments> fitted_parts_, fitted_planes_;
  std::vector<PlaneMoments> planes_;
  std::vector<std::int32_t> plane_of_part_;
  /** What was joined before. */
  std::vector<PlaneMoments> joined_;
  std::vector<std::int32_t> joined_of_part_;
  /** Of parts that may be strips. */
  std::vector<double> widths_;
  std::vector<Between> between_;
};

} // namespace rgbd_planes
} // namespace pcl
