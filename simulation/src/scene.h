// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/simulation/simulate.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The part of a surface inside \a region has another colour. */
struct Decal {
  Eigen::AlignedBox3f region;
  Eigen::Vector3f color;
};

struct Surface {
  enum class Shape { polygon, cylinder, sphere };
  Shape shape = Shape::polygon;
  /** Polygon: its corners, in one plane, convex. Cylinder: both ends of its axis.
   * Sphere: its centre. */
  std::vector<Eigen::Vector3f> points;
  float radius = 0.f;
  /** Red, green, blue, 0 to 1. */
  Eigen::Vector3f color = Eigen::Vector3f::Constant (0.7f);
  std::uint32_t object = 0;
  bool obstacle = true;
  std::vector<Decal> decals;
  /** Where this is a facet of a curved surface: the index of the first one. */
  std::optional<std::uint32_t> first_facet;
};

/** \brief Colour and object id of what is added to a scene. */
struct Look {
  Eigen::Vector3f color;
  std::uint32_t object = 0;
};

/** \brief A cup or a bowl; metres. */
struct Vessel {
  float bottom_radius;
  float top_radius;
  float height;
  float wall;
};

/** \brief A camera at \a eye that looks at \a target, turned clockwise by \a roll radians. */
struct View {
  Eigen::Vector3f eye;
  Eigen::Vector3f target;
  float roll;
};

/** \brief Surfaces in the base frame (x forward, y left, z up, the floor at z = 0,
 * metres) and where the camera is. */
struct Scene {
  Eigen::Affine3f camera_to_base = Eigen::Affine3f::Identity();
  std::vector<Surface> surfaces;
  /** What was added with an object id; poses are to the base frame. */
  std::vector<TrueObject> objects;

  void
  setCamera (const View& view);

  Surface&
  addPolygon (const std::vector<Eigen::Vector3f>& corners, const Look& look);

  /** \brief A box that stands on the xy plane of \a pose, centred above its origin. The face
   * it stands on is left out: rays along its rim could hit it instead of the floor. */
  void
  addBox (const Eigen::Affine3f& pose, const Eigen::Vector3f& size, const Look& look);

  /** \brief A cylinder that stands on the xy plane of \a pose, open there like a box. */
  void
  addCylinder (const Eigen::Affine3f& pose,
               float radius,
               float height,
               const Look& look);

  void
  addSphere (const Eigen::Vector3f& center, float radius, const Look& look);

  /** \brief A box without a lid that stands on the xy plane of \a pose. */
  void
  addOpenBox (const Eigen::Affine3f& pose,
              const Eigen::Vector3f& size,
              float wall,
              const Look& look);

  /** \brief A cup or a bowl that stands on the xy plane of \a pose. */
  void
  addVessel (const Eigen::Affine3f& pose, const Vessel& vessel, const Look& look);

private:
  /** \brief How large a hollow thing is, its bottom in parts of its top, and how thick its
   * walls and its bottom are; metres. */
  struct Hollow {
    Eigen::Vector3f size;
    float bottom;
    float wall;
    bool is_round;
  };

  /** \brief Walls along \a outline, which is convex, with corners from -0.5 to 0.5. */
  void
  addHollow (const Eigen::Affine3f& pose,
             const std::vector<Eigen::Vector2f>& outline,
             const Hollow& hollow,
             const Look& look);

  void
  addObject (const Look& look,
             TrueObject::Shape shape,
             const Eigen::Vector3f& size,
             const Eigen::Affine3f& pose);
};

} // namespace rgbd_planes
} // namespace pcl
