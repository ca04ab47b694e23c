// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/point_cloud.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Every step-th column of every step-th row of an organized cloud, the first
 * ones included: from VGA, 1 gives VGA, 2 QVGA and 4 QQVGA.
 *
 * A step of 0 throws std::invalid_argument.
 */
template <typename PointT>
pcl::PointCloud<PointT>
subsample (const pcl::PointCloud<PointT>& cloud, std::uint32_t step)
{
  if (step == 0)
    throw std::invalid_argument ("subsample: the step must be at least 1");
  const auto numberOf = [step] (std::uint32_t n) { return n / step + (n % step != 0); };
  pcl::PointCloud<PointT> result (numberOf (cloud.width), numberOf (cloud.height));
  result.header = cloud.header;
  result.is_dense = cloud.is_dense;
  result.sensor_origin_ = cloud.sensor_origin_;
  result.sensor_orientation_ = cloud.sensor_orientation_;
  for (std::uint32_t v = 0; v < result.height; ++v)
    for (std::uint32_t u = 0; u < result.width; ++u)
      result (u, v) = cloud (u * step, v * step);
  return result;
}

/** \brief The same of one value for each pixel of an image with so many columns, of which there
 * must be at least 1. */
template <typename T>
std::vector<T>
subsample (const std::vector<T>& values, std::uint32_t width, std::uint32_t step)
{
  if (width == 0 || step == 0)
    throw std::invalid_argument ("subsample: columns and step must be at least 1");
  std::vector<T> result;
  for (std::size_t row = 0; row < values.size(); row += std::size_t{width} * step)
    for (std::size_t u = 0; u < width; u += step)
      result.push_back (values[row + u]);
  return result;
}

} // namespace rgbd_planes
} // namespace pcl
