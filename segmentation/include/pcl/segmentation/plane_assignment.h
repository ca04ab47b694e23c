// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/plane_moments.h>
#include <pcl/segmentation/point_use.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The label of points that lie on no plane. */
constexpr std::uint32_t unlabelled = std::numeric_limits<std::uint32_t>::max();

/** \brief Gives each point one of the planes that are present around it in the image.
 *
 * A point lies on a plane when its distance is at most \a max_sigmas standard
 * deviations of depth at its range and, where its normal is trusted, the normals differ
 * by less than 35 degrees. A plane is present in a tile of 16 x 16 pixels, and so in
 * the eight tiles around it, when at least eight points of the tile carry its label.
 */
class PCL_RGBD_PLANES_EXPORTS PlaneAssignment {
public:
  /** \brief Which of several planes a point gets: the first one, or the nearest one in
   * standard deviations. */
  enum class Preference { first, nearest };

  /** \brief Replaces \a labels, the plane of each point or \ref unlabelled.
   * \param[in] use bits of \ref PointUse for each point
   */
  void
  assign (const OrganizedPoints& points,
          const OrganizedNormals& normals,
          const std::vector<std::uint8_t>& use,
          const std::vector<Plane>& planes,
          const DepthNoise& noise,
          float max_sigmas,
          Preference preference,
          std::vector<std::uint32_t>& labels);

private:
  void
  findPresentPlanes (int width,
                     int height,
                     std::size_t planes,
                     const std::vector<std::uint32_t>& labels);

  int tiles_u_ = 0;
  int tiles_v_ = 0;
  /** Points of each plane in each tile. */
  std::vector<std::uint16_t> counts_;
  /** The planes present around tile t: present_[present_begin_[t] ... [t + 1]). */
  std::vector<std::uint32_t> present_;
  std::vector<std::size_t> present_begin_;
};

} // namespace rgbd_planes
} // namespace pcl
