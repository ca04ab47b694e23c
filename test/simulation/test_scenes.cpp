// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "scenes.h"
#include "true_edges.h"

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
                                                     {"crockery", 8.140892},
                                                     {"shelf", 8.664177}};
  ASSERT_EQ (std::size (expected), sceneNames().size());
  for (const auto& [name, sum] : expected)
    EXPECT_NEAR (layout (makeScene (name, 1)), sum, 1e-5) << name;
}

TEST (SceneTruth, RoundWallsAreNoPlanesAndEndAtTheirRims)
{
  enum : std::uint32_t { outside = 1u << 16, inside = 1u << 17 };
  const auto frame = simulate ("crockery", 1, Sensor::ideal);
  pcl::PointCloud<pcl::Label> walls (640, 480); // the plane, or the side of a vessel
  std::size_t round = 0, flat = 0;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const auto& point = (*frame.truth)[i];
    walls[i].label = point.label;
    if (point.object == 0)
      continue;
    const TrueObject& object = frame.objects[point.object - 1];
    if (object.shape != TrueObject::Shape::cylinder)
      continue;
    const Eigen::Affine3f to_object = object.pose.inverse();
    const Eigen::Vector3f normal = to_object.linear() * point.getNormalVector3fMap();
    const Eigen::Vector3f radial = to_object * point.getVector3fMap();
    ASSERT_EQ (point.label != 0, normal.z() > 0.999f) << point.object;
    if (point.label == 0)
      walls[i].label = point.object +
                       (normal.head<2>().dot (radial.head<2>()) > 0 ? outside : inside);
    ++(point.label == 0 ? round : flat);
  }
  EXPECT_GT (round, 10000u);
  EXPECT_GT (flat, 1000u);
  expectEdgesBetween (walls, *frame.truth);
}
