// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <Eigen/Core>

namespace pcl {
namespace rgbd_planes {

/** More than 0 where \a b is to the left of \a a. */
inline float
cross (const Eigen::Vector2f& a, const Eigen::Vector2f& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** By 90 degrees, from x to y. */
inline Eigen::Vector2f
turned (const Eigen::Vector2f& a)
{
  return {-a.y(), a.x()};
}

} // namespace rgbd_planes
} // namespace pcl
