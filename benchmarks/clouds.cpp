// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "clouds.h"

#include <pcl/apps/app_error.h>
#include <pcl/apps/interruption.h>
#include <pcl/apps/measured_cloud.h>
#include <pcl/common/io.h>
#include <pcl/simulation/subsample.h>

#include <algorithm>

namespace pcl {
namespace rgbd_planes {

namespace {

/** At QQVGA, too, there must be enough for PCL. */
constexpr std::uint32_t min_pixels = 4 * min_pcl_pixels;

} // namespace

Clouds
readClouds (const std::vector<InputOptions>& inputs, BaseTransforms& camera_to_base)
{
  Clouds clouds;
  for (const auto& input : inputs) {
    const FrameSource source (input);
    for (std::size_t i = 0; i < source.size(); ++i) {
      stopIfInterrupted();
      const Frame frame = source.read (i);
      auto cloud = pcl::make_shared<Cloud>();
      pcl::copyPointCloud (*frame.cloud, *cloud);
      if (cloud->width < min_pixels || cloud->height < min_pixels)
        throw AppError (input.input + ": frame " + frame.name +
                        " is too small; give frames of 160 x 160 pixels or more");
      clouds.push_back (cloud);
      camera_to_base.push_back (frame.camera_to_base);
      if (cloud->width != clouds.front()->width ||
          cloud->height != clouds.front()->height)
        throw AppError (input.input + ": frame " + frame.name +
                        " differs in size from the first one; benchmark one size at a "
                        "time");
    }
  }
  return clouds;
}

Clouds
subsample (const Clouds& clouds, std::uint32_t step)
{
  Clouds result;
  for (const auto& cloud : clouds)
    result.push_back (pcl::make_shared<Cloud> (subsample (*cloud, step)));
  return result;
}

Cloud::ConstPtr
resample (const Cloud& cloud, std::uint32_t width, std::uint32_t height)
{
  auto result = pcl::make_shared<Cloud> (width, height);
  result->is_dense = cloud.is_dense;
  const float step_u = static_cast<float> (cloud.width - 1) / (width - 1);
  const float step_v = static_cast<float> (cloud.height - 1) / (height - 1);
  for (std::uint32_t v = 0; v < height; ++v)
    for (std::uint32_t u = 0; u < width; ++u) {
      const float x = step_u * u, y = step_v * v;
      const auto left = std::min (static_cast<std::uint32_t> (x), cloud.width - 2);
      const auto top = std::min (static_cast<std::uint32_t> (y), cloud.height - 2);
      const float right_part = x - left, lower_part = y - top;
      const auto between = [&] (std::uint32_t row) {
        return (1.f - right_part) * cloud (left, row).getVector3fMap() +
               right_part * cloud (left + 1, row).getVector3fMap();
      };
      (*result) (u, v).getVector3fMap() =
          (1.f - lower_part) * between (top) + lower_part * between (top + 1);
    }
  return result;
}

} // namespace rgbd_planes
} // namespace pcl
