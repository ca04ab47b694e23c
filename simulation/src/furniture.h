// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "random.h"
#include "scene.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Colours; the first one is too dark for infrared cameras. */
inline const Eigen::Vector3f dark (0.03f, 0.03f, 0.03f);
inline const Eigen::Vector3f steel (0.60f, 0.64f, 0.66f);

/** \brief A saturated colour. */
Eigen::Vector3f
strongColor (Random& random);

/** \brief A part of the surfaces \a first and later has another colour. */
void
paint (Scene& scene,
       std::size_t first,
       const Eigen::Vector3f& center,
       const Eigen::Vector3f& size,
       const Eigen::Vector3f& color);

/** \brief A place in metres and a turn around the vertical axis in radians. */
struct Placement {
  float x, y, z, yaw;
};

Eigen::Affine3f
poseAt (const Placement& placement);

/** \brief Floor, ceiling and four walls. */
struct Room {
  Eigen::Vector3f low;
  Eigen::Vector3f high;
};

/** \brief Adds a room; only its floor is no obstacle. */
void
addRoom (Scene& scene, const Room& room);

/** \brief A table with four legs, its centre at the origin of \a pose, its top size.z
 * above. Returns the pose of the centre of its top. */
Eigen::Affine3f
addTable (Scene& scene, const Eigen::Affine3f& pose, const Eigen::Vector3f& size);

/** \brief Circles that do not overlap. */
class FreeSpace {
public:
  /** \brief Draws centres until a circle of this radius is free there, and takes it. */
  Eigen::Vector2f
  take (float radius, const std::function<Eigen::Vector2f()>& draw_center);

private:
  struct Circle {
    Eigen::Vector2f center;
    float radius;
  };

  bool
  isFree (const Circle& circle) const;

  std::vector<Circle> taken_;
};

/** \brief Puts 65 objects on the xy plane of \a pose, within \a size around its origin:
 * boxes, cylinders and spheres of 2 to 25 cm, flat ones of 1 cm, pairs that touch. */
void
addClutter (Scene& scene,
            const Eigen::Affine3f& pose,
            const Eigen::Vector2f& size,
            Random& random);

} // namespace rgbd_planes
} // namespace pcl
