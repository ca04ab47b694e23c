// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/point_cloud.h>
#include <pcl/types.h>

#include <cstddef>
#include <cstdint>

namespace pcl {
namespace rgbd_planes {

/** \brief The points of \a indices, in their order. PCL's copyPointCloud takes as many indices as
 * there are points for all points. */
template <typename PointT>
void
copyPoints (const pcl::PointCloud<PointT>& cloud,
            const pcl::Indices& indices,
            pcl::PointCloud<PointT>& points)
{
  points.header = cloud.header;
  points.is_dense = cloud.is_dense;
  points.sensor_origin_ = cloud.sensor_origin_;
  points.sensor_orientation_ = cloud.sensor_orientation_;
  points.resize (static_cast<std::uint32_t> (indices.size()), 1);
  for (std::size_t i = 0; i < indices.size(); ++i)
    points[i] = cloud[static_cast<std::size_t> (indices[i])];
}

} // namespace rgbd_planes
} // namespace pcl
