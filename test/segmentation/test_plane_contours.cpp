// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "refined_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

using namespace plane_clouds;
using namespace refined_planes;

namespace {

/** The border of columns u0 ... u1 - 1, rows v0 ... v1 - 1 of an image, clockwise from
 * its upper left corner. */
pcl::Indices
border (int width, int u0, int u1, int v0, int v1)
{
  pcl::Indices pixels;
  for (int u = u0; u < u1; ++u)
    pixels.push_back (v0 * width + u);
  for (int v = v0 + 1; v < v1; ++v)
    pixels.push_back (v * width + u1 - 1);
  for (int u = u1 - 2; u >= u0; --u)
    pixels.push_back ((v1 - 1) * width + u);
  for (int v = v1 - 2; v > v0; --v)
    pixels.push_back (v * width + u0);
  return pixels;
}

} // namespace

TEST (PlaneContours, OfARectangleIsItsBorderAndOfAWallTheEdgeOfTheImage)
{
  const std::vector<Surface> surfaces{tiltedPlane (2.f, 10.f, 20.f),
                                      board (100, 300, 80, 200)};
  const Scene scene = render (surfaces);
  const Refined refined = refine (scene, surfaces);
  ASSERT_EQ (refined.boundaries.size(), 2u);
  EXPECT_EQ (refined.boundaries[0].indices, border (640, 0, 640, 0, 480));
  EXPECT_EQ (refined.boundaries[1].indices, border (640, 100, 300, 80, 200));
  ASSERT_EQ (refined.regions.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& contour = refined.regions[k].getContour();
    ASSERT_EQ (contour.size(), refined.boundaries[k].indices.size());
    for (std::size_t i = 0; i < contour.size(); ++i)
      ASSERT_EQ (contour[i].getVector3fMap(),
                 (*scene.cloud)[refined.boundaries[k].indices[i]].getVector3fMap());
  }
}

TEST (PlaneContours, ReachEveryEdgeOfTheImage)
{
  const Surface wall = tiltedPlane (2.f, 0.f, 20.f);
  for (const auto& [u0, u1, v0, v1] :
       std::vector<std::array<int, 4>>{{0, 90, 0, 70},
                                       {250, 320, 0, 70},
                                       {0, 90, 170, 240},
                                       {250, 320, 170, 240},
                                       {0, 320, 100, 140},
                                       {90, 130, 0, 240}}) {
    const std::vector<Surface> surfaces{wall, board (u0, u1, v0, v1)};
    const Refined refined = refine (render (surfaces, 320, 240), surfaces);
    ASSERT_EQ (refined.boundaries.size(), 2u);
    EXPECT_EQ (refined.boundaries[1].indices, border (320, u0, u1, v0, v1));
  }
}

TEST (PlaneContours, BelongToTheLargestPart)
{
  const std::vector<Surface> surfaces{tiltedPlane (2.f, 0.f, 20.f),
                                      board (100, 120, 0, 240)};
  const Refined refined = refine (render (surfaces, 320, 240), surfaces);
  ASSERT_EQ (refined.boundaries.size(), 2u);
  EXPECT_EQ (refined.boundaries[0].indices, border (320, 120, 320, 0, 240));
  EXPECT_EQ (refined.regions[0].getCount(), 300u * 240u) << "of all parts";
}

TEST (PlaneContours, AreProjectedOnRequest)
{
  const Scene scene = render (corner(), 320, 240, kinectSigma);
  const Eigen::Vector3f sensor (0.5f, -2.f, 1.f);
  for (auto& point : *scene.cloud)
    point.getVector3fMap() += sensor;
  scene.cloud->sensor_origin_.head<3>() = sensor;
  Ours segmentation;
  segmentation.setMinInliers (250);
  EXPECT_FALSE (segmentation.getProjectPoints());
  const Refined measured = refine (scene, corner(), segmentation);
  segmentation.setProjectPoints (true);
  EXPECT_TRUE (segmentation.getProjectPoints());
  const Refined projected = refine (scene, corner(), segmentation);
  ASSERT_EQ (projected.regions.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector4f plane = projected.regions[k].getCoefficients();
    float furthest = 0.f;
    ASSERT_EQ (projected.boundaries[k].indices, measured.boundaries[k].indices);
    for (std::size_t i = 0; i < projected.boundaries[k].indices.size(); ++i) {
      const Eigen::Vector3f p = measured.regions[k].getContour()[i].getVector3fMap();
      const Eigen::Vector3f q = projected.regions[k].getContour()[i].getVector3fMap();
      EXPECT_NEAR (plane.head<3>().dot (q) + plane[3], 0.f, 2e-6f);
      // The same pixel, as with PCL's class.
      EXPECT_NEAR ((q - sensor).cross ((p - sensor).normalized()).norm(), 0.f, 2e-6f);
      furthest = std::max (furthest, (q - p).norm());
    }
    EXPECT_GT (furthest, 0.003f);
  }
}
