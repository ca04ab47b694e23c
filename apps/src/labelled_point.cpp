// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/encode_pcd.h>
#include <pcl/apps/labelled_point.h>

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
  labelled.sensor_origin_ = cloud.sensor_origin_;
  labelled.sensor_orientation_ = cloud.sensor_orientation_;
  return encodePcd (labelled);
}

} // namespace rgbd_planes
} // namespace pcl
