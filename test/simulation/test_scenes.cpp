// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "scenes.h"

#include <gtest/gtest.h>

using namespace pcl::rgbd_planes;

namespace {

/** One number for where all surfaces and the camera are, how large and of which colour. */
double
layout (const Scene& scene)
{
  const Eigen::Vector3d weights (1., 2., 3.);
  double sum = 0.;
  std::size_t points = 0;
  for (const auto& surface : scene.surfaces) {
    for (const auto& point : surface.points)
      sum += weights.dot (point.cast<double>());
    sum += surface.radius + weights.dot (surface.color.cast<double>());
    points += surface.points.size();
  }
  const Eigen::Vector3f eye = scene.camera_to_base.translation();
  const Eigen::Vector3f forward = scene.camera_to_base.linear().col (2);
  return sum / static_cast<double> (points) +
         weights.dot ((eye + forward).cast<double>());
}

} // namespace

/** A compiler that draws random numbers in another order gives other scenes. */
TEST (SceneLayout, IsTheSameWithAllCompilers)
{
  const std::pair<const char*, double> expected[] = {{"table_single", 7.176205},
                                                     {"table_cluttered", 8.011991},
                                                     {"room", 9.183},
                                                     {"corridor", 10.797452},
                                                     {"floor_obstacles", 6.047429},
                                                     {"worktop", 9.160557},
                                                     {"crockery", 8.140892}};
  ASSERT_EQ (std::size (expected), sceneNames().size());
  for (const auto& [name, sum] : expected)
    EXPECT_NEAR (layout (makeScene (name, 1)), sum, 1e-5) << name;
}
