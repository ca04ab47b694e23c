// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <cstddef>

namespace pcl {
namespace rgbd_planes {

/** So many values are found. */
constexpr std::size_t trim_groups = 8;

/** Finds the \ref trim_groups lowest of \a values times \a sign, or all if there are fewer, and
 * some more.
 * \param[out] low these, in the order of the values; has room for all
 * \return their number
 */
std::size_t
findLow (const float* values, std::size_t size, float sign, float* low);

} // namespace rgbd_planes
} // namespace pcl
