// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "synthetic_clouds.h"

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/features/normal_3d.h>
#include <pcl/io/pcd_io.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/simulation/simulate.h>
#include <pcl/simulation/subsample.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

using synthetic::Cloud;

namespace {

/** The ranks of values, from 0; the mean rank for equal ones. */
Eigen::ArrayXd
ranks (const std::vector<float>& values)
{
  std::vector<std::size_t> order (values.size());
  std::iota (order.begin(), order.end(), 0);
  std::sort (order.begin(), order.end(), [&] (std::size_t a, std::size_t b) {
    return values[a] < values[b];
  });
  Eigen::ArrayXd result (values.size());
  for (std::size_t begin = 0, end; begin < order.size(); begin = end) {
    for (end = begin; end < order.size() && values[order[end]] == values[order[begin]];)
      ++end;
    for (std::size_t i = begin; i < end; ++i)
      result[order[i]] = 0.5 * static_cast<double> (begin + end - 1);
  }
  return result;
}

/** Spearman's rank correlation. */
double
rankCorrelation (const std::vector<float>& a, const std::vector<float>& b)
{
  Eigen::ArrayXd x = ranks (a), y = ranks (b);
  x -= x.mean();
  y -= y.mean();
  return (x * y).sum() / std::sqrt (x.square().sum() * y.square().sum());
}

/** Our curvatures, and those of the principal component analysis that
 * pcl::NormalEstimation does, over neighbours within a radius that spans as much as our
 * smoothing area. */
struct Curvatures {
  std::vector<float> ours, pca;

  void
  add (const Cloud::ConstPtr& cloud)
  {
    pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    estimation.setInputCloud (cloud);
    pcl::PointCloud<pcl::Normal> normals;
    estimation.compute (normals);
    pcl::KdTreeFLANN<pcl::PointXYZ> tree;
    tree.setInputCloud (cloud);
    pcl::Indices neighbours;
    std::vector<float> squared_distances;
    for (std::size_t i = 0; i < cloud->size(); ++i) {
      const pcl::PointXYZ& p = (*cloud)[i];
      const double radius = 0.03 * p.z;
      Eigen::Vector4f plane;
      float curvature;
      if (pcl::isFinite (p) && pcl::isNormalFinite (normals[i]) &&
          tree.radiusSearch (p, radius, neighbours, squared_distances) >= 3 &&
          pcl::computePointNormal (*cloud, neighbours, plane, curvature)) {
        // What is less is rounding, and its order means nothing.
        constexpr float flat = 1e-5f;
        ours.push_back (std::max (normals[i].curvature, flat));
        pca.push_back (std::max (curvature, flat));
      }
    }
  }

  void
  add (const Curvatures& more)
  {
    ours.insert (ours.end(), more.ours.begin(), more.ours.end());
    pca.insert (pca.end(), more.pca.begin(), more.pca.end());
  }
};

/** The rank correlation over the points of all clouds together; prints each. */
double
correlation (const std::vector<std::pair<std::string, Cloud::Ptr>>& clouds)
{
  Curvatures all;
  for (const auto& cloud : clouds) {
    Curvatures curvatures;
    curvatures.add (cloud.second);
    std::printf ("%s: %.3f over %zu points\n",
                 cloud.first.c_str(),
                 rankCorrelation (curvatures.ours, curvatures.pca),
                 curvatures.ours.size());
    all.add (curvatures);
  }
  const double together = rankCorrelation (all.ours, all.pca);
  std::printf ("all: %.3f over %zu points\n", together, all.ours.size());
  return together;
}

double
correlationInSimulation (pcl::rgbd_planes::Sensor sensor)
{
  std::vector<std::pair<std::string, Cloud::Ptr>> clouds;
  for (const std::string& scene : pcl::rgbd_planes::sceneNames()) {
    const auto frame = pcl::rgbd_planes::simulate (scene, 1, sensor);
    clouds.emplace_back (scene, pcl::make_shared<Cloud>());
    pcl::copyPointCloud (pcl::rgbd_planes::subsample (*frame.cloud, 4),
                         *clouds.back().second);
  }
  return correlation (clouds);
}

} // namespace

TEST (CurvatureOrder, RankCorrelation)
{
  EXPECT_NEAR (
      rankCorrelation ({1.f, 2.f, 3.f, 9.f}, {2.f, 3.f, 50.f, 51.f}), 1., 1e-9);
  EXPECT_NEAR (rankCorrelation ({1.f, 2.f, 3.f}, {3.f, 2.f, 1.f}), -1., 1e-9);
  // 1 - 6 (1 + 1 + 0 + 1 + 1) / (5 * 24)
  EXPECT_NEAR (rankCorrelation ({1.f, 2.f, 3.f, 4.f, 5.f}, {2.f, 1.f, 3.f, 5.f, 4.f}),
               0.8,
               1e-9);
  // Equal values share the rank 0.5: the correlation of (0.5, 0.5, 2) with (0, 1, 2).
  EXPECT_NEAR (
      rankCorrelation ({1.f, 1.f, 2.f}, {1.f, 2.f, 3.f}), std::sqrt (0.75), 1e-9);
}

TEST (CurvatureOrder, LikePcaOnIdealDepth)
{
  EXPECT_GE (correlationInSimulation (pcl::rgbd_planes::Sensor::ideal), 0.6);
}

TEST (CurvatureOrder, LikePcaOnKinectDepth)
{
  EXPECT_GE (correlationInSimulation (pcl::rgbd_planes::Sensor::kinect), 0.6);
}

TEST (CurvatureOrder, LikePcaOnRecordings)
{
  SKIP_WITHOUT_RECORDINGS();
  std::vector<std::pair<std::string, Cloud::Ptr>> clouds;
  for (const std::string name : {"learn0", "learn20", "learn40"}) {
    Cloud full;
    ASSERT_EQ (pcl::io::loadPCDFile (
                   synthetic::dataFolder() + "/mosd_learn/" + name + ".pcd", full),
               0);
    clouds.emplace_back (name, synthetic::subsample (full, 4));
  }
  EXPECT_GE (correlation (clouds), 0.5);
}
