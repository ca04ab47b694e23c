// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "active_stereo.h"
#include "kinect.h"
#include "renderer.h"
#include "scenes.h"
#include "truth.h"

#include <pcl/simulation/simulate.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** The colour of a matt surface under two lamps and a bright ceiling. */
Eigen::Vector3f
shade (const RenderedPixel& pixel, const Eigen::Matrix3f& camera_to_base)
{
  if (pixel.surface == RenderedPixel::no_surface)
    return Eigen::Vector3f::Zero();
  const Eigen::Vector3f normal = camera_to_base * pixel.normal;
  const float lamp = std::max (0.f, normal.dot (Eigen::Vector3f (-0.5f, 0.4f, 0.77f)));
  const float window =
      std::max (0.f, normal.dot (Eigen::Vector3f (-0.3f, -0.95f, 0.1f)));
  return pixel.color * (0.4f + 0.45f * lamp + 0.25f * window);
}

std::uint8_t
toByte (float value)
{
  return static_cast<std::uint8_t> (std::clamp (255.f * value, 0.f, 255.f));
}

std::vector<float>
trueDepth (const std::vector<RenderedPixel>& image)
{
  std::vector<float> depth;
  depth.reserve (image.size());
  for (const auto& pixel : image)
    depth.push_back (pixel.point.z());
  return depth;
}

pcl::PointCloud<pcl::PointXYZRGB>::Ptr
makeCloud (const Scene& scene,
           const Camera& camera,
           const std::vector<RenderedPixel>& image,
           const std::vector<float>& depth)
{
  pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud (
      new pcl::PointCloud<pcl::PointXYZRGB> (camera.width, camera.height));
  cloud->is_dense = true;
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const std::size_t i = v * camera.width + u;
      auto& point = (*cloud)[i];
      point.getVector3fMap() =
          rayThrough (camera, static_cast<float> (u), static_cast<float> (v)) *
          depth[i];
      const Eigen::Vector3f color = shade (image[i], scene.camera_to_base.linear());
      point.r = toByte (color.x());
      point.g = toByte (color.y());
      point.b = toByte (color.z());
      cloud->is_dense &= std::isfinite (depth[i]);
    }
  return cloud;
}

/** What the sensor needs to see of what it measures, besides its own view. */
std::vector<Eigen::Vector3f>
otherEyes (Sensor sensor)
{
  switch (sensor) {
  case Sensor::kinect:
    return kinectEyes();
  case Sensor::active_stereo:
    return activeStereoEyes();
  case Sensor::ideal:
    break;
  }
  return {};
}

std::vector<float>
measure (const std::vector<RenderedPixel>& image,
         const Camera& camera,
         Sensor sensor,
         Random& random,
         Random& camera_random)
{
  switch (sensor) {
  case Sensor::kinect:
    return measureWithKinect (image, camera, random, camera_random);
  case Sensor::active_stereo:
    return measureWithActiveStereo (image, camera, random);
  case Sensor::ideal:
    break;
  }
  return trueDepth (image);
}

} // namespace

SimulatedFrame
simulate (const std::string& scene_name,
          unsigned seed,
          Sensor sensor,
          const std::optional<unsigned>& camera_seed)
{
  const Scene scene = makeScene (scene_name, seed);
  const Camera camera;
  const auto image = render (scene, camera, otherEyes (sensor));

  SimulatedFrame frame;
  frame.camera_to_base = scene.camera_to_base;
  frame.objects = scene.objects;
  for (auto& object : frame.objects)
    object.pose = scene.camera_to_base.inverse() * object.pose;
  fillTruth (scene, camera, image, frame);

  Random random (seed), camera_random (camera_seed.value_or (0));
  const auto depth =
      measure (image, camera, sensor, random, camera_seed ? camera_random : random);
  frame.cloud = makeCloud (scene, camera, image, depth);
  return frame;
}

} // namespace rgbd_planes
} // namespace pcl
