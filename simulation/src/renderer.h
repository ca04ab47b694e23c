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

/** \brief The direction that (u, v) looks along, with z = 1; pixel centres are at whole
 * numbers. */
inline Eigen::Vector3f
rayThrough (const Camera& camera, float u, float v)
{
  return {(u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.f};
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
  /** Something hides it from one of the other eyes of the sensor. */
  bool in_shadow = false;
};

/** \brief Whether a pixel sees a surface, as all eyes of the sensor do, at an incidence of no
 * more than 82 degrees. */
inline bool
isInView (const RenderedPixel& pixel)
{
  constexpr float min_cosine = 0.14f;
  return pixel.surface != RenderedPixel::no_surface && !pixel.in_shadow &&
         -pixel.normal.dot (pixel.point.normalized()) >= min_cosine;
}

/** \brief Renders a scene row by row.
 * \param[in] eyes where else the sensor looks from or sends light from, in the camera
 * frame
 */
std::vector<RenderedPixel>
render (const Scene& scene,
        const Camera& camera,
        const std::vector<Eigen::Vector3f>& eyes);

} // namespace rgbd_planes
} // namespace pcl
