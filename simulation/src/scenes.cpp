// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "scenes.h"

#include "furniture.h"
#include "table_scenes.h"

#include <pcl/simulation/simulate.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pcl {
namespace rgbd_planes {

namespace {

// Random numbers are drawn in braces, which have an order, never in two arguments of a call.
using Eigen::Vector3f;

const Vector3f door (0.50f, 0.32f, 0.18f);
const Vector3f rug (0.55f, 0.25f, 0.22f);

Scene
room (Random& random)
{
  Scene scene;
  const Vector3f far_corner{random.uniform (4.2f, 5.2f),
                            random.uniform (2.f, 2.8f),
                            random.uniform (2.4f, 2.7f)};
  addRoom (scene, {{-1.5f, random.uniform (-2.8f, -2.f), 0.f}, far_corner});
  paint (scene,
         0,
         {far_corner.x(), random.uniform (-1.2f, 0.6f), 1.f},
         {0.1f, 0.9f, 2.f},
         door);
  paint (scene,
         0,
         {random.uniform (1.6f, 2.6f), far_corner.y(), 1.5f},
         {0.9f, 0.1f, 0.6f},
         dark);
  scene.addBox (poseAt ({far_corner.x() - 0.25f, far_corner.y() - 0.6f, 0.f, 0.f}),
                {0.5f, 1.f, random.uniform (1.5f, 1.9f)},
                {steel});

  const float height = random.uniform (0.68f, 0.78f);
  const auto top = addTable (scene,
                             poseAt ({random.uniform (1.7f, 1.9f),
                                      random.uniform (-0.3f, 0.3f),
                                      0.f,
                                      random.uniform (-0.4f, 0.4f)}),
                             {0.9f, 1.5f, height});
  addClutter (scene, top, {0.75f, 1.1f}, random);
  scene.setCamera ({{0.f, 0.f, random.uniform (1.35f, 1.5f)},
                    {2.f, random.uniform (-0.3f, 0.3f), random.uniform (1.05f, 1.15f)},
                    random.uniform (-0.04f, 0.04f)});
  return scene;
}

Scene
corridor (Random& random)
{
  Scene scene;
  const float right = random.uniform (-1.2f, -0.8f);
  const float left = random.uniform (0.8f, 1.2f);
  const float end = random.uniform (5.8f, 6.4f);
  addRoom (scene, {{-1.5f, right, 0.f}, {end, left, random.uniform (2.4f, 2.7f)}});
  for (const float side : {right, left}) {
    paint (scene, 0, {random.uniform (1.6f, 3.5f), side, 1.f}, {0.9f, 0.1f, 2.f}, door);
    float x = random.uniform (1.8f, 2.6f);
    while (x < 5.f) {
      const Vector3f size{random.uniform (0.5f, 1.f),
                          random.uniform (0.25f, 0.4f),
                          random.uniform (0.9f, 1.8f)};
      const float y = side + (side < 0.f ? 0.5f : -0.5f) * size.y();
      scene.addBox (poseAt ({x, y, 0.f, 0.f}), size, {strongColor (random)});
      x += random.uniform (1.3f, 1.9f);
    }
  }
  scene.setCamera ({{0.f, random.uniform (-0.25f, 0.25f), random.uniform (1.f, 1.4f)},
                    {4.f, random.uniform (-0.4f, 0.4f), random.uniform (0.8f, 1.1f)},
                    random.uniform (-0.03f, 0.03f)});
  return scene;
}

/** A wedge that rises along x from the origin of \a pose. */
void
addRamp (Scene& scene, const Eigen::Affine3f& pose, const Vector3f& size)
{
  const auto corner = [&] (float x, float y, float z) -> Vector3f {
    return pose * Vector3f (x * size.x(), (y - 0.5f) * size.y(), z * size.z());
  };
  const Look look{steel};
  scene.addPolygon (
      {corner (0, 0, 0), corner (1, 0, 1), corner (1, 1, 1), corner (0, 1, 0)}, look);
  scene.addPolygon (
      {corner (1, 0, 0), corner (1, 1, 0), corner (1, 1, 1), corner (1, 0, 1)}, look);
  for (const float y : {0.f, 1.f})
    scene.addPolygon ({corner (0, y, 0), corner (1, y, 0), corner (1, y, 1)}, look);
}

/** Ten things from 1 cm to 1 m high; the lower, the nearer, the noise of a sensor would
 * hide them otherwise. Each has its own direction, so that none hides another. */
void
addObstacles (Scene& scene, FreeSpace& space, Random& random)
{
  constexpr float directions = 10.f;
  const float shift = random.uniform (0.f, directions);
  std::uint32_t object = 0;
  for (const float height :
       {0.01f, 1.f, 0.015f, 0.02f, 0.03f, 0.05f, 0.1f, 0.2f, 0.35f, 0.6f}) {
    const float radius = random.uniform (0.06f, 0.14f);
    const auto direction =
        std::fmod (shift + 3.f * static_cast<float> (object), directions);
    const float slope = 0.09f * (direction - 0.5f * directions);
    const float nearest = 0.75f + 1.3f * height;
    const float farthest = std::min (4.f, 0.9f + 40.f * height);
    const Eigen::Vector2f spot = space.take (radius + 0.02f, [&] {
      const float x = random.uniform (nearest, farthest);
      return Eigen::Vector2f (x, x * slope);
    });
    const auto pose = poseAt ({spot.x(), spot.y(), 0.f, random.uniform (0.f, 1.57f)});
    const Look look{strongColor (random), ++object};
    if (random.uniform (0.f, 1.f) < 0.3f)
      scene.addCylinder (pose, radius, height, look);
    else
      scene.addBox (pose, {1.5f * radius, 1.3f * radius, height}, look);
  }
}

Scene
floorObstacles (Random& random)
{
  Scene scene;
  addRoom (scene, {{-1.5f, -2.6f, 0.f}, {random.uniform (5.f, 6.f), 2.6f, 2.6f}});
  paint (scene, 0, {1.6f, random.uniform (-0.3f, 0.3f), 0.f}, {0.8f, 0.6f, 0.02f}, rug);
  const float side = random.uniform (0.f, 1.f) < 0.5f ? 1.f : -1.f;
  const float step_height = random.uniform (0.08f, 0.18f);
  scene.addBox (poseAt ({3.6f, 1.3f * side, 0.f, random.uniform (-0.2f, 0.2f)}),
                {1.2f, 1.2f, step_height},
                {steel});
  const float ramp_height = random.uniform (0.1f, 0.18f);
  addRamp (scene,
           poseAt ({2.3f, -0.95f * side, 0.f, random.uniform (-0.2f, 0.2f)}),
           {1.f, 0.8f, ramp_height});
  addTable (scene,
            poseAt ({4.2f, -0.2f * side, 0.f, random.uniform (-0.4f, 0.4f)}),
            {0.6f, 0.9f, 0.72f});
  FreeSpace space;
  space.take (0.87f, [&] { return Eigen::Vector2f (3.6f, 1.3f * side); });
  space.take (0.67f, [&] { return Eigen::Vector2f (2.8f, -0.95f * side); });
  space.take (0.55f, [&] { return Eigen::Vector2f (4.2f, -0.2f * side); });
  addObstacles (scene, space, random);
  scene.setCamera ({{0.f, 0.f, random.uniform (0.65f, 0.85f)},
                    {1.8f, random.uniform (-0.1f, 0.1f), random.uniform (0.f, 0.1f)},
                    random.uniform (-0.03f, 0.03f)});
  return scene;
}

struct NamedScene {
  const char* name;
  Scene (*make) (Random&);
};

constexpr NamedScene scenes[] = {{"table_single", tableSingle},
                                 {"table_cluttered", tableCluttered},
                                 {"room", room},
                                 {"corridor", corridor},
                                 {"floor_obstacles", floorObstacles},
                                 {"worktop", worktop},
                                 {"crockery", crockery},
                                 {"shelf", shelf}};

} // namespace

const std::vector<std::string>&
sceneNames ()
{
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& scene : scenes)
      all.emplace_back (scene.name);
    return all;
  }();
  return names;
}

Scene
makeScene (const std::string& name, unsigned seed)
{
  Random random (seed);
  for (const auto& scene : scenes)
    if (name == scene.name)
      return scene.make (random);
  std::string message = "unknown scene '" + name + "'; the scenes are";
  for (const auto& known : sceneNames())
    message += " " + known;
  throw std::invalid_argument (message);
}

} // namespace rgbd_planes
} // namespace pcl
