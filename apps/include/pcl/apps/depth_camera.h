// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/depth_image.h>

#include <filesystem>
#include <memory>

namespace pcl {
namespace rgbd_planes {

/** \brief What took the depth images of an input. */
struct DepthCamera {
  Intrinsics intrinsics;
  float units_per_metre;
  /** The intrinsics are a guess that holds for 640 x 480 only. */
  bool guessed;
  /** Whether it was told that they seem to be those of other images. */
  std::shared_ptr<bool> doubt_is_told;
};

/** \brief The cloud of a depth image, as toCloud() makes it. AppError where the image cannot be
 * read or is not of this camera. */
pcl::PointCloud<pcl::PointXYZRGB>::Ptr
readDepthImage (const std::filesystem::path& file, const DepthCamera& camera);

} // namespace rgbd_planes
} // namespace pcl
