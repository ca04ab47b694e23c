// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "scene.h"

#include <array>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr int disc_corners = 96;

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
  for (int i = 0; i < disc_corners; ++i) {
    const float angle = 6.2831853f * static_cast<float> (i) / disc_corners;
    rim.push_back (pose * Eigen::Vector3f (radius * std::cos (angle),
                                           radius * std::sin (angle),
                                           height));
  }
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
