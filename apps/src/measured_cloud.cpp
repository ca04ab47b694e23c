// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/input_options.h>
#include <pcl/apps/measured_cloud.h>
#include <pcl/common/io.h>
#include <pcl/simulation/subsample.h>

#include <string>

namespace pcl {
namespace rgbd_planes {

pcl::PointCloud<pcl::PointXYZ>::Ptr
measuredCloud (const Frame& frame, std::uint32_t step, std::uint32_t min_pixels)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  pcl::copyPointCloud (subsample (*frame.cloud, step), *cloud);
  if (cloud->width < min_pixels || cloud->height < min_pixels) {
    const std::string pixels = std::to_string (min_pixels);
    throw AppError (frame.name + ": is too small as " + resolutionName (step) + ", " +
                    pixels + " x " + pixels + " pixels are needed; use " +
                    (step == 1 ? "" : "--resolution vga or ") + "larger frames");
  }
  return cloud;
}

} // namespace rgbd_planes
} // namespace pcl
