// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/point_types.h>
#include <pcl/segmentation/support_plane.h>
#include <pcl/segmentation/supported_object.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief A line from each point to the next one, in the frame of the cloud, metres. */
struct ColouredLine {
  pcl::RGB colour;
  std::vector<Eigen::Vector3f> points;
};

/** \brief The edges of the box of an object: white, or red where it is not graspable. */
std::vector<ColouredLine>
boxLines (const pcl::SupportedObject& object);

/** \brief The closed hull of a plane that things stand on; no points where it has none. */
ColouredLine
hullLine (const pcl::SupportPlane& support, const pcl::RGB& colour);

} // namespace rgbd_planes
} // namespace pcl
