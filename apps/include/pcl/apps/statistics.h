// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <algorithm>
#include <limits>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The median, the upper one of an even number of values; NaN where there are
 * none. */
inline double
median (std::vector<double> values)
{
  if (values.empty())
    return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t> (values.size() / 2);
  std::nth_element (values.begin(), middle, values.end());
  return *middle;
}

} // namespace rgbd_planes
} // namespace pcl
