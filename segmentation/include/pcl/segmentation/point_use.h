// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <cstdint>

namespace pcl {
namespace rgbd_planes {

/** \brief What is known of a point: bits of an std::uint8_t. */
enum PointUse : std::uint8_t {
  measured = 1,      /**< asked for, and with a valid position */
  clustered = 2,     /**< with a valid normal, and not on a crease */
  trusted_normal = 4 /**< with a valid normal on a surface that is flat */
};

} // namespace rgbd_planes
} // namespace pcl
