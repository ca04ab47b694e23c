// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "scene.h"

#include <array>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr int disc_corners = 96;

/** Of diameter 1. */
std::vector<Eigen::Vector2f>
circle ()
{
  std::vector<Eigen::Vector2f> corners;
  for (int i = 0; i < disc_corners; ++i) {
    const float angle = 6.2831853f * static_cast<float> (i) / disc_corners;
    corners.emplace_back (0.5f * std::cos (angle), 0.5f * std::sin (angle));
  }
  return corners;
}

} // namespace

void
Scene::setCamera (const View& view)
{
  const Eigen::Vector3f forward = (view.target - view.eye).normalized();
  const Eigen::Vector3f right = forward.cross (Eigen::Vector3f::UnitZ()).normalized();
  Eigen::Matrix3f axes;
  axes << right, forward.cross (right), forward;
  camera_to_base = Eigen::Translation3f (view.eye) * axes *
                   Eigen::AngleAxisf (view.roll, Eigen::Vector3f::UnitZ());
}

Surface&
Scene::addPolygon (const std::vector<Eigen::Vector3f>& corners, const Look& look)
{
  Surface surface;
  surface.points = corners;
  surface.color = look.color;
  surface.object = look.object;
  surfaces.push_back (surface);
  return surfaces.back();
}

void
Scene::addBox (const Eigen::Affine3f& pose,
               const Eigen::Vector3f& size,
               const Look& look)
{
  addObject (look, TrueObject::Shape::box, size, pose);
  std::array<Eigen::Vector3f, 8> corner;
  for (std::size_t i = 0; i < corner.size(); ++i)
    corner[i] = pose * Eigen::Vector3f (((i & 1) != 0 ? 0.5f : -0.5f) * size.x(),
                                        ((i & 2) != 0 ? 0.5f : -0.5f) * size.y(),
                                        (i & 4) != 0 ? size.z() : 0.f);
  constexpr std::array<std::array<std::size_t, 4>, 5> faces{
      {{{4, 5, 7, 6}}, {{0, 1, 5, 4}}, {{2, 6, 7, 3}}, {{0, 4, 6, 2}}, {{1, 3, 7, 5}}}};
  for (const auto& face : faces)
    addPolygon ({corner[face[0]], corner[face[1]], corner[face[2]], corner[face[3]]},
                look);
}

void
Scene::addCylinder (const Eigen::Affine3f& pose,
                    float radius,
                    float height,
                    const Look& look)
{
  addObject (
      look, TrueObject::Shape::cylinder, {2.f * radius, 2.f * radius, height}, pose);
  std::vector<Eigen::Vector3f> rim;
  for (const auto& corner : circle())
    rim.push_back (pose * Eigen::Vector3f (2.f * radius * corner.x(),
                                           2.f * radius * corner.y(),
                                           height));
  addPolygon (rim, look);
  Surface& side = addPolygon ({pose * Eigen::Vector3f (0.f, 0.f, 0.f),
                               pose * Eigen::Vector3f (0.f, 0.f, height)},
                              look);
  side.shape = Surface::Shape::cylinder;
  side.radius = radius;
}

void
Scene::addSphere (const Eigen::Vector3f& center, float radius, const Look& look)
{
  addObject (look,
             TrueObject::Shape::sphere,
             Eigen::Vector3f::Constant (2.f * radius),
             Eigen::Affine3f (
                 Eigen::Translation3f (center - radius * Eigen::Vector3f::UnitZ())));
  Surface& surface = addPolygon ({center}, look);
  surface.shape = Surface::Shape::sphere;
  surface.radius = radius;
}

void
Scene::addOpenBox (const Eigen::Affine3f& pose,
                   const Eigen::Vector3f& size,
                   float wall,
                   const Look& look)
{
  addObject (look, TrueObject::Shape::box, size, pose);
  addHollow (pose,
             {{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}},
             {size, 1.f, wall, false},
             look);
}

void
Scene::addVessel (const Eigen::Affine3f& pose, const Vessel& vessel, const Look& look)
{
  const Eigen::Vector3f size (
      2.f * vessel.top_radius, 2.f * vessel.top_radius, vessel.height);
  addObject (look, TrueObject::Shape::cylinder, size, pose);
  addHollow (pose,
             circle(),
             {size, vessel.bottom_radius / vessel.top_radius, vessel.wall, true},
             look);
}

void
Scene::addHollow (const Eigen::Affine3f& pose,
                  const std::vector<Eigen::Vector2f>& outline,
                  const Hollow& hollow,
                  const Look& look)
{
  const auto ring = [&] (float scale, float wall, float z) {
    std::vector<Eigen::Vector3f> corners;
    for (const auto& corner : outline) {
      const Eigen::Vector2f at =
          corner.array() * (scale * hollow.size.head<2>().array() - 2.f * wall);
      corners.emplace_back (pose * Eigen::Vector3f (at.x(), at.y(), z));
    }
    return corners;
  };
  const std::array<std::vector<Eigen::Vector3f>, 4> rings{
      {ring (hollow.bottom, 0.f, 0.f),
       ring (1.f, 0.f, hollow.size.z()),
       ring (1.f, hollow.wall, hollow.size.z()),
       ring (hollow.bottom, hollow.wall, hollow.wall)}};
  constexpr std::size_t rim = 1;
  for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
    const auto first = static_cast<std::uint32_t> (surfaces.size());
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const std::size_t next = (i + 1) % outline.size();
      Surface& facet = addPolygon (
          {rings[k][i], rings[k][next], rings[k + 1][next], rings[k + 1][i]}, look);
      if (hollow.is_round && k != rim)
        facet.first_facet = first;
    }
  }
  addPolygon (rings.back(), look);
}

void
Scene::addObject (const Look& look,
                  TrueObject::Shape shape,
                  const Eigen::Vector3f& size,
                  const Eigen::Affine3f& pose)
{
  if (look.object != 0)
    objects.push_back ({look.object, shape, size, pose});
}

} // namespace rgbd_planes
} // namespace pcl
