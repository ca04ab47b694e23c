// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "furniture.h"
#include "kinect.h"
#include "plane_clouds.h"
#include "renderer.h"

#include <pcl/segmentation/supported_object_extraction.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

namespace {

using pcl::rgbd_planes::Camera;
using pcl::rgbd_planes::Look;
using pcl::rgbd_planes::poseAt;
using pcl::rgbd_planes::Random;
using pcl::rgbd_planes::RenderedPixel;
using pcl::rgbd_planes::Scene;

constexpr float table_height = 0.72f;

/** A table 1.1 m in front of a camera that is 0.7 m above it, and turned by \a roll. */
Scene
tableBelow (float roll = 0.f)
{
  Scene scene;
  addRoom (scene, {{-1.5f, -2.2f, 0.f}, {3.f, 2.2f, 2.6f}});
  addTable (scene, poseAt ({1.1f, 0.f, 0.f, 0.f}), {0.8f, 1.2f, table_height});
  scene.setCamera ({{0.f, 0.f, table_height + 0.7f}, {1.1f, 0.f, table_height}, roll});
  return scene;
}

Eigen::Affine3f
onTable (float x, float y, float yaw = 0.f)
{
  return poseAt ({1.1f + x, y, table_height, yaw});
}

/** Which objects are found in what a Kinect sees of a scene. */
struct Found {
  /** Of each found object, how many of its points are of each true one. */
  std::vector<std::map<std::uint32_t, std::size_t>> objects;
  /** How many points the true ones have. */
  std::map<std::uint32_t, std::size_t> points;

  /** Whether each object found is one true one, and has most of its points. */
  bool
  areAllWhole () const
  {
    return std::all_of (objects.begin(), objects.end(), [&] (const auto& object) {
      return std::count_if (object.begin(),
                            object.end(),
                            [&] (const auto& part) {
                              return part.first != 0 &&
                                     10 * part.second >= points.at (part.first);
                            }) == 1 &&
             std::any_of (object.begin(), object.end(), [&] (const auto& part) {
               return part.first != 0 && 4 * part.second >= 3 * points.at (part.first);
             });
    });
  }
};

Found
find (const Scene& scene, unsigned seed = 1)
{
  const Camera camera;
  const auto image = render (scene, camera, pcl::rgbd_planes::kinectEyes());
  Random random (seed), camera_random (seed);
  const auto depth =
      pcl::rgbd_planes::measureWithKinect (image, camera, random, camera_random);
  const auto cloud = pcl::make_shared<plane_clouds::Cloud> (
      static_cast<std::uint32_t> (camera.width),
      static_cast<std::uint32_t> (camera.height));
  Found found;
  std::vector<std::uint32_t> object (image.size());
  for (std::size_t i = 0; i < image.size(); ++i) {
    const auto width = static_cast<std::size_t> (camera.width);
    (*cloud)[i].getVector3fMap() = rayThrough (camera,
                                               static_cast<float> (i % width),
                                               static_cast<float> (i / width)) *
                                   depth[i];
    if (image[i].surface == RenderedPixel::no_surface || !std::isfinite (depth[i]))
      continue;
    object[i] = scene.surfaces[image[i].surface].object;
    ++found.points[object[i]];
  }
  cloud->is_dense = false;

  plane_clouds::Ours segmentation;
  plane_clouds::Result planes;
  plane_clouds::segment (segmentation, cloud, planes);
  pcl::SupportedObjectExtraction<pcl::PointXYZ, pcl::Normal> extraction;
  extraction.setInputCloud (cloud);
  extraction.setCameraToBase (scene.camera_to_base);
  extraction.setPlaneHeights (0.5, 1.2);
  std::vector<pcl::SupportedObject> objects;
  extraction.extract (planes.models, planes.inliers, objects);
  for (const auto& found_object : objects) {
    found.objects.emplace_back();
    const pcl::Indices& indices = found_object.indices.indices;
    EXPECT_TRUE (std::is_sorted (indices.begin(), indices.end()));
    for (const auto i : indices)
      ++found.objects.back()[object[static_cast<std::size_t> (i)]];
  }
  return found;
}

/** Three by two things of one kind, whose centres are \a pitch apart in depth. */
Scene
rows (float pitch,
      const std::function<void (Scene&, const Eigen::Affine3f&, const Look&)>& add)
{
  Scene scene = tableBelow();
  std::uint32_t object = 0;
  for (const float row : {-1.f, 0.f, 1.f})
    for (const float y : {-0.15f, 0.15f})
      add (scene, onTable (row * pitch, y), {{0.7f, 0.2f, 0.2f}, ++object});
  return scene;
}

const Look red{{0.7f, 0.2f, 0.2f}, 1};

} // namespace

TEST (HollowThings, ACupIsOneObject)
{
  for (const float top : {0.035f, 0.05f})
    for (const float bottom : {0.7f, 1.f})
      for (const unsigned seed : {1u, 2u, 3u}) {
        Scene scene = tableBelow();
        scene.addVessel (onTable (0.f, 0.1f), {bottom * top, top, 0.1f, 0.004f}, red);
        const Found found = find (scene, seed);
        EXPECT_EQ (found.objects.size(), 1u) << top << ' ' << bottom << ' ' << seed;
        EXPECT_TRUE (found.areAllWhole()) << top << ' ' << bottom << ' ' << seed;
      }
}

TEST (HollowThings, ACupIsOneObjectForACameraOnItsSide)
{
  for (const float roll : {0.5f * float (M_PI), float (M_PI), -0.5f * float (M_PI)}) {
    Scene scene = tableBelow (roll);
    scene.addVessel (onTable (0.f, 0.1f), {0.04f, 0.045f, 0.1f, 0.004f}, red);
    const Found found = find (scene);
    EXPECT_EQ (found.objects.size(), 1u) << roll;
    EXPECT_TRUE (found.areAllWhole()) << roll;
  }
}

TEST (HollowThings, ABoxWithoutALidIsOneObject)
{
  for (const float yaw : {0.3f, 0.6f, 0.785f, 1.1f})
    for (const float height : {0.08f, 0.14f}) {
      Scene scene = tableBelow();
      scene.addOpenBox (onTable (0.f, 0.f, yaw), {0.2f, 0.14f, height}, 0.005f, red);
      const Found found = find (scene);
      EXPECT_EQ (found.objects.size(), 1u) << yaw << ' ' << height;
      EXPECT_TRUE (found.areAllWhole()) << yaw << ' ' << height;
    }
}

TEST (HollowThings, ABoxWhoseSidesAreNotSeenIsOneObject)
{
  for (const float y : {-0.02f, 0.f, 0.02f})
    for (const float height : {0.06f, 0.09f}) {
      Scene scene = tableBelow();
      scene.addOpenBox (onTable (0.1f, y), {0.12f, 0.22f, height}, 0.003f, red);
      const Found found = find (scene);
      EXPECT_EQ (found.objects.size(), 1u) << y << ' ' << height;
    }
}

TEST (HollowThings, ABowlIsOneObjectWithItsFoot)
{
  for (const float bottom : {0.5f, 0.6f})
    for (const float height : {0.05f, 0.08f}) {
      Scene scene = tableBelow();
      scene.addVessel (onTable (0.2f, 0.f), {bottom * 0.1f, 0.1f, height, 0.004f}, red);
      const Found found = find (scene);
      EXPECT_EQ (found.objects.size(), 1u) << bottom << ' ' << height;
    }
}

/** Their walls are too steep for a foot, and their sides are seen. */
TEST (HollowThings, BowlsAndPotsAreOneObjectByTheirRims)
{
  struct {
    float x, bottom, top, height;
  } const vessels[] = {{-0.2f, 0.04f, 0.1f, 0.09f},
                       {0.f, 0.04f, 0.1f, 0.09f},
                       {0.25f, 0.06f, 0.1f, 0.15f},
                       {0.25f, 0.08f, 0.1f, 0.15f},
                       {0.f, 0.072f, 0.12f, 0.06f}};
  for (const auto& vessel : vessels) {
    Scene scene = tableBelow();
    scene.addVessel (onTable (vessel.x, 0.1f),
                     {vessel.bottom, vessel.top, vessel.height, 0.004f},
                     red);
    const Found found = find (scene);
    EXPECT_EQ (found.objects.size(), 1u) << vessel.bottom << ' ' << vessel.height;
    EXPECT_TRUE (found.areAllWhole()) << vessel.bottom << ' ' << vessel.height;
  }
}

TEST (HollowThings, CupsInARowAreSeveral)
{
  const auto add = [] (Scene& scene, const Eigen::Affine3f& pose, const Look& look) {
    scene.addVessel (pose, {0.035f, 0.04f, 0.1f, 0.004f}, look);
  };
  for (const float gap : {0.04f, 0.06f, 0.08f}) {
    const Found found = find (rows (0.08f + gap, add));
    EXPECT_EQ (found.objects.size(), 6u) << gap;
    EXPECT_TRUE (found.areAllWhole()) << gap;
  }
}

TEST (HollowThings, BoxesWithoutLidsInARowAreSeveral)
{
  const auto add = [] (Scene& scene, const Eigen::Affine3f& pose, const Look& look) {
    scene.addOpenBox (pose, {0.08f, 0.08f, 0.1f}, 0.004f, look);
  };
  for (const float gap : {0.03f, 0.04f, 0.05f}) {
    const Found found = find (rows (0.08f + gap, add));
    EXPECT_EQ (found.objects.size(), 6u) << gap;
    EXPECT_TRUE (found.areAllWhole()) << gap;
  }
}

TEST (HollowThings, SolidThingsInARowAreSeveral)
{
  const auto addBox = [] (Scene& scene, const Eigen::Affine3f& pose, const Look& look) {
    scene.addBox (pose, {0.07f, 0.1f, 0.1f}, look);
  };
  const auto addCan = [] (Scene& scene, const Eigen::Affine3f& pose, const Look& look) {
    scene.addCylinder (pose, 0.035f, 0.1f, look);
  };
  const auto addBall =
      [] (Scene& scene, const Eigen::Affine3f& pose, const Look& look) {
        scene.addSphere (pose * Eigen::Vector3f (0.f, 0.f, 0.035f), 0.035f, look);
      };
  for (const float gap : {0.03f, 0.05f, 0.08f}) {
    for (const auto& add : {+addBox, +addCan, +addBall})
      EXPECT_TRUE (find (rows (0.07f + gap, add)).areAllWhole()) << gap;
    EXPECT_EQ (find (rows (0.07f + gap, addCan)).objects.size(), 6u) << gap;
    for (const float thickness : {0.022f, 0.03f}) {
      const auto addBook =
          [thickness] (Scene& scene, const Eigen::Affine3f& pose, const Look& look) {
            scene.addBox (pose, {thickness, 0.15f, 0.15f}, look);
          };
      EXPECT_TRUE (find (rows (thickness + gap, addBook)).areAllWhole())
          << thickness << ' ' << gap;
    }
  }
}

TEST (HollowThings, WhatIsHigherBehindAPlateIsAnother)
{
  Scene scene = tableBelow();
  scene.addBox (onTable (0.f, 0.f), {0.008f, 0.15f, 0.1f}, red);
  scene.addBox (onTable (0.08f, 0.f), {0.008f, 0.15f, 0.14f}, {{0.2f, 0.2f, 0.7f}, 2});
  const Found found = find (scene);
  EXPECT_EQ (found.objects.size(), 2u);
  EXPECT_TRUE (found.areAllWhole());
}

TEST (HollowThings, WhatIsWiderBehindAPlateIsAnother)
{
  Scene scene = tableBelow();
  scene.addBox (onTable (0.f, 0.f), {0.008f, 0.1f, 0.1f}, red);
  scene.addBox (onTable (0.08f, 0.f), {0.008f, 0.3f, 0.1f}, {{0.2f, 0.2f, 0.7f}, 2});
  const Found found = find (scene);
  EXPECT_EQ (found.objects.size(), 2u);
  EXPECT_TRUE (found.areAllWhole());
}
