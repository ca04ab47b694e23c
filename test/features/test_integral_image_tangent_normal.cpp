// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "synthetic_clouds.h"

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/features/normal_3d.h>
#include <pcl/features/two_run_normal.h>
#include <pcl/io/pcd_io.h>
#include <pcl/kdtree/kdtree_flann.h>

#include <gtest/gtest.h>

#include <algorithm>

using synthetic::angleDegrees;
using synthetic::Cloud;
using synthetic::render;
using synthetic::Scene;
using synthetic::Surface;
using synthetic::tiltedPlane;
using Estimation =
    pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal>;
using Normals = pcl::PointCloud<pcl::Normal>;

namespace {

Normals
estimate (Estimation& estimation, const Cloud::ConstPtr& cloud)
{
  Normals normals;
  estimation.setInputCloud (cloud);
  estimation.compute (normals);
  return normals;
}

Normals
estimate (const Cloud::ConstPtr& cloud)
{
  Estimation estimation;
  return estimate (estimation, cloud);
}

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

bool
sameNormal (const pcl::Normal& a, const pcl::Normal& b)
{
  return std::equal (a.data_n, a.data_n + 3, b.data_n) && a.curvature == b.curvature;
}

} // namespace

TEST (TangentNormals, TiltedPlaneIsExactAtEveryResolution)
{
  for (const int divisor : {1, 2, 4})
    for (const auto& tilt :
         {std::pair (0.f, 0.f), {30.f, 0.f}, {-20.f, 40.f}, {0.f, 60.f}}) {
      const std::vector<Surface> plane{tiltedPlane (1.5f, tilt.first, tilt.second)};
      const Scene scene = render (plane, 640 / divisor, 480 / divisor);
      const Normals normals = estimate (scene.cloud);
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
  const Normals normals = estimate (scene.cloud);
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
  EXPECT_LE (largestErrorDegrees (scene, planes, estimate (scene.cloud)), 0.1f);

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

TEST (TangentNormals, SmoothingGrowsWithRange)
{
  const auto meanError = [] (float depth, bool depth_dependent) {
    const std::vector<Surface> plane{tiltedPlane (depth, 0.f, 0.f)};
    const Scene scene = render (plane, 320, 240, [] (float z) { return 0.001f * z; });
    Estimation estimation;
    estimation.setDepthDependentSmoothing (depth_dependent);
    const Normals normals = estimate (estimation, scene.cloud);
    double sum = 0.;
    for (const auto& normal : normals)
      sum += angleDegrees (normal.getNormalVector3fMap(), plane[0].normal);
    return sum / static_cast<double> (normals.size());
  };
  EXPECT_NEAR (meanError (4.f, false), meanError (1.f, false), 0.1);
  EXPECT_LT (meanError (4.f, true), 0.5 * meanError (4.f, false));
}

TEST (TangentNormals, CurvatureTellsACreaseFromAPlane)
{
  const std::vector<Surface> crease{tiltedPlane (1.f, 0.f, 40.f),
                                    tiltedPlane (1.f, 0.f, -40.f)};
  const Scene scene = render (crease, 320, 240);
  const Normals normals = estimate (scene.cloud);
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

TEST (TangentNormals, BorderPolicyIgnoreLeavesTheBorderOut)
{
  const Scene scene = render ({tiltedPlane (1.f, 0.f, 0.f)}, 64, 48);
  Estimation estimation;
  estimation.setRectSize (8, 4);
  estimation.setBorderPolicy (Estimation::BORDER_POLICY_IGNORE);
  const Normals normals = estimate (estimation, scene.cloud);
  for (int v = 0; v < 48; ++v)
    for (int u = 0; u < 64; ++u)
      EXPECT_EQ (std::isfinite (normals (u, v).normal_x),
                 u >= 4 && u < 60 && v >= 2 && v < 46)
          << u << " " << v;
}

TEST (TangentNormals, BadInputGivesAnErrorAndAnEmptyOutput)
{
  const auto isRefused = [] (Estimation& estimation) {
    Normals normals (3, 2);
    estimation.compute (normals);
    return normals.empty() && normals.width == 0 && normals.height == 0;
  };
  Estimation estimation;
  EXPECT_TRUE (isRefused (estimation)) << "no cloud";
  estimation.setInputCloud (nullptr);
  EXPECT_TRUE (isRefused (estimation)) << "null";
  estimation.setInputCloud (pcl::make_shared<Cloud>());
  EXPECT_TRUE (isRefused (estimation)) << "empty";
  estimation.setInputCloud (pcl::make_shared<Cloud> (100, 1));
  EXPECT_TRUE (isRefused (estimation)) << "unorganized";
  auto torn = pcl::make_shared<Cloud> (10, 10);
  torn->points.resize (50);
  estimation.setInputCloud (torn);
  EXPECT_TRUE (isRefused (estimation)) << "fewer points than width x height";

  estimation.setInputCloud (render ({tiltedPlane (1.f, 0.f, 0.f)}, 8, 8).cloud);
  for (const int index : {-1, 64}) {
    estimation.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{0, index}));
    EXPECT_TRUE (isRefused (estimation)) << "index " << index;
  }
}

TEST (TangentNormals, IndicesGiveOneNormalEach)
{
  const Scene scene =
      render ({tiltedPlane (1.f, 10.f, 0.f)}, 40, 30, [] (float) { return 0.002f; });
  const Normals all = estimate (scene.cloud);

  pcl::Indices reversed (all.size());
  for (std::size_t i = 0; i < reversed.size(); ++i)
    reversed[i] = static_cast<pcl::index_t> (all.size() - 1 - i);
  for (const pcl::Indices& indices :
       {pcl::Indices{7, 3, 3, 1199}, reversed, pcl::Indices{}}) {
    Estimation estimation;
    estimation.setIndices (pcl::make_shared<pcl::Indices> (indices));
    const Normals some = estimate (estimation, scene.cloud);
    ASSERT_EQ (some.size(), indices.size());
    ASSERT_EQ (some.width, indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i)
      ASSERT_TRUE (sameNormal (some[i], all[indices[i]]));
  }
}

TEST (TangentNormals, ObjectsAreReusableAndCopyable)
{
  const Scene large = render ({tiltedPlane (1.f, 10.f, 0.f)}, 160, 120);
  const Scene small = render ({tiltedPlane (2.f, 0.f, 30.f)}, 33, 17);
  Estimation used;
  estimate (used, large.cloud);
  Estimation copy = used;
  for (Estimation* estimation : {&used, &copy}) {
    const Normals normals = estimate (*estimation, small.cloud);
    const Normals expected = estimate (small.cloud);
    ASSERT_EQ (normals.size(), expected.size());
    for (std::size_t i = 0; i < normals.size(); ++i)
      ASSERT_TRUE (sameNormal (normals[i], expected[i]));
  }
}

TEST (TangentNormals, NormalsFaceTheViewpoint)
{
  const Scene scene = render ({tiltedPlane (1.f, 0.f, 0.f)}, 32, 24);
  scene.cloud->sensor_origin_ = Eigen::Vector4f (0.f, 0.f, 3.f, 0.f);
  Estimation estimation;
  EXPECT_NEAR (estimate (estimation, scene.cloud)[100].normal_z, 1.f, 1e-3f);
  estimation.setViewPoint (0.f, 0.f, 0.f);
  EXPECT_NEAR (estimate (estimation, scene.cloud)[100].normal_z, -1.f, 1e-3f);
  estimation.useSensorOriginAsViewPoint();
  const Normals normals = estimate (estimation, scene.cloud);
  EXPECT_NEAR (normals[100].normal_z, 1.f, 1e-3f);
  EXPECT_EQ (normals.sensor_origin_, scene.cloud->sensor_origin_);
}

TEST (TangentNormals, ActsAsAFeatureAndCopiesCoordinates)
{
  const Scene scene = render ({tiltedPlane (1.f, 20.f, 0.f)}, 32, 24);
  pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::PointNormal> estimation;
  pcl::Feature<pcl::PointXYZ, pcl::PointNormal>& feature = estimation;
  feature.setInputCloud (scene.cloud);
  feature.setKSearch (10);
  pcl::PointCloud<pcl::PointNormal> output;
  feature.compute (output);
  ASSERT_EQ (output.size(), scene.cloud->size());
  EXPECT_EQ (output (5, 6).getVector3fMap(), (*scene.cloud) (5, 6).getVector3fMap());
  EXPECT_TRUE (std::isfinite (output (5, 6).normal_z));
}

TEST (TangentNormals, BadSettingsAreRefused)
{
  const Scene scene =
      render ({tiltedPlane (1.f, 10.f, 0.f)}, 40, 30, [] (float) { return 0.002f; });
  Estimation estimation;
  estimation.setNormalSmoothingSize (0.f);
  estimation.setNormalSmoothingSize (synthetic::nan);
  estimation.setRectSize (0, 5);
  estimation.setMaxDepthChangeFactor (-1.f);
  const Normals normals = estimate (estimation, scene.cloud);
  const Normals expected = estimate (scene.cloud);
  for (std::size_t i = 0; i < normals.size(); ++i)
    ASSERT_TRUE (sameNormal (normals[i], expected[i]));
  estimation.setNormalSmoothingSize (1e9f); // larger than any image
  EXPECT_EQ (estimate (estimation, scene.cloud).size(), expected.size());
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
    const Normals normals = estimate (cloud);
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
