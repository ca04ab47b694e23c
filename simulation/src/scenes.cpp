// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "scenes.h"

#include "random.h"

#include <pcl/simulation/simulate.h>

#include <algorithm>
#include <stdexcept>

namespace pcl {
namespace rgbd_planes {

namespace {

using Color = Eigen::Vector3f;
using Eigen::Vector3f;

const Color wood (0.62f, 0.43f, 0.25f);
const Color plaster (0.82f, 0.80f, 0.74f);
const Color tiles (0.45f, 0.47f, 0.50f);

Color
strongColor (Random& random)
{
  const float hue = random.uniform (0.f, 6.f);
  Color color;
  for (int i = 0; i < 3; ++i) {
    const float distance =
        std::fabs (std::remainder (hue - 2.f * static_cast<float> (i), 6.f));
    color[i] = 0.2f + 0.7f * std::clamp (2.f - distance, 0.f, 1.f);
  }
  return color;
}

Eigen::Affine3f
poseAt (float x, float y, float z, float yaw)
{
  return Eigen::Translation3f (x, y, z) * Eigen::AngleAxisf (yaw, Vector3f::UnitZ());
}

/** Floor, ceiling and four walls; only the floor is no obstacle. */
void
addRoom (Scene& scene, const Vector3f& low, const Vector3f& high)
{
  const auto quad = [&] (int axis, float at, const Color& color) -> Surface& {
    const int i = (axis + 1) % 3;
    const int j = (axis + 2) % 3;
    std::vector<Vector3f> corners (4, Vector3f::Zero());
    for (std::size_t k = 0; k < 4; ++k) {
      corners[k][axis] = at;
      corners[k][i] = k == 1 || k == 2 ? high[i] : low[i];
      corners[k][j] = k >= 2 ? high[j] : low[j];
    }
    return scene.addPolygon (corners, {color});
  };
  quad (2, low.z(), tiles).obstacle = false;
  quad (2, high.z(), Color::Constant (0.9f));
  quad (0, low.x(), plaster);
  quad (0, high.x(), plaster);
  quad (1, low.y(), Color (0.70f, 0.78f, 0.82f));
  quad (1, high.y(), Color (0.80f, 0.74f, 0.70f));
}

/** A table whose top ends at the height of size.z, with four legs. */
void
addTable (Scene& scene, const Eigen::Affine3f& pose, const Vector3f& size)
{
  constexpr float thickness = 0.04f;
  constexpr float leg = 0.06f;
  scene.addBox (pose * Eigen::Translation3f (0.f, 0.f, size.z() - thickness),
                {size.x(), size.y(), thickness},
                {wood});
  for (const float x : {-0.45f, 0.45f})
    for (const float y : {-0.45f, 0.45f})
      scene.addBox (pose * Eigen::Translation3f (x * size.x(), y * size.y(), 0.f),
                    {leg, leg, size.z() - thickness},
                    {wood});
}

Scene
tableSingle (Random& random)
{
  Scene scene;
  addRoom (scene, {-1.5f, -2.2f, 0.f}, {random.uniform (2.6f, 3.4f), 2.2f, 2.6f});
  const float height = random.uniform (0.68f, 0.78f);
  const auto table = poseAt (1.05f, 0.f, 0.f, random.uniform (-0.5f, 0.5f));
  addTable (scene, table, {0.7f, 1.2f, height});

  const Vector3f size (random.uniform (0.07f, 0.1f),
                       random.uniform (0.12f, 0.2f),
                       random.uniform (0.15f, 0.25f));
  const auto spot = poseAt (random.uniform (-0.15f, 0.05f),
                            random.uniform (-0.15f, 0.15f),
                            height,
                            random.uniform (0.4f, 1.2f));
  scene.addBox (table * spot, size, {strongColor (random), 1});

  scene.setCamera ({0.f, 0.f, random.uniform (1.25f, 1.5f)},
                   {1.05f, random.uniform (-0.1f, 0.1f), height},
                   random.uniform (-0.05f, 0.05f));
  return scene;
}

} // namespace

const std::vector<std::string>&
sceneNames ()
{
  static const std::vector<std::string> names{"table_single"};
  return names;
}

Scene
makeScene (const std::string& name, unsigned seed)
{
  Random random (seed);
  if (name == "table_single")
    return tableSingle (random);
  std::string message = "unknown scene '" + name + "'; the scenes are";
  for (const auto& known : sceneNames())
    message += " " + known;
  throw std::invalid_argument (message);
}

} // namespace rgbd_planes
} // namespace pcl
