// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_clouds.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <random>

using namespace plane_clouds;

namespace {

struct Setting {
  float depth, degrees_x, degrees_y;
  pcl::rgbd_planes::DepthNoise noise;
};

/** What many measurements of a plane gave. */
struct Draws {
  std::vector<Eigen::Vector4d> planes;
  Eigen::Matrix4d predicted = Eigen::Matrix4d::Zero();

  Eigen::Matrix4d
  covariance () const
  {
    Eigen::Vector4d mean = Eigen::Vector4d::Zero();
    for (const auto& plane : planes)
      mean += plane / static_cast<double> (planes.size());
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    for (const auto& plane : planes)
      sum += (plane - mean) * (plane - mean).transpose();
    return sum / static_cast<double> (planes.size() - 1);
  }
};

/** Measures a plane that fills the image, with noise along the viewing rays, independent
 * for each point. */
Draws
measure (const Setting& setting, int times)
{
  const std::vector<Surface> surfaces{
      tiltedPlane (setting.depth, setting.degrees_x, setting.degrees_y)};
  const Scene scene = render (surfaces, 160, 120);
  Ours segmentation;
  segmentation.setMinInliers (1000);
  segmentation.setDepthNoise (setting.noise);
  segmentation.setDistanceThreshold (4. * setting.noise.sigmaAtSquare (1.f));
  segmentation.setInputNormals (trueNormals (scene, surfaces));
  std::mt19937 generator (5);
  std::normal_distribution<float> gauss;
  Draws draws;
  for (int i = 0; i < times; ++i) {
    auto cloud = pcl::make_shared<Cloud> (*scene.cloud);
    for (auto& point : *cloud) {
      const float range = point.getVector3fMap().norm();
      point.getVector3fMap() *=
          1.f + setting.noise.sigmaAtSquare (range * range) * gauss (generator) / range;
    }
    segmentation.setInputCloud (cloud);
    std::vector<pcl::ModelCoefficients> models;
    std::vector<pcl::PointIndices> inliers;
    segmentation.segment (models, inliers);
    if (models.size() != 1 || segmentation.getParameterCovariances().size() != 1)
      continue;
    draws.planes.push_back (Eigen::Vector4f (models[0].values.data()).cast<double>());
    draws.predicted += segmentation.getParameterCovariances()[0] / times;
  }
  return draws;
}

class PlaneCovariances : public ::testing::TestWithParam<Setting> {};

} // namespace

TEST_P (PlaneCovariances, AreThoseOfManyMeasurements)
{
  constexpr int times = 300;
  const Draws draws = measure (GetParam(), times);
  ASSERT_EQ (draws.planes.size(), static_cast<std::size_t> (times));
  const Eigen::Matrix4d covariance = draws.covariance();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> axes (draws.predicted);
  ASSERT_GT (axes.eigenvalues()[1], 0.);
  for (int i = 1; i < 4; ++i) {
    const Eigen::Vector4d axis = axes.eigenvectors().col (i);
    const double measured = std::sqrt (axis.dot (covariance * axis));
    const double predicted = std::sqrt (axes.eigenvalues()[i]);
    EXPECT_GT (predicted, 0.7 * measured) << "axis " << axis.transpose();
    EXPECT_LT (predicted, 1.4 * measured) << "axis " << axis.transpose();
  }
}

/** The length of (a, b, c) is 1 and does not vary. */
TEST_P (PlaneCovariances, HaveRankThree)
{
  const Draws draws = measure (GetParam(), 1);
  ASSERT_EQ (draws.planes.size(), 1u);
  EXPECT_TRUE (draws.predicted.isApprox (draws.predicted.transpose(), 1e-9));
  Eigen::Vector4d normal = draws.planes[0];
  normal[3] = 0.;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> axes (draws.predicted);
  EXPECT_GT (axes.eigenvalues()[1], 0.);
  EXPECT_LT ((draws.predicted * normal).norm(), 1e-3 * axes.eigenvalues()[1]);
}

INSTANTIATE_TEST_SUITE_P (
    Tilts,
    PlaneCovariances,
    ::testing::Values (
        Setting{2.f, 0.f, 0.f, pcl::rgbd_planes::DepthNoise::kinectV1()},
        Setting{1.5f, 0.f, 30.f, pcl::rgbd_planes::DepthNoise::kinectV1()},
        Setting{2.f, 40.f, 20.f, pcl::rgbd_planes::DepthNoise::kinectV1()},
        Setting{1.5f, -50.f, 0.f, pcl::rgbd_planes::DepthNoise::kinectV1()},
        Setting{2.5f, 0.f, 45.f, pcl::rgbd_planes::DepthNoise::timeOfFlight()}),
    [] (const auto& setting) { return "Setting" + std::to_string (setting.index); });
