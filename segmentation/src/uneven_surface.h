// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/impl/plane_moments.h>

namespace pcl {
namespace rgbd_planes {

/** \brief Whether a plane lies in an uneven surface, such as clothes.
 * \param[in] points those of the plane, weighted
 * \param[in] error the mean of the squares of their distances, in standard deviations
 * \param[in] near_normals the share of their normals that are near that of the plane
 * \param[in] min_near_normals what flat surfaces of the size of clothes have of them
 */
bool
isUneven (const PlaneMoments& points,
          double error,
          double near_normals,
          double min_near_normals);

} // namespace rgbd_planes
} // namespace pcl
