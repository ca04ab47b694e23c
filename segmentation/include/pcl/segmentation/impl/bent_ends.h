// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/impl/plane_moments.h>
#include <pcl/segmentation/impl/plane_samples.h>
#include <pcl/segmentation/impl/tile_parts.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Finds the parts that are ends of a much larger plane, where the camera bends that by
 * more than planes grow over, most of all in the corners of the image.
 *
 * Such a part lies between its plane and the border of the image, or pixels without depth, is
 * next to hardly anything else, and passes into it without a large step.
 */
class PCL_RGBD_PLANES_EXPORTS BentEnds {
public:
  /** \param[in] owners the part of each sample, or less than 0
   * \param[in] tile_parts what each part owns in each tile
   * \param[in] parts planes that are not joined any more
   */
  void
  find (const PlaneSamples& samples,
        const std::vector<std::int32_t>& owners,
        const std::vector<TilePart>& tile_parts,
        const std::vector<PlaneMoments>& parts);

  /** \brief The parts that are no ends. */
  const std::vector<PlaneMoments>&
  planes () const
  {
    return planes_;
  }

  /** \brief For each part its plane, of which ends have no share in the fit. */
  const std::vector<std::int32_t>&
  planeOfPart () const
  {
    return plane_of_part_;
  }

private:
  /** \brief What is next to the samples of a part. */
  struct Surroundings {
    std::size_t all = 0;
    /** Not measured, or beyond the border of the image. */
    std::size_t outside = 0;
    std::size_t of_planes = 0;
    /** The plane that most of these are of, if one is. */
    std::int32_t plane = -1;
    int votes = 0;
    Eigen::Vector3d inverse_distance = Eigen::Vector3d::Zero(); // of that plane
    std::size_t of_plane = 0;
    /** How far the samples beside it are off that plane, in variances. */
    double squared_errors = 0.;
  };

  void
  lookAround (const PlaneSamples& samples,
              const std::vector<std::int32_t>& owners,
              const std::vector<TilePart>& tile_parts,
              const std::vector<PlaneMoments>& parts);

  void
  lookBeside (const PlaneSamples& samples,
              const std::vector<std::int32_t>& owners,
              std::size_t i);

  bool
  isEnd (std::size_t part, const std::vector<PlaneMoments>& parts) const;

  /** A sample of a small part, and the part that is next to it. */
  struct Meeting {
    std::size_t sample;
    std::int32_t beside;
  };

  std::vector<bool> is_small_;
  std::vector<Meeting> meetings_;
  std::vector<Surroundings> around_;
  std::vector<PlaneMoments> planes_;
  std::vector<std::int32_t> plane_of_part_;
};

} // namespace rgbd_planes
} // namespace pcl
