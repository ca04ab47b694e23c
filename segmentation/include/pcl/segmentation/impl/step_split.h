// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/impl/plane_moments.h>
#include <pcl/segmentation/impl/plane_samples.h>
#include <pcl/segmentation/impl/step_finder.h>
#include <pcl/segmentation/impl/tile_parts.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Parts planes at steps, such as the edge of a table top from the legs a few
 * millimetres behind it.
 *
 * A tilted plane between them lies within noise of both, as one plane lies within noise
 * of a warped wall.
 */
class PCL_RGBD_PLANES_EXPORTS StepSplit {
public:
  /** \brief Takes the smaller side of a step from its plane, and of up to three steps from a
   * plane that fills much of the image. It goes to the other plane that it lies on, or becomes
   * a new one, last in the list. Small planes that lie on what is left of the plane join it, and
   * stay in the list without samples.
   * \param[in] min_side the least number of samples on either side
   * \param[in] max_sigmas how far from its plane a point may lie, in standard deviations
   * \param[in,out] owners the plane of each sample, less than 0 for none
   * \param[in,out] parts what each plane owns in each tile
   * \param[in,out] planes sums over the samples of each plane
   */
  void
  compute (const PlaneSamples& samples,
           std::size_t min_side,
           float max_sigmas,
           std::vector<std::int32_t>& owners,
           std::vector<TilePart>& parts,
           std::vector<PlaneMoments>& planes);

  /** \brief For each plane whether it is the side of a step. */
  const std::vector<bool>&
  areSides () const
  {
    return are_sides_;
  }

private:
  struct Limits {
    double min_error; /**< of planes with steps */
    double max_left;  /**< what a step leaves of it */
    int max_steps;    /**< of one plane */
  };

  bool
  splitOnce (const PlaneSamples& samples,
             std::size_t k,
             std::size_t min_side,
             const Limits& limits,
             float unit,
             std::vector<std::int32_t>& owners,
             std::vector<TilePart>& parts,
             std::vector<PlaneMoments>& planes);

  void
  collect (const PlaneSamples& samples,
           const std::vector<TilePart>& parts,
           std::uint32_t plane,
           const Eigen::Vector3d& m,
           float unit);

  std::vector<bool> are_sides_;
  StepFinder finder_;
  std::vector<SampleError> errors_;
};

} // namespace rgbd_planes
} // namespace pcl
