// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "normal_clouds.h"

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/features/normal_3d.h>
#include <pcl/features/two_run_normal.h>
#include <pcl/io/pcd_io.h>
#include <pcl/kdtree/kdtree_flann.h>

#include <gtest/gtest.h>

#include <algorithm>

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
      if (!(error <= largest))
        largest = error;
    }
  return largest;
}

} // namespace

TEST (TangentNormals, TiltedPlaneIsExactAtEveryResolution)
{
  for (const int divisor : {1, 2, 4})
    for (const auto& tilt :
         {std::pair (0.f, 0.f), {30.f, 0.f}, {-20.f, 40.f}, {0.f, 60.f}}) {
      const std::vector<Surface> plane{tiltedPlane (1.5f, tilt.first, tilt.second)};
      const Scene scene = render (plane, 640 / divisor, 480 / divisor);
      const Normals normals = estimate<Estimation> (scene.cloud);
      ASSERT_EQ (normals.width, scene.cloud->width);
      ASSERT_EQ (normals.height, scene.cloud->height);
      EXPECT_LE (largestErrorDegrees (scene, plane, normals), 0.1f)
          << "tilt " << tilt.first << " " << tilt.second << ", divisor " << divisor;
      for (const auto& normal : normals)
        if (std::isfinite (normal.normal_x)) {
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

  Estimation no_gate;
  no_gate.setMaxDepthChangeFactor (10.f);
  EXPECT_GT (largestErrorDegrees (scene, planes, estimate (no_gate, scene.cloud)),
             20.f);
}

/** Section 3 of the paper, straight from its definition: the mean tangents of all
 * pixels in the window, each divided by the range of its pixel. */
TEST (TangentNormals, AgreeWithBruteForceAtOddSizes)
{
  std::mt19937 generator (5);
  std::uniform_real_distribution<float> random (-1.f, 1.f);
  for (const auto& size :
       {std::pair (1, 2), {2, 2}, {3, 5}, {2, 40}, {41, 2}, {31, 23}, {67, 8}}) {
    const int width = size.first, height = size.second, half_u = 2, half_v = 4;
    Scene scene = render ({tiltedPlane (1.f, 10.f, 20.f)}, width, height);
    for (auto& p : *scene.cloud)
      p.z = generator() % 8 == 0 ? synthetic::nan : p.z + 0.05f * random (generator);
    Estimation estimation;
    estimation.setRectSize (2 * half_u, 2 * half_v);
    estimation.setEdgeAware (false);
    const Normals normals = estimate (estimation, scene.cloud);

    const auto at = [&] (int u, int v) -> const pcl::PointXYZ& {
      return (*scene.cloud)[static_cast<std::size_t> (v * width + u)];
    };
    const auto neighbour = [&] (int u, int v, int du, int dv) {
      const auto& p = at (u, v);
      const int nu = u + du, nv = v + dv;
      if (nu < 0 || nv < 0 || nu >= width || nv >= height ||
          !pcl::isFinite (at (nu, nv)))
        return p;
      const float range = p.getVector3fMap().norm();
      const float step = std::abs (at (nu, nv).getVector3fMap().norm() - range);
      return step <= 0.04f * (range + 1.f) ? at (nu, nv) : p;
    };
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < width; ++u) {
        const auto& normal = normals[static_cast<std::size_t> (v * width + u)];
        Eigen::Vector3d sums[2] = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
        for (int y = std::max (v - half_v, 0); y <= std::min (v + half_v, height - 1);
             ++y)
          for (int x = std::max (u - half_u, 0); x <= std::min (u + half_u, width - 1);
               ++x)
            if (pcl::isFinite (at (x, y)))
              for (int k = 0; k < 2; ++k) {
                const auto before = neighbour (x, y, k - 1, -k);
                const auto after = neighbour (x, y, 1 - k, k);
                sums[k] += ((after.getVector3fMap() - before.getVector3fMap()) /
                            at (x, y).getVector3fMap().norm())
                               .cast<double>();
              }
        const Eigen::Vector3d n = sums[0].cross (sums[1]);
        if (!pcl::isFinite (at (u, v)) || n.norm() == 0.) {
          ASSERT_TRUE (std::isnan (normal.normal_x)) << u << " " << v;
          continue;
        }
        const Eigen::Vector3f expected =
            n.normalized().cast<float>() *
            (n.dot (at (u, v).getVector3fMap().cast<double>()) > 0. ? -1.f : 1.f);
        ASSERT_LE ((normal.getNormalVector3fMap() - expected).norm(), 1e-4f)
            << "at " << u << ", " << v << " of " << width << " x " << height;
      }
  }
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

/** The paper's estimator against PCL's own plane fit to all neighbours in a radius that
 * grows with range: neither of them knows edges. */
TEST (TangentNormals, AgreeWithPcaOnRecordings)
{
  SKIP_WITHOUT_RECORDINGS();
  for (const std::string name : {"learn0", "learn20", "learn40"}) {
    Cloud full;
    ASSERT_EQ (pcl::io::loadPCDFile (
                   synthetic::dataFolder() + "/mosd_learn/" + name + ".pcd", full),
               0);
    for (const unsigned step : {1u, 2u}) {
      const Cloud::Ptr cloud = synthetic::subsample (full, step);
      Estimation plain;
      plain.setEdgeAware (false);
      const Normals normals = estimate (plain, cloud);
      pcl::KdTreeFLANN<pcl::PointXYZ> tree;
      tree.setInputCloud (cloud);
      pcl::Indices neighbours;
      std::vector<float> squared_distances;
      double sum = 0.;
      std::size_t count = 0, missing = 0, far_off = 0;
      for (std::size_t i = 0; i < cloud->size(); i += 97) {
        const auto& p = (*cloud)[i];
        Eigen::Vector4f plane;
        float curvature;
        if (!pcl::isFinite (p) ||
            tree.radiusSearch (p, 0.01 + 0.01 * p.z, neighbours, squared_distances) <
                3 ||
            !pcl::computePointNormal (*cloud, neighbours, plane, curvature))
          continue;
        pcl::flipNormalTowardsViewpoint (p, 0.f, 0.f, 0.f, plane);
        ++count;
        const float angle =
            angleDegrees (normals[i].getNormalVector3fMap(), plane.head<3>());
        if (std::isnan (angle)) {
          ++missing;
          continue;
        }
        sum += angle;
        far_off += angle > 25.f;
      }
      ASSERT_GT (count, 300u);
      const auto total = static_cast<double> (count);
      RecordProperty (name + "_mean_degrees_" + std::to_string (step),
                      std::to_string (sum / total));
      EXPECT_LE (sum / total, 3.5) << name << " step " << step;
      EXPECT_LE (static_cast<double> (far_off) / total, 0.02)
          << name << " step " << step;
      EXPECT_LE (static_cast<double> (missing) / total, 0.001)
          << name << " step " << step;
    }
  }
}

/** Against principal component analysis in two runs, which is edge-aware as well; all
 * points count together, as in pcl_evaluate_normals. */
TEST (TangentNormals, AgreeWithTwoRunPcaOnRecordings)
{
  SKIP_WITHOUT_RECORDINGS();
  double sum = 0.;
  std::size_t count = 0, far_off = 0;
  for (const std::string name : {"learn0", "learn20", "learn40"}) {
    auto cloud = pcl::make_shared<Cloud>();
    ASSERT_EQ (pcl::io::loadPCDFile (
                   synthetic::dataFolder() + "/mosd_learn/" + name + ".pcd", *cloud),
               0);
    pcl::TwoRunNormalEstimation<pcl::PointXYZ, pcl::Normal> two_run;
    Normals reference;
    two_run.setInputCloud (cloud);
    two_run.compute (reference);
    const Normals normals = estimate<Estimation> (cloud);
    for (std::size_t i = 0; i < cloud->size(); ++i)
      if (std::isfinite (reference[i].normal_x)) {
        const float angle = angleDegrees (normals[i].getNormalVector3fMap(),
                                          reference[i].getNormalVector3fMap());
        ASSERT_FALSE (std::isnan (angle)) << name << " point " << i;
        ++count;
        sum += angle;
        far_off += angle > 25.f;
      }
  }
  EXPECT_LE (sum / static_cast<double> (count), 3.5);
  EXPECT_LE (static_cast<double> (far_off) / static_cast<double> (count), 0.02);
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
