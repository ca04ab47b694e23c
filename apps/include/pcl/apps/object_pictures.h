// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_segmenter.h>
#include <pcl/apps/pictures.h>

#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Objects in colours on grey depth, with their boxes in white where they are graspable
 * and in red where not, and the hulls of the planes under them in the colours of
 * planesPicture(). */
Picture
objectsPicture (const pcl::PointCloud<pcl::PointXYZRGB>& cloud,
                const std::vector<ObjectSummary>& objects,
                const std::vector<pcl::SupportPlane>& supports);

} // namespace rgbd_planes
} // namespace pcl
