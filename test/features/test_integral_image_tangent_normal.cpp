// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "normal_clouds.h"

#include <pcl/features/integral_image_tangent_normal.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using synthetic::angleDegrees;
using synthetic::render;
using synthetic::Scene;
using synthetic::Surface;
using synthetic::tiltedPlane;
using namespace normal_clouds;
using Estimation =
    pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal>;

namespace {

/** The largest angle to the true normals; NaN where a valid point has no normal. */
float
largestErrorDegrees (const Scene& scene,
                     const std::vector<Surface>& surfaces,
                     const Normals& normals)
{
  float largest = 0.f;
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (pcl::isFinite ((*scene.cloud)[i])) {
      const auto& truth = surfaces[static_cast<std::size_t> (scene.surface[i])].normal;
      const float error = angleDegrees (normals[i].getNormalVector3fMap(), truth);
      if (std::isnan (error))
        return error;
      largest = std::max (largest, error);
    }
  return largest;
}

} // namespace

/** At a quarter of the resolution, points that are seen more than 80 degrees off the normal
 * may be farther apart than the depth change factor allows. */
TEST (TangentNormals, TiltedPlaneIsExactAtEveryResolution)
{
  for (const int divisor : {1, 2, 4})
    for (const auto& tilt :
         {std::pair (0.f, 0.f), {30.f, 0.f}, {-20.f, 40.f}, {0.f, 60.f}}) {
      const Surface plane = tiltedPlane (1.5f, tilt.first, tilt.second);
      const Scene scene = render ({plane}, 640 / divisor, 480 / divisor);
      const Normals normals = estimate<Estimation> (scene.cloud);
      ASSERT_EQ (normals.width, scene.cloud->width);
      ASSERT_EQ (normals.height, scene.cloud->height);
      for (std::size_t i = 0; i < normals.size(); ++i) {
        const Eigen::Vector3f p = (*scene.cloud)[i].getVector3fMap();
        const float off_normal = angleDegrees (-p, plane.normal);
        if (scene.surface[i] < 0 || (divisor == 4 && off_normal > 80.f))
          continue;
        const auto& normal = normals[i];
        ASSERT_LE (angleDegrees (normal.getNormalVector3fMap(), plane.normal), 0.1f)
            << "tilt " << tilt.first << " " << tilt.second << ", divisor " << divisor
            << ", point " << i;
        ASSERT_NEAR (normal.getNormalVector3fMap().norm(), 1.f, 1e-5f);
        ASSERT_NEAR (normal.curvature, 0.f, 1e-5f);
      }
    }
}

TEST (TangentNormals, MissingPointsHaveNoNormalAndSpoilNoOther)
{
  const std::vector<Surface> plane{tiltedPlane (1.f, 25.f, -10.f)};
  Scene scene = render (plane, 320, 240);
  const float inf = std::numeric_limits<float>::infinity();
  const std::vector<Eigen::Vector3f> missing{
      {synthetic::nan, 0.f, 1.f}, {0.f, 0.f, inf}, {0.f, 0.f, 0.f}, {0.f, -inf, 1.f}};
  std::vector<bool> hole (scene.cloud->size(), false);
  std::mt19937 generator (3);
  for (std::size_t i = 0; i < hole.size(); ++i) {
    const std::size_t u = i % 320, v = i / 320;
    hole[i] =
        generator() % 4 == 0 || (u > 100 && u < 160 && v > 60 && v < 100) || u == 319;
    if (hole[i])
      (*scene.cloud)[i].getVector3fMap() = missing[i % missing.size()];
  }
  const Normals normals = estimate<Estimation> (scene.cloud);
  EXPECT_FALSE (normals.is_dense);
  for (std::size_t i = 0; i < hole.size(); ++i)
    if (hole[i]) {
      ASSERT_TRUE (std::isnan (normals[i].normal_x) &&
                   std::isnan (normals[i].curvature));
    }
    else {
      ASSERT_LE (angleDegrees (normals[i].getNormalVector3fMap(), plane[0].normal),
                 0.1f)
          << "pixel " << i;
    }
}

TEST (TangentNormals, NoTangentSpansADepthStep)
{
  const auto left = [] (int u, int) { return u < 150; };
  const std::vector<Surface> planes{{{0.f, 0.f, -1.f}, 1.f, left},
                                    {{0.f, 0.f, -1.f}, 2.f}};
  const Scene scene = render (planes, 320, 240);
  EXPECT_LE (largestErrorDegrees (scene, planes, estimate<Estimation> (scene.cloud)),
             0.1f);
}

/** A robot 15 cm high sees the floor 1.2 to 1.8 m away at less than 7 degrees: it does not take the
 * normals of a pole that stands on it. */
TEST (TangentNormals, FlatFloorKeepsItsNormalsBesideAPole)
{
  const auto pole = [] (int u, int v) { return u >= 150 && u < 156 && v <= 152; };
  const std::vector<Surface> planes{{{0.f, 0.f, -1.f}, 1.2f, pole},
                                    {{0.f, -1.f, 0.f}, 0.15f}};
  const Scene scene = render (planes, 320, 240);
  const Normals normals = estimate<Estimation> (scene.cloud);
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (scene.surface[i] == 1 && (*scene.cloud)[i].z < 1.8f) {
      ASSERT_LE (angleDegrees (normals[i].getNormalVector3fMap(), planes[1].normal),
                 5.f)
          << "column " << i % 320 << ", row " << i / 320;
    }
}

/** A step of less than the noise of depth is spanned, unless it changes depth too much. */
TEST (TangentNormals, DepthChangeFactorKeepsTangentsOffSmallSteps)
{
  const auto left = [] (int u, int) { return u < 150; };
  const std::vector<Surface> planes{{{0.f, 0.f, -1.f}, 1.f, left},
                                    {{0.f, 0.f, -1.f}, 1.006f}};
  const Scene scene = render (planes, 320, 240);
  Estimation estimation;
  estimation.setEdgeAware (false);
  EXPECT_GT (largestErrorDegrees (scene, planes, estimate (estimation, scene.cloud)),
             5.f);
  estimation.setMaxDepthChangeFactor (0.001f);
  EXPECT_LE (largestErrorDegrees (scene, planes, estimate (estimation, scene.cloud)),
             0.1f);
}

TEST (TangentNormals, CurvatureTellsACreaseFromAPlane)
{
  const std::vector<Surface> crease{tiltedPlane (1.f, 0.f, 40.f),
                                    tiltedPlane (1.f, 0.f, -40.f)};
  const Scene scene = render (crease, 320, 240);
  const Normals normals = estimate<Estimation> (scene.cloud);
  for (int v = 0; v < 240; ++v)
    for (int u = 0; u < 320; ++u) {
      const float distance = std::abs (static_cast<float> (u) - 159.5f);
      const float curvature = normals (u, v).curvature;
      if (distance < 1.f) {
        EXPECT_GT (curvature, 0.02f);
      }
      else if (distance > 10.f) {
        EXPECT_LT (curvature, 1e-5f);
      }
    }
}

TEST (TangentNormals, EdgeAwareKeepsCreasesSharp)
{
  const std::vector<Surface> crease{tiltedPlane (1.f, 0.f, 45.f),
                                    tiltedPlane (1.f, 0.f, -45.f)};
  const Scene scene =
      render (crease, 640, 480, [] (float z) { return 0.001f + 0.001f * z * z; });
  const auto meanError = [&] (bool edge_aware) {
    Estimation estimation;
    estimation.setEdgeAware (edge_aware);
    const Normals normals = estimate (estimation, scene.cloud);
    double sum = 0.;
    for (int v = 0; v < 480; ++v)
      for (int u = 310; u < 330; ++u) {
        const int surface = scene.surface[static_cast<std::size_t> (v * 640 + u)];
        sum += angleDegrees (normals (u, v).getNormalVector3fMap(),
                             crease[static_cast<std::size_t> (surface)].normal);
      }
    return sum / (480. * 20.);
  };
  EXPECT_LT (meanError (true), 0.6 * meanError (false));
}
