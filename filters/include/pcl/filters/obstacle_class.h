// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <cstdint>

namespace pcl {
namespace rgbd_planes {

/** \brief What ObstacleDetection says of a point: the labels of its output, and of the
 * input of ObstacleFilter. */
enum class ObstacleClass : std::uint8_t {
  unmeasured = 0, /**< no depth, beyond the range of the sensor, or not among indices */
  floor = 1,      /**< safe to drive on */
  obstacle = 2,   /**< part of an obstacle */
  drop_off = 3,   /**< below the floor: part of a step down or a hole */
  speck = 4,      /**< like an obstacle, but alone: an error of the sensor */
  excluded = 5    /**< part of the object that is to be grasped */
};

} // namespace rgbd_planes
} // namespace pcl
