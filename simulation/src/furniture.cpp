// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "furniture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pcl {
namespace rgbd_planes {

namespace {

using Eigen::Affine3f;
using Eigen::Translation3f;
using Eigen::Vector3f;

const Vector3f wood (0.62f, 0.43f, 0.25f);
const Vector3f tiles (0.45f, 0.47f, 0.50f);
const Vector3f white (0.9f, 0.9f, 0.9f);
const Vector3f plaster (0.82f, 0.80f, 0.74f);
const Vector3f blue_wall (0.70f, 0.78f, 0.82f);
const Vector3f red_wall (0.80f, 0.74f, 0.70f);

/** A thing to put somewhere: how much room it needs and how to add it there. */
struct Item {
  float radius;
  std::function<void (Scene&, const Affine3f&)> add;
};

class ItemMaker {
public:
  explicit ItemMaker (Random& random) : random_ (random) {}

  Item
  box (float smallest, float largest)
  {
    return box (Vector3f{random_.uniform (smallest, largest),
                         random_.uniform (smallest, largest),
                         random_.uniform (smallest, 1.3f * largest)});
  }

  Item
  box (const Vector3f& size)
  {
    const Look look = newLook();
    return {0.5f * size.head<2>().norm(),
            [size, look] (Scene& scene, const Affine3f& pose) {
              scene.addBox (pose, size, look);
            }};
  }

  Item
  cylinder ()
  {
    const Look look = newLook();
    const float radius = random_.uniform (0.015f, 0.045f);
    const float height = random_.uniform (0.04f, 0.2f);
    return {radius, [=] (Scene& scene, const Affine3f& pose) {
              scene.addCylinder (pose, radius, height, look);
            }};
  }

  Item
  sphere ()
  {
    const Look look = newLook();
    const float radius = random_.uniform (0.02f, 0.045f);
    return {radius, [=] (Scene& scene, const Affine3f& pose) {
              scene.addSphere (pose * Vector3f (0.f, 0.f, radius), radius, look);
            }};
  }

  /** Two boxes, face to face. */
  Item
  touchingPair ()
  {
    const Vector3f a{random_.uniform (0.03f, 0.06f),
                     random_.uniform (0.04f, 0.08f),
                     random_.uniform (0.05f, 0.12f)};
    const Vector3f b{random_.uniform (0.03f, 0.06f),
                     random_.uniform (0.04f, 0.08f),
                     random_.uniform (0.05f, 0.12f)};
    const Look look_a = newLook();
    const Look look_b = newLook();
    return {0.5f * std::hypot (a.x() + b.x(), std::max (a.y(), b.y())),
            [=] (Scene& scene, const Affine3f& pose) {
              scene.addBox (pose * Translation3f (-0.5f * b.x(), 0.f, 0.f), a, look_a);
              scene.addBox (pose * Translation3f (0.5f * a.x(), 0.f, 0.f), b, look_b);
            }};
  }

private:
  Look
  newLook ()
  {
    return {strongColor (random_), ++objects_};
  }

  Random& random_;
  std::uint32_t objects_ = 0;
};

std::vector<Item>
makeClutter (Random& random)
{
  ItemMaker make (random);
  std::vector<Item> items;
  for (int i = 0; i < 3; ++i)
    items.push_back (make.box (0.12f, 0.18f));
  for (int i = 0; i < 5; ++i)
    items.push_back (make.touchingPair());
  for (int i = 0; i < 5; ++i)
    items.push_back (make.box ({0.08f, 0.025f, 0.012f}));
  for (int i = 0; i < 17; ++i)
    items.push_back (make.box (0.02f, 0.08f));
  for (int i = 0; i < 15; ++i)
    items.push_back (make.cylinder());
  for (int i = 0; i < 15; ++i)
    items.push_back (make.sphere());
  std::stable_sort (items.begin(), items.end(), [] (const Item& a, const Item& b) {
    return a.radius > b.radius;
  });
  return items;
}

} // namespace

Vector3f
strongColor (Random& random)
{
  const float hue = random.uniform (0.f, 6.f);
  Vector3f color;
  for (int i = 0; i < 3; ++i) {
    const float distance =
        std::fabs (std::remainder (hue - 2.f * static_cast<float> (i), 6.f));
    color[i] = 0.2f + 0.7f * std::clamp (2.f - distance, 0.f, 1.f);
  }
  return color;
}

void
paint (Scene& scene,
       std::size_t first,
       const Vector3f& center,
       const Vector3f& size,
       const Vector3f& color)
{
  for (std::size_t i = first; i < scene.surfaces.size(); ++i)
    scene.surfaces[i].decals.push_back (
        {Eigen::AlignedBox3f (center - 0.5f * size, center + 0.5f * size), color});
}

Affine3f
poseAt (const Placement& placement)
{
  return Translation3f (placement.x, placement.y, placement.z) *
         Eigen::AngleAxisf (placement.yaw, Vector3f::UnitZ());
}

void
addRoom (Scene& scene, const Room& room)
{
  const auto side = [&] (int axis, float at, const Vector3f& color) -> Surface& {
    const int i = (axis + 1) % 3;
    const int j = (axis + 2) % 3;
    std::vector<Vector3f> corners (4);
    for (std::size_t k = 0; k < 4; ++k) {
      corners[k][axis] = at;
      corners[k][i] = k == 1 || k == 2 ? room.high[i] : room.low[i];
      corners[k][j] = k >= 2 ? room.high[j] : room.low[j];
    }
    return scene.addPolygon (corners, {color});
  };
  side (2, room.low.z(), tiles).obstacle = false;
  side (2, room.high.z(), white);
  side (0, room.low.x(), plaster);
  side (0, room.high.x(), plaster);
  side (1, room.low.y(), blue_wall);
  side (1, room.high.y(), red_wall);
}

Affine3f
addTable (Scene& scene, const Affine3f& pose, const Vector3f& size)
{
  constexpr float thickness = 0.04f;
  constexpr float leg = 0.06f;
  scene.addBox (pose * Translation3f (0.f, 0.f, size.z() - thickness),
                {size.x(), size.y(), thickness},
                {wood});
  for (const float x : {-0.45f, 0.45f})
    for (const float y : {-0.45f, 0.45f})
      scene.addBox (pose * Translation3f (x * size.x(), y * size.y(), 0.f),
                    {leg, leg, size.z() - thickness},
                    {wood});
  return pose * Translation3f (0.f, 0.f, size.z());
}

Eigen::Vector2f
FreeSpace::take (float radius, const std::function<Eigen::Vector2f()>& draw_center)
{
  constexpr int max_tries = 100000;
  for (int tries = 0; tries < max_tries; ++tries) {
    const Circle circle{draw_center(), radius};
    if (isFree (circle)) {
      taken_.push_back (circle);
      return circle.center;
    }
  }
  throw std::logic_error ("simulate: the objects of the scene do not fit");
}

bool
FreeSpace::isFree (const Circle& circle) const
{
  return std::none_of (taken_.begin(), taken_.end(), [&] (const Circle& other) {
    return (other.center - circle.center).norm() < other.radius + circle.radius;
  });
}

void
addClutter (Scene& scene,
            const Affine3f& pose,
            const Eigen::Vector2f& size,
            Random& random)
{
  constexpr float gap = 0.005f;
  FreeSpace space;
  for (const auto& item : makeClutter (random)) {
    const Eigen::Vector2f spot = space.take (item.radius + gap, [&] {
      const float x = random.uniform (-0.5f, 0.5f) * size.x();
      return Eigen::Vector2f (x, random.uniform (-0.5f, 0.5f) * size.y());
    });
    item.add (scene,
              pose * poseAt ({spot.x(), spot.y(), 0.f, random.uniform (0.f, 3.14f)}));
  }
}

} // namespace rgbd_planes
} // namespace pcl
