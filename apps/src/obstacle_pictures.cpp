// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/obstacle_pictures.h>

#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** The golden ratio spreads shades evenly; those that come close differ in brightness. */
pcl::RGB
obstacleColour (std::size_t id, Obstacle::Kind kind)
{
  const double turns = static_cast<double> (id) * 0.6180339887498949;
  const double brightness = id % 2 == 0 ? 1. : 0.7;
  const auto full = static_cast<std::uint8_t> (255. * brightness);
  const auto part =
      static_cast<std::uint8_t> (230. * brightness * (turns - std::floor (turns)));
  return kind == Obstacle::Kind::obstacle ? pcl::RGB (full, part, 0)
                                          : pcl::RGB (part, 40, full);
}

} // namespace

Picture
obstaclesPicture (const pcl::PointCloud<pcl::PointXYZRGB>& cloud,
                  const std::vector<ObstacleClass>& classes,
                  const std::vector<ObstacleSummary>& obstacles)
{
  Picture picture (cloud.width, cloud.height, pcl::RGB (0, 0, 0));
  for (std::size_t i = 0; i < classes.size(); ++i)
    if (classes[i] == ObstacleClass::floor)
      picture[i] = {40, 110, 50};
    else if (classes[i] == ObstacleClass::speck)
      picture[i] = {255, 255, 255};
  for (std::size_t id = 0; id < obstacles.size(); ++id) {
    const Obstacle& obstacle = obstacles[id].obstacle;
    const pcl::RGB colour = obstacleColour (id, obstacle.kind);
    for (const auto index : obstacle.indices)
      picture[static_cast<std::size_t> (index)] = colour;
  }
  return picture;
}

} // namespace rgbd_planes
} // namespace pcl
