// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>

#include <cstdint>
#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief A point of `<frame>_labels.pcd`: coordinates in the camera frame in metres
 * and the normal, NaN where there is none; the id of the plane, or \ref unlabelled. */
struct EIGEN_ALIGN16 LabelledPoint {
  PCL_ADD_POINT4D
  PCL_ADD_NORMAL4D
  std::uint32_t label;
};

/** \brief The bytes of a compressed PCD file of LabelledPoint, organized as \a cloud.
 */
std::string
encodeLabels (const pcl::PointCloud<pcl::PointXYZRGB>& cloud,
              const pcl::PointCloud<pcl::Normal>& normals,
              const pcl::PointCloud<pcl::Label>& labels);

} // namespace rgbd_planes
} // namespace pcl

POINT_CLOUD_REGISTER_POINT_STRUCT (
    pcl::rgbd_planes::LabelledPoint,
    (float, x, x) (float, y, y) (float, z, z) (float, normal_x, normal_x) (
        float, normal_y, normal_y) (float, normal_z, normal_z) (std::uint32_t,
                                                                label,
                                                                label))
