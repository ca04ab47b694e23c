// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/depth_camera.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {
namespace rgbd_planes {

pcl::PointCloud<pcl::PointXYZRGB>::Ptr
readDepthImage (const std::filesystem::path& file, const DepthCamera& camera)
{
  const DepthImage image = readDepthPng (file);
  const std::string size = file.string() + ": has " + std::to_string (image.width) +
                           " x " + std::to_string (image.height) + " pixels, ";
  if (camera.guessed && (image.width != 640 || image.height != 480))
    throw AppError (size +
                    "for which no camera is known: add --intrinsics fx,fy,cx,cy");
  const auto& [fx, fy, cx, cy] = camera.intrinsics;
  // How far the principal point is from the middle, in sizes of the image.
  const auto distance = [] (float center, std::uint32_t pixels) {
    return std::fabs ((center + 0.5f) / static_cast<float> (pixels) - 0.5f);
  };
  const float off = std::max (distance (cx, image.width), distance (cy, image.height));
  if (off > 1.f)
    throw AppError (size +
                    "far from which the principal point of --intrinsics is: give "
                    "fx,fy,cx,cy of these images");
  if (off > 0.2f && !std::exchange (*camera.doubt_is_told, true))
    printNotice (size +
                 "far from whose middle the principal point of --intrinsics is: give "
                 "fx,fy,cx,cy of these images in full, unless they are parts of larger "
                 "ones");
  return toCloud (image, camera.intrinsics, camera.units_per_metre);
}

} // namespace rgbd_planes
} // namespace pcl
