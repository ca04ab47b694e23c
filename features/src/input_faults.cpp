// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/console/print.h>
#include <pcl/features/impl/input_faults.h>

#include <algorithm>
#include <limits>
#include <type_traits>

namespace pcl {
namespace rgbd_planes {

bool
isFault (const char* where, const std::string& fault)
{
  if (!fault.empty())
    PCL_ERROR ("[pcl::%s] %s\n", where, fault.c_str());
  return !fault.empty();
}

std::string
faultOfImage (std::size_t size, std::uint32_t width, std::uint32_t height)
{
  if (height > 1 && size != 0 && size == std::size_t{width} * height)
    return {};
  return "The input cloud has " + std::to_string (size) + " points, width " +
         std::to_string (width) + " and height " + std::to_string (height) +
         ", but must be organized (an image of points): ask your camera driver for "
         "ordered point clouds, and keep NaN points, as filters do after "
         "setKeepOrganized (true), for without them there is no image.";
}

std::string
faultOfOrigin (const Eigen::Vector4f& sensor_origin)
{
  if (sensor_origin.head<3>().allFinite())
    return {};
  return "The sensor_origin_ of the input cloud is not finite: set it to where the "
         "camera was, (0, 0, 0) in the frame of the camera.";
}

bool
indicesInside (const pcl::Indices& indices, std::size_t size)
{
  if (indices.empty() || size == 0)
    return indices.empty();
  // To the end, whatever comes, which takes vector instructions. The highest bit is set in
  // numbers below 0, and in what is left to the last index from one beyond.
  using Number = std::make_unsigned_t<pcl::index_t>;
  constexpr Number highest = std::numeric_limits<Number>::max() / 2;
  const auto last = static_cast<Number> (std::min<std::size_t> (size - 1, highest));
  Number bits = 0;
  for (const pcl::index_t index : indices)
    bits |= static_cast<Number> (index) | (last - static_cast<Number> (index));
  return bits <= highest;
}

std::string
faultOfIndices (const pcl::Indices* indices, std::size_t size)
{
  if (!indices || indicesInside (*indices, size))
    return {};
  return "An index lies outside of the input cloud: give indices from 0 to less than " +
         std::to_string (size) + ".";
}

} // namespace rgbd_planes
} // namespace pcl
