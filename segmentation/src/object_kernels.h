// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "plane_kernels.h"

#include <pcl/segmentation/concave_split.h>
#include <pcl/segmentation/object_parameters.h>
#include <pcl/segmentation/point_row.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** Added to the place of a point that is over the octagon in the outline of its plane, and
 * under no plane before. */
constexpr std::uint8_t surely_above = 128;

/** For each measured point, the first of \a planes to which it is no further than the
 * largest height of an object, and over whose outline's bounds it lies if it does not lie on
 * the plane.
 * \param[in] v the number of the row in the image, for the warp of the planes
 * \param[out] places 0 where the point is on that plane within noise, 1 where there is no
 * such plane, 2 + k where it is above the plane number k, \ref surely_above
 * more where that is certain
 * \param[out] has_above whether there is a point above a plane, for each block of the row
 */
void
placeRow (const PointRow& row,
          int v,
          const std::vector<const SupportPlane*>& planes,
          const ObjectParameters& parameters,
          std::uint8_t* places,
          std::uint8_t* has_above);

/** Cuts points of clusters where, of two points of the cluster on opposite sides, one lies
 * above the tangent plane of the other.
 * \param[in] pixel_angle the angle between the rays of neighbouring pixels, radians
 * \param[out] cut whether each point of the image is cut, where it has an owner
 */
void
markCuts (const ClusterImage& image,
          float pixel_angle,
          const DepthNoise& noise,
          std::vector<std::uint8_t>& cut);

} // namespace rgbd_planes
} // namespace pcl
