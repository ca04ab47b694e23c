// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "synthetic_clouds.h"

#include <pcl/apps/frame_source.h>
#include <pcl/apps/input_options.h>
#include <pcl/common/io.h>

/** What a camera 0.6 m above a floor sees that looks straight ahead: a wall at 3 m, and at 2 m
 * the front of a box, 30 cm wide and 26 cm high. */
namespace viewer_scene {

enum Surface { floor, wall, box };

constexpr float camera_height = 0.6f, wall_distance = 3.f, box_distance = 2.f;

const pcl::RGB camera_colour (10, 200, 90);

inline Eigen::Affine3f
cameraToBase ()
{
  return pcl::rgbd_planes::parseBaseTransform ("0,0,0.6,0,0,0");
}

inline synthetic::Scene
render ()
{
  const auto covers_box = [] (int u, int v) { return u >= 280 && u < 360 && v >= 330; };
  return synthetic::render ({{-Eigen::Vector3f::UnitY(), camera_height},
                             {-Eigen::Vector3f::UnitZ(), wall_distance},
                             {-Eigen::Vector3f::UnitZ(), box_distance, covers_box}});
}

inline pcl::rgbd_planes::Frame
makeFrame (const std::string& name = "scene")
{
  pcl::rgbd_planes::Frame frame;
  frame.name = name;
  frame.cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>>();
  pcl::copyPointCloud (*render().cloud, *frame.cloud);
  for (auto& point : *frame.cloud)
    point.rgba = camera_colour.rgba;
  return frame;
}

inline bool
operator== (const pcl::RGB& a, const pcl::RGB& b)
{
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

} // namespace viewer_scene
