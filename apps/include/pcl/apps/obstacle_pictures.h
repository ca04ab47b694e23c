// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_segmenter.h>
#include <pcl/apps/pictures.h>

#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief What a robot may drive on: the floor is green, obstacles are red to yellow and
 * drop-offs blue to violet, each in a shade of its own, specks are white, and what is not
 * measured is black.
 * \param[in] classes one for each pixel
 */
Picture
obstaclesPicture (const pcl::PointCloud<pcl::PointXYZRGB>& cloud,
                  const std::vector<ObstacleClass>& classes,
                  const std::vector<ObstacleSummary>& obstacles);

} // namespace rgbd_planes
} // namespace pcl
