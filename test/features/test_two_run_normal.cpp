// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "normal_clouds.h"

#include <pcl/console/print.h>
#include <pcl/features/normal_3d.h>
#include <pcl/features/two_run_normal.h>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

using synthetic::angleDegrees;
using synthetic::tiltedPlane;
using namespace normal_clouds;
using Estimation = pcl::TwoRunNormalEstimation<pcl::PointXYZ, pcl::Normal>;

namespace {

/** Principal component analysis of \a points (columns), in the obvious way. */
Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>
analyse (const Eigen::Matrix3Xd& points, const Eigen::VectorXd& weights)
{
  const Eigen::Vector3d mean = points * weights / weights.sum();
  const Eigen::Matrix3Xd centred = points.colwise() - mean;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> (
      centred * weights.asDiagonal() * centred.transpose() / weights.sum());
}

/** Both runs for point \a i with the linear radius, all pairs tried; NaN where fewer
 * than three neighbours are there. \a window: only neighbours so many pixels away at
 * most. */
pcl::Normal
oracle (const Cloud& cloud, std::size_t i, int window)
{
  if (isHole (cloud[i]))
    return {synthetic::nan, synthetic::nan, synthetic::nan, synthetic::nan};
  const Eigen::Vector3d p = cloud[i].getVector3fMap().cast<double>();
  const double radius = 0.01 + 0.01 * p.z();
  const int width = static_cast<int> (cloud.width), at = static_cast<int> (i);
  Eigen::Matrix3Xd neighbours (3, cloud.size());
  Eigen::Index count = 0;
  for (int j = 0; j < static_cast<int> (cloud.size()); ++j) {
    const Eigen::Vector3d q = cloud[j].getVector3fMap().cast<double>();
    const bool in_window = std::abs (j % width - at % width) <= window &&
                           std::abs (j / width - at / width) <= window;
    if (in_window && !isHole (cloud[j]) && (q - p).norm() < radius)
      neighbours.col (count++) = q;
  }
  if (count < 3)
    return {synthetic::nan, synthetic::nan, synthetic::nan, synthetic::nan};
  neighbours.conservativeResize (3, count);
  const Eigen::Vector3d first =
      analyse (neighbours, Eigen::VectorXd::Ones (count)).eigenvectors().col (0);
  const Eigen::ArrayXd distances =
      ((neighbours.colwise() - p).transpose() * first).array().abs();
  const double cutoff = 2.5 * std::sqrt (distances.square().mean());
  const Eigen::ArrayXd weights =
      (distances < cutoff)
          .select ((1. - (distances / cutoff).square()).square(),
                   Eigen::ArrayXd::Zero (count));
  const auto second = analyse (neighbours, weights);
  Eigen::Vector3d normal = second.eigenvectors().col (0);
  if (normal.dot (p) > 0.)
    normal = -normal;
  const Eigen::Vector3f n = normal.cast<float>();
  return {n.x(),
          n.y(),
          n.z(),
          static_cast<float> (second.eigenvalues()[0] / second.eigenvalues().sum())};
}

void
expectLikeOracle (const Cloud& cloud, const Normals& normals, int window = 1000)
{
  ASSERT_EQ (normals.size(), cloud.size());
  for (std::size_t i = 0; i < cloud.size(); i += 13) {
    const pcl::Normal expected = oracle (cloud, i, window);
    ASSERT_EQ (pcl::isNormalFinite (normals[i]), pcl::isNormalFinite (expected)) << i;
    if (!pcl::isNormalFinite (expected))
      continue;
    ASSERT_LT (angleDegrees (normals[i].getNormalVector3fMap(),
                             expected.getNormalVector3fMap()),
               0.01)
        << i;
    ASSERT_NEAR (normals[i].curvature, expected.curvature, 1e-5) << i;
  }
}

} // namespace

TEST (TwoRunNormal, LikeOracleWithHoles)
{
  const Cloud::Ptr cloud = makeHoles();
  expectLikeOracle (*cloud, estimate<Estimation> (cloud));
}

TEST (TwoRunNormal, WindowLikeOracle)
{
  const Cloud::Ptr cloud = makeHoles();
  Estimation estimation;
  estimation.setInputCloud (cloud);
  estimation.setWindowSize (5);
  Normals normals;
  estimation.compute (normals);
  expectLikeOracle (*cloud, normals, 2);
}

TEST (TwoRunNormal, UnorganizedLikeOracle)
{
  const Cloud::Ptr cloud = makeHoles();
  cloud->width = static_cast<std::uint32_t> (cloud->size());
  cloud->height = 1;
  const Normals normals = estimate<Estimation> (cloud);
  EXPECT_EQ (normals.width, cloud->width);
  EXPECT_EQ (normals.height, 1u);
  expectLikeOracle (*cloud, normals);
}

TEST (TwoRunNormal, IdealPlane)
{
  const synthetic::Surface plane = tiltedPlane (1.f, 15.f, -10.f);
  for (const int width : {640, 320, 160}) {
    const Normals normals =
        estimate<Estimation> (synthetic::render ({plane}, width, width * 3 / 4).cloud);
    EXPECT_EQ (normals.width, width);
    EXPECT_EQ (normals.height, width * 3 / 4);
    EXPECT_TRUE (normals.is_dense);
    float worst = 0.f;
    for (const pcl::Normal& normal : normals)
      worst =
          std::max (worst, angleDegrees (normal.getNormalVector3fMap(), plane.normal));
    EXPECT_LT (worst, 0.02f);
  }
}

TEST (TwoRunNormal, CloserToTrueNormalsAtEdgesThanOneRun)
{
  const std::vector<synthetic::Surface> walls = twoWalls();
  const synthetic::Scene scene =
      synthetic::render (walls, 320, 240, [] (float) { return 0.0015f; });
  const Normals two_runs = estimate<Estimation> (scene.cloud);
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud (scene.cloud);
  estimation.setRadiusSearch (0.02);
  Normals one_run;
  estimation.compute (one_run);

  double two_run_error = 0., one_run_error = 0.;
  for (std::size_t i = 0; i < two_runs.size(); ++i) {
    const auto wall = static_cast<std::size_t> (scene.surface[i]);
    const Eigen::Vector3f p = (*scene.cloud)[i].getVector3fMap();
    const float to_other_wall = walls[1 - wall].normal.dot (p) + walls[1 - wall].d;
    if (std::abs (to_other_wall) > 0.01f + 0.01f * p.z())
      continue;
    two_run_error +=
        angleDegrees (two_runs[i].getNormalVector3fMap(), walls[wall].normal);
    one_run_error +=
        angleDegrees (one_run[i].getNormalVector3fMap(), walls[wall].normal);
  }
  EXPECT_GT (one_run_error, 0.);
  EXPECT_LT (two_run_error, 0.85 * one_run_error);
}

TEST (TwoRunNormal, RadiusFunctions)
{
  Estimation estimation;
  estimation.setInputCloud (makeHoles());
  Normals by_default, by_numbers, by_function;
  estimation.compute (by_default);
  estimation.setRadius (0.01f, 0.01f);
  estimation.compute (by_numbers);
  EXPECT_TRUE (sameBits (by_default, by_numbers));

  estimation.setRadius (0.005f, 0.005f, 0.02f);
  estimation.compute (by_numbers);
  EXPECT_FALSE (sameBits (by_default, by_numbers));
  estimation.setRadius (
      [] (float z) { return std::max (0.005f + 0.005f * z, 0.02f * z * z); });
  estimation.compute (by_function);
  EXPECT_TRUE (sameBits (by_function, by_numbers));

  estimation.setRadius ([] (float) { return 0.f; });
  estimation.compute (by_function);
  EXPECT_FALSE (by_function.is_dense);
  for (const pcl::Normal& normal : by_function)
    EXPECT_TRUE (std::isnan (normal.normal_x) && std::isnan (normal.curvature));
}

TEST (TwoRunNormal, RadiusGrowsAlongTheViewingAxis)
{
  // The camera in the world: its pose is in the cloud, as in a PCD file.
  const Cloud::Ptr in_camera = makeHoles();
  const Eigen::Isometry3f pose =
      Eigen::Translation3f (1.f, 2.f, 0.5f) *
      Eigen::AngleAxisf (2.f, Eigen::Vector3f (1.f, 1.f, -1.f).normalized());
  Cloud::Ptr in_world (new Cloud (*in_camera));
  for (pcl::PointXYZ& p : *in_world)
    p.getVector3fMap() = pose * p.getVector3fMap();
  in_world->sensor_origin_.head<3>() = pose.translation();
  in_world->sensor_orientation_ = Eigen::Quaternionf (pose.linear());

  const Normals expected = estimate<Estimation> (in_camera),
                normals = estimate<Estimation> (in_world);
  EXPECT_EQ (normals.sensor_origin_, in_world->sensor_origin_);
  EXPECT_TRUE (normals.sensor_orientation_.isApprox (in_world->sensor_orientation_));
  std::size_t different = 0;
  for (std::size_t i = 0; i < normals.size(); ++i)
    different +=
        angleDegrees (pose.linear().transpose() * normals[i].getNormalVector3fMap(),
                      expected[i].getNormalVector3fMap()) > 0.05;
  // Rounding moves the odd neighbour across the radius.
  EXPECT_LT (different, normals.size() / 100);

  // OpenNI drivers turn the axis backwards.
  in_camera->sensor_orientation_ = Eigen::Quaternionf (0.f, 1.f, 0.f, 0.f);
  EXPECT_TRUE (sameBits (estimate<Estimation> (in_camera), expected));
}

TEST (TwoRunNormal, AViewingAxisThatIsNotANumberIsTold)
{
  const Cloud::Ptr cloud =
      synthetic::render ({tiltedPlane (1.f, 0.f, 0.f)}, 8, 8).cloud;
  cloud->sensor_orientation_.x() = synthetic::nan;
  testing::internal::CaptureStderr();
  EXPECT_TRUE (estimate<Estimation> (cloud).empty());
  EXPECT_NE (testing::internal::GetCapturedStderr().find ("sensor_orientation_"),
             std::string::npos);
}

TEST (TwoRunNormal, WhereTheSecondRunLeavesALineThePlaneOfTheFirstOneStands)
{
  // Two points far off the plane that they make of a line do not count the second time.
  const Cloud::Ptr cloud (new Cloud);
  for (int i = -20; i <= 20; ++i)
    cloud->emplace_back (0.001f * static_cast<float> (i), 0.f, 1.f);
  cloud->emplace_back (0.f, 0.02f, 1.01f);
  cloud->emplace_back (0.f, -0.02f, 1.01f);
  Estimation estimation;
  estimation.setRadius (0.1f, 0.f);
  const Normals normals = estimate (estimation, cloud);
  EXPECT_GT (std::abs (normals[20].normal_z), 0.99f);
}

TEST (TwoRunNormal, TooFewNeighboursAndLines)
{
  Cloud::Ptr line (new Cloud (30, 1));
  for (std::size_t i = 0; i < line->size(); ++i)
    (*line)[i] = {
        0.001f * static_cast<float> (i), 0.0003f * static_cast<float> (i), 1.f};
  Cloud::Ptr image_line (new Cloud (10, 3));
  image_line->points = line->points;
  const Cloud::Ptr two (new Cloud (2, 1, pcl::PointXYZ (0.f, 0.f, 1.f)));
  const Cloud::Ptr pixel (new Cloud (1, 1, pcl::PointXYZ (0.f, 0.f, 1.f)));
  const Cloud::Ptr same (new Cloud (4, 4, pcl::PointXYZ (0.f, 0.f, 1.f)));
  const Cloud::Ptr nothing (new Cloud (4, 4, pcl::PointXYZ (synthetic::nan, 0.f, 1.f)));
  const Cloud::Ptr nothing_unorganized (
      new Cloud (4, 1, pcl::PointXYZ (0.f, 0.f, 0.f)));
  for (const auto& cloud :
       {line, image_line, two, pixel, same, nothing, nothing_unorganized}) {
    const Normals normals = estimate<Estimation> (cloud);
    ASSERT_EQ (normals.size(), cloud->size());
    EXPECT_FALSE (normals.is_dense);
    for (const pcl::Normal& normal : normals)
      EXPECT_TRUE (std::isnan (normal.normal_x) && std::isnan (normal.curvature));
  }
}
