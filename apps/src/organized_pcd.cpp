// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/organized_pcd.h>
#include <pcl/apps/pcd_file.h>
#include <pcl/apps/point_labels.h>
#include <pcl/features/impl/organized_view.h>

#include <cstring>
#include <limits>

namespace pcl {
namespace rgbd_planes {

pcl::PointCloud<pcl::PointXYZRGB>::Ptr
readOrganizedPcd (const std::string& file, PointLabels* labels)
{
  const PcdFile pcd = readPcdFile (file, {"x", "y", "z"});
  const pcl::PCLPointCloud2& blob = pcd.cloud;
  if (!pcd.origin.head<3>().isZero (0.f))
    throw AppError (file +
                    ": its VIEWPOINT has the sensor elsewhere than at 0 0 0, so the "
                    "cloud is in another frame; give the cloud in the frame of "
                    "the camera, or set VIEWPOINT to 0 0 0 1 0 0 0 if it is");
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>>();
  cloud->sensor_origin_ = pcd.origin;
  cloud->sensor_orientation_ = pcd.orientation;
  const std::size_t offsets[] = {findField (blob, "x")->offset,
                                 findField (blob, "y")->offset,
                                 findField (blob, "z")->offset};
  const auto* rgba = findField (blob, "rgba");
  const auto* colour = rgba ? rgba : findField (blob, "rgb");
  cloud->resize (blob.width, blob.height);
  cloud->is_dense = false;
  const std::uint8_t* data = blob.data.data();
  for (auto& point : *cloud) {
    for (int i = 0; i < 3; ++i)
      std::memcpy (&point.data[i], data + offsets[i], sizeof (float));
    if (!isMeasured (point.data))
      point.x = point.y = point.z = std::numeric_limits<float>::quiet_NaN();
    if (colour)
      std::memcpy (&point.rgba, data + colour->offset, sizeof (point.rgba));
    data += blob.point_step;
  }
  if (labels)
    *labels = readPointLabels (blob, *cloud);
  return cloud;
}

pcl::PointCloud<pcl::Intensity>
readIntensityPcd (const std::string& file)
{
  const PcdFile pcd = readPcdFile (file, {"intensity"});
  pcl::PointCloud<pcl::Intensity> cloud (pcd.cloud.width, pcd.cloud.height);
  const std::uint8_t* data =
      pcd.cloud.data.data() + findField (pcd.cloud, "intensity")->offset;
  for (auto& point : cloud) {
    std::memcpy (&point.intensity, data, sizeof (point.intensity));
    data += pcd.cloud.point_step;
  }
  return cloud;
}

} // namespace rgbd_planes
} // namespace pcl
