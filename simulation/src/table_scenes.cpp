// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "table_scenes.h"

#include "furniture.h"

#include <cstdint>

namespace pcl {
namespace rgbd_planes {

// Random numbers are drawn in braces, which have an order, never in two arguments of a call.
using Eigen::Vector3f;

namespace {

Vector3f
sizeBetween (const Vector3f& low, const Vector3f& high, Random& random)
{
  return Vector3f{random.uniform (low.x(), high.x()),
                  random.uniform (low.y(), high.y()),
                  random.uniform (low.z(), high.z())};
}

/** Of a thing that needs a circle of this radius, within \a size around the origin. */
Eigen::Affine3f
takePose (FreeSpace& space, const Eigen::Vector2f& size, float radius, Random& random)
{
  constexpr float margin = 0.02f, half_gap = 0.015f;
  const Eigen::Vector2f reach =
      0.5f * size - Eigen::Vector2f::Constant (radius + margin);
  const Eigen::Vector2f spot = space.take (radius + half_gap, [&] {
    return Eigen::Vector2f{random.uniform (-reach.x(), reach.x()),
                           random.uniform (-reach.y(), reach.y())};
  });
  return poseAt ({spot.x(), spot.y(), 0.f, random.uniform (0.f, 1.57f)});
}

} // namespace

Scene
tableSingle (Random& random)
{
  Scene scene;
  addRoom (scene, {{-1.5f, -2.2f, 0.f}, {random.uniform (2.6f, 3.4f), 2.2f, 2.6f}});
  const float height = random.uniform (0.68f, 0.78f);
  const auto top = addTable (scene,
                             poseAt ({1.05f, 0.f, 0.f, random.uniform (-0.5f, 0.5f)}),
                             {0.7f, 1.2f, height});
  const Vector3f size =
      sizeBetween ({0.07f, 0.12f, 0.15f}, {0.1f, 0.2f, 0.25f}, random);
  const auto spot = poseAt ({random.uniform (-0.15f, 0.05f),
                             random.uniform (-0.15f, 0.15f),
                             0.f,
                             random.uniform (0.4f, 1.2f)});
  scene.addBox (top * spot, size, {strongColor (random), 1});
  scene.setCamera ({{0.f, 0.f, random.uniform (1.25f, 1.5f)},
                    {1.05f, random.uniform (-0.1f, 0.1f), height},
                    random.uniform (-0.05f, 0.05f)});
  return scene;
}

Scene
tableCluttered (Random& random)
{
  Scene scene;
  addRoom (scene, {{-1.5f, -2.5f, 0.f}, {random.uniform (2.8f, 3.6f), 2.5f, 2.6f}});
  const float height = random.uniform (0.68f, 0.78f);
  const std::size_t first = scene.surfaces.size();
  const auto top = addTable (scene,
                             poseAt ({1.25f, 0.f, 0.f, random.uniform (-0.2f, 0.2f)}),
                             {0.9f, 1.5f, height});
  paint (scene,
         first,
         {random.uniform (1.f, 1.4f), random.uniform (-0.3f, 0.3f), height},
         {0.2f, 0.28f, 0.02f},
         dark);
  addClutter (scene, top, {0.75f, 1.1f}, random);
  scene.setCamera ({{0.f, random.uniform (-0.1f, 0.1f), random.uniform (1.5f, 1.7f)},
                    {1.2f, random.uniform (-0.1f, 0.1f), height},
                    random.uniform (-0.05f, 0.05f)});
  return scene;
}

Scene
worktop (Random& random)
{
  Scene scene;
  const Vector3f corner{random.uniform (1.3f, 1.7f), random.uniform (0.6f, 0.9f), 2.6f};
  addRoom (scene, {{-1.5f, -2.5f, 0.f}, corner});
  const Vector3f size{0.6f, 2.4f, random.uniform (0.8f, 0.95f)};
  scene.addBox (
      poseAt ({corner.x() - 0.5f * size.x(), corner.y() - 0.5f * size.y(), 0.f, 0.f}),
      size,
      {steel});
  std::uint32_t object = 0;
  float y = corner.y();
  for (const float gap : {0.f, 0.f, 0.005f, 0.01f, 0.02f}) {
    const Vector3f thing =
        sizeBetween ({0.06f, 0.06f, 0.05f}, {0.16f, 0.2f, 0.28f}, random);
    const float x = corner.x() - gap - 0.5f * thing.x();
    scene.addBox (poseAt ({x, y - 0.5f * thing.y(), size.z(), 0.f}),
                  thing,
                  {strongColor (random), ++object});
    y -= thing.y() + random.uniform (0.05f, 0.1f);
  }
  for (const float side : {0.25f, 0.5f, 0.75f, 1.f}) {
    const Look look{strongColor (random), ++object};
    const float height = random.uniform (0.06f, 0.15f);
    const float radius = random.uniform (0.03f, 0.05f);
    const float x = corner.x() - random.uniform (0.35f, 0.5f);
    scene.addCylinder (
        poseAt ({x, corner.y() - side, size.z(), 0.f}), radius, height, look);
  }
  scene.setCamera ({{0.f, random.uniform (-0.2f, 0.2f), random.uniform (1.4f, 1.6f)},
                    {corner.x() - 0.2f, corner.y() - 0.7f, size.z()},
                    random.uniform (-0.05f, 0.05f)});
  return scene;
}

namespace {

Vessel
bowl (Random& random)
{
  const float radius = random.uniform (0.06f, 0.12f);
  return {radius * random.uniform (0.4f, 0.7f),
          radius,
          random.uniform (0.04f, 0.09f),
          random.uniform (0.003f, 0.006f)};
}

Vessel
cup (Random& random)
{
  const float radius = random.uniform (0.035f, 0.05f);
  return {radius * random.uniform (0.7f, 1.f),
          radius,
          random.uniform (0.07f, 0.12f),
          random.uniform (0.003f, 0.006f)};
}

} // namespace

Scene
crockery (Random& random)
{
  Scene scene;
  addRoom (scene, {{-1.5f, -2.2f, 0.f}, {random.uniform (2.6f, 3.4f), 2.2f, 2.6f}});
  const float height = random.uniform (0.68f, 0.78f);
  const Eigen::Vector2f size (0.8f, 1.2f);
  const auto top = addTable (scene,
                             poseAt ({1.15f, 0.f, 0.f, random.uniform (-0.2f, 0.2f)}),
                             {size.x(), size.y(), height});
  FreeSpace space;
  const auto poseFor = [&] (float radius) {
    return top * takePose (space, size, radius, random);
  };
  std::uint32_t object = 0;
  for (int i = 0; i < 2; ++i) {
    const Vector3f box =
        sizeBetween ({0.12f, 0.1f, 0.05f}, {0.3f, 0.2f, 0.15f}, random);
    const auto pose = poseFor (0.5f * box.head<2>().norm());
    scene.addOpenBox (pose, box, 0.005f, {strongColor (random), ++object});
  }
  for (const auto& make : {bowl, bowl, cup, cup, cup}) {
    const Vessel vessel = make (random);
    const auto pose = poseFor (vessel.top_radius);
    scene.addVessel (pose, vessel, {strongColor (random), ++object});
  }
  for (int i = 0; i < 3; ++i) {
    const Vector3f box =
        sizeBetween ({0.04f, 0.04f, 0.05f}, {0.1f, 0.1f, 0.2f}, random);
    const auto pose = poseFor (0.5f * box.head<2>().norm());
    scene.addBox (pose, box, {strongColor (random), ++object});
  }
  scene.setCamera ({{0.f, random.uniform (-0.1f, 0.1f), random.uniform (1.3f, 1.7f)},
                    {1.1f, random.uniform (-0.1f, 0.1f), height},
                    random.uniform (-0.05f, 0.05f)});
  return scene;
}

Scene
shelf (Random& random)
{
  Scene scene;
  const float wall = random.uniform (1.5f, 1.9f);
  addRoom (scene, {{-1.5f, -2.2f, 0.f}, {wall, 2.2f, 2.6f}});
  constexpr float thickness = 0.02f;
  const Eigen::Vector2f size (0.35f, random.uniform (0.8f, 1.2f));
  const float x = wall - 0.5f * size.x();
  for (const float side : {-0.5f, 0.5f})
    scene.addBox (poseAt ({x, side * (size.y() + thickness), 0.f, 0.f}),
                  {size.x(), thickness, 1.8f},
                  {steel});
  std::uint32_t object = 0;
  for (const float height : {0.4f, 0.75f, 1.1f}) {
    scene.addBox (poseAt ({x, 0.f, height - thickness, 0.f}),
                  {size.x(), size.y(), thickness},
                  {steel});
    FreeSpace space;
    for (int i = 0; i < 5; ++i) {
      const Vector3f thing =
          sizeBetween ({0.05f, 0.05f, 0.06f}, {0.1f, 0.1f, 0.22f}, random);
      const auto pose = poseAt ({x, 0.f, height, 0.f}) *
                        takePose (space, size, 0.5f * thing.head<2>().norm(), random);
      const Look look{strongColor (random), ++object};
      if (i < 3)
        scene.addBox (pose, thing, look);
      else
        scene.addCylinder (pose, 0.5f * thing.x(), thing.z(), look);
    }
  }
  scene.setCamera ({{0.f, random.uniform (-0.2f, 0.2f), random.uniform (1.3f, 1.6f)},
                    {wall, random.uniform (-0.1f, 0.1f), random.uniform (0.7f, 0.9f)},
                    random.uniform (-0.05f, 0.05f)});
  return scene;
}

} // namespace rgbd_planes
} // namespace pcl
