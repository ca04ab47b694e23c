// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/labelled_point.h>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>

#include <sstream>
#include <stdexcept>

namespace pcl {
namespace rgbd_planes {

std::string
encodeLabels (const pcl::PointCloud<pcl::PointXYZRGB>& cloud,
              const pcl::PointCloud<pcl::Normal>& normals,
              const pcl::PointCloud<pcl::Label>& labels)
{
  pcl::PointCloud<LabelledPoint> labelled (cloud.width, cloud.height);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    labelled[i].getVector3fMap() = cloud[i].getVector3fMap();
    labelled[i].getNormalVector3fMap() = normals[i].getNormalVector3fMap();
    labelled[i].label = labels[i].label;
  }
  pcl::PCLPointCloud2 blob;
  pcl::toPCLPointCloud2 (labelled, blob);
  std::ostringstream stream;
  if (pcl::PCDWriter().writeBinaryCompressed (
          stream, blob, cloud.sensor_origin_, cloud.sensor_orientation_) < 0)
    throw std::runtime_error ("cannot encode the labelled cloud");
  return stream.str();
}

} // namespace rgbd_planes
} // namespace pcl
