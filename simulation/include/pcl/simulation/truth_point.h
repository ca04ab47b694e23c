// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>

#include <cstdint>

namespace pcl {
namespace rgbd_planes {

/** \brief What a pixel of a simulated frame truly sees, in the camera optical frame,
 * metres.
 *
 * Coordinates and normal are NaN where the pixel sees nothing; the normal has unit
 * length and faces the camera.
 */
struct EIGEN_ALIGN16 TruthPoint {
  PCL_ADD_POINT4D
  PCL_ADD_NORMAL4D
  /** The plane, 0 for none; coplanar surfaces share one. */
  std::uint32_t label = 0;
  /** The loose thing the point belongs to, 0 for furniture and the building. */
  std::uint32_t object = 0;
  /** 1 for everything that is not the floor a robot may drive on, else 0. */
  std::uint32_t obstacle = 0;
  /** 1 where a pixel at most 5 rows and columns away lies on another surface, so that a depth
   * edge or a crease is between them, else 0.
   */
  std::uint32_t edge = 0;

  TruthPoint() : data{0.f, 0.f, 0.f, 1.f}, data_n{0.f, 0.f, 0.f, 0.f} {}
};

} // namespace rgbd_planes
} // namespace pcl

POINT_CLOUD_REGISTER_POINT_STRUCT (
    pcl::rgbd_planes::TruthPoint,
    (float, x, x) (float, y, y) (float, z, z) (float, normal_x, normal_x) (
        float, normal_y, normal_y) (float, normal_z, normal_z) (
        std::uint32_t, label, label) (std::uint32_t, object, object) (
        std::uint32_t, obstacle, obstacle) (std::uint32_t, edge, edge))
