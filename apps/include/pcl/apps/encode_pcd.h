// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>

#include <sstream>
#include <stdexcept>
#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief The bytes of a compressed PCD file. */
template <typename PointT>
std::string
encodePcd (const pcl::PointCloud<PointT>& cloud)
{
  pcl::PCLPointCloud2 blob;
  pcl::toPCLPointCloud2 (cloud, blob);
  std::ostringstream stream;
  if (pcl::PCDWriter().writeBinaryCompressed (
          stream, blob, cloud.sensor_origin_, cloud.sensor_orientation_) < 0)
    throw std::runtime_error ("cannot encode a cloud");
  return stream.str();
}

} // namespace rgbd_planes
} // namespace pcl
