// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "scene.h"

#include <pcl/simulation/simulate.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The direction that the centre of pixel (u, v) looks along, with z = 1. */
inline Eigen::Vector3f
rayThrough (const Camera& camera, int u, int v)
{
  return {(static_cast<float> (u) - camera.cx) / camera.fx,
          (static_cast<float> (v) - camera.cy) / camera.fy,
          1.f};
}

/** \brief What the centre of a pixel sees, in the camera frame. */
struct RenderedPixel {
  static constexpr std::uint32_t no_surface = std::numeric_limits<std::uint32_t>::max();
  /** Index into Scene::surfaces. */
  std::uint32_t surface = no_surface;
  Eigen::Vector3f point =
      Eigen::Vector3f::Constant (std::numeric_limits<float>::quiet_NaN());
  /** Unit length, towards the camera. */
  Eigen::Vector3f normal = point;
  /** Red, green, blue of the surface, 0 to 1, without light. */
  Eigen::Vector3f color = Eigen::Vector3f::Zero();
  /** Something hides it from the projector. */
  bool in_shadow = false;
};

/** \brief Renders a scene row by row.
 * \param[in] projector where the projector is in the camera frame, in metres
 */
std::vector<RenderedPixel>
render (const Scene& scene, const Camera& camera, const Eigen::Vector3f& projector);

} // namespace rgbd_planes
} // namespace pcl
