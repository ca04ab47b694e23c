// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "synthetic_clouds.h"

#include <pcl/apps/app_error.h>
#include <pcl/apps/normal_comparison.h>
#include <pcl/common/angles.h>
#include <pcl/common/io.h>
#include <pcl/simulation/simulate.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace pcl::rgbd_planes;

namespace {

pcl::Normal
makeNormal (const Eigen::Vector3f& n)
{
  return {n.x(), n.y(), n.z()};
}

/** A direction that is \a degrees away from \a n. */
Eigen::Vector3f
rotate (const Eigen::Vector3f& n, float degrees)
{
  return Eigen::AngleAxisf (pcl::deg2rad (degrees), n.unitOrthogonal()) * n;
}

const Eigen::Vector3f toward_camera (0.f, 0.f, -1.f);
const pcl::Normal no_normal = makeNormal (Eigen::Vector3f::Constant (synthetic::nan));

/** The ideal image of a plane; the truth is off by \a degrees_left in the left half,
 * which is marked as edges, and by \a degrees_right in the right one. */
Frame
makeFrame (float degrees_left, float degrees_right)
{
  const synthetic::Surface plane = synthetic::tiltedPlane (1.f, 10.f, 5.f);
  const synthetic::Scene scene = synthetic::render ({plane}, 320, 240);
  Frame frame;
  frame.name = "plane";
  frame.cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>>();
  pcl::copyPointCloud (*scene.cloud, *frame.cloud);
  frame.truth = pcl::make_shared<pcl::PointCloud<TruthPoint>> (320, 240);
  for (std::uint32_t v = 0; v < 240; ++v)
    for (std::uint32_t u = 0; u < 320; ++u) {
      TruthPoint& truth = frame.truth->at (u, v);
      truth.edge = u < 160 ? 1 : 0;
      truth.getNormalVector3fMap() =
          rotate (plane.normal, u < 160 ? degrees_left : degrees_right);
    }
  return frame;
}

float
nearRadius (float z)
{
  return 0.01f + 0.01f * z;
}

NormalResult
find (const NormalComparison& comparison, const std::string& method)
{
  const auto& results = comparison.results();
  const auto found = std::find_if (results.begin(), results.end(), [&] (const auto& r) {
    return r.method == method;
  });
  if (found == results.end())
    throw std::runtime_error ("no result for " + method);
  return *found;
}

} // namespace

TEST (NormalDeviations, RotationBySevenDegrees)
{
  NormalDeviations deviations;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3f n = Eigen::Vector3f::Random().normalized();
    deviations.add (makeNormal (n), makeNormal (rotate (n, 7.f)));
  }
  EXPECT_NEAR (deviations.mean(), 7., 1e-3);
  EXPECT_NEAR (deviations.median(), 7., 0.01);
  EXPECT_EQ (deviations.over25Percent(), 0.);
  EXPECT_EQ (deviations.coveragePercent(), 100.);
}

TEST (NormalDeviations, PoolsAllPoints)
{
  NormalDeviations deviations;
  for (const float degrees : {1.f, 1.f, 3.f, 24.9f, 25.1f})
    deviations.add (makeNormal (toward_camera),
                    makeNormal (rotate (toward_camera, degrees)));
  EXPECT_NEAR (deviations.mean(), (1. + 1. + 3. + 24.9 + 25.1) / 5., 1e-3);
  EXPECT_NEAR (deviations.median(), 3., 0.01);
  EXPECT_DOUBLE_EQ (deviations.over25Percent(), 20.);
}

TEST (NormalDeviations, OtherSideIs180Degrees)
{
  NormalDeviations deviations;
  deviations.add (makeNormal (toward_camera), makeNormal (-toward_camera));
  EXPECT_NEAR (deviations.mean(), 180., 1e-3);
  EXPECT_NEAR (deviations.median(), 180., 0.01);
  EXPECT_EQ (deviations.over25Percent(), 100.);
}

TEST (NormalDeviations, LengthDoesNotMatter)
{
  NormalDeviations deviations;
  deviations.add (makeNormal (2.f * toward_camera),
                  makeNormal (0.1f * rotate (toward_camera, 7.f)));
  EXPECT_NEAR (deviations.mean(), 7., 1e-3);
}

TEST (NormalDeviations, CoverageIsOfPointsWithReference)
{
  NormalDeviations deviations;
  const pcl::Normal normal = makeNormal (toward_camera);
  deviations.add (no_normal, normal);
  deviations.add (no_normal, no_normal);
  deviations.add (normal, no_normal);
  deviations.add (normal, makeNormal (Eigen::Vector3f::Zero()));
  deviations.add (normal, normal);
  deviations.add (normal, normal);
  EXPECT_DOUBLE_EQ (deviations.coveragePercent(), 50.);
  EXPECT_DOUBLE_EQ (deviations.mean(), 0.);
}

TEST (NormalDeviations, NothingToCompare)
{
  NormalDeviations deviations;
  EXPECT_TRUE (std::isnan (deviations.mean()));
  EXPECT_TRUE (std::isnan (deviations.median()));
  EXPECT_TRUE (std::isnan (deviations.over25Percent()));
  EXPECT_TRUE (std::isnan (deviations.coveragePercent()));
  deviations.add (makeNormal (toward_camera), no_normal);
  EXPECT_TRUE (std::isnan (deviations.mean()));
  EXPECT_TRUE (std::isnan (deviations.median()));
  EXPECT_EQ (deviations.coveragePercent(), 0.);
}

TEST (NormalComparison, TruthRotatedBySevenDegrees)
{
  NormalComparison comparison ({1, 2}, nearRadius);
  comparison.add (makeFrame (7.f, 7.f));
  for (const NormalResult& result : comparison.results()) {
    EXPECT_EQ (result.reference, "truth");
    EXPECT_EQ (result.milliseconds.size(), 1u);
  }
  // The depth is perfect; what remains are the approximations of the methods.
  for (const std::string method :
       {"tangent", "two_run_pca", "pcl_covariance_matrix_10"})
    EXPECT_NEAR (find (comparison, method).all.mean(), 7., 0.1) << method;
  EXPECT_GT (find (comparison, "two_run_pca").all.coveragePercent(), 99.9);
  EXPECT_LT (find (comparison, "pcl_covariance_matrix_10").all.coveragePercent(), 99.);
}

TEST (TwoRunPca, FindsTrueNormalsOfPlanesFromIdealDepth)
{
  const NormalMethod two_run = twoRunMethod (nearRadius, 0);
  for (const std::string& scene : sceneNames()) {
    const SimulatedFrame frame = simulate (scene, 1, Sensor::ideal);
    const auto cloud = pcl::make_shared<synthetic::Cloud>();
    pcl::copyPointCloud (*frame.cloud, *cloud);
    pcl::PointCloud<pcl::Normal> normals;
    two_run.compute (cloud, normals);
    NormalDeviations deviations;
    for (std::size_t i = 0; i < normals.size(); ++i)
      if ((*frame.truth)[i].label != 0)
        deviations.add (makeNormal ((*frame.truth)[i].getNormalVector3fMap()),
                        normals[i]);
    EXPECT_LT (deviations.median(), 0.2) << scene;
    EXPECT_GT (deviations.coveragePercent(), 98.) << scene;
  }
}

TEST (NormalComparison, EdgesAndInterior)
{
  NormalComparison comparison ({1}, nearRadius);
  comparison.add (makeFrame (30.f, 2.f));
  const NormalResult result = find (comparison, "two_run_pca");
  EXPECT_NEAR (result.edges.mean(), 30., 0.1);
  EXPECT_NEAR (result.interior.mean(), 2., 0.1);
  EXPECT_NEAR (result.all.mean(), 16., 0.1);
  EXPECT_NEAR (result.all.over25Percent(), 50., 0.1);
}

TEST (NormalComparison, TangentOverThePointsOfAnother)
{
  // PCL leaves out the border, and there alone the truth is off by 90 degrees.
  Frame frame = makeFrame (0.f, 0.f);
  const Eigen::Vector3f n = frame.truth->at (160, 120).getNormalVector3fMap();
  for (std::uint32_t v = 0; v < 240; ++v)
    for (std::uint32_t u = 0; u < 320; ++u)
      if (std::min ({u, v, 319 - u, 239 - v}) < 5)
        frame.truth->at (u, v).getNormalVector3fMap() = n.unitOrthogonal();
  NormalComparison comparison ({1}, nearRadius);
  comparison.add (frame);
  const NormalResult tangent = find (comparison, "tangent");
  const NormalResult pcl_mode = find (comparison, "pcl_covariance_matrix_10");
  EXPECT_GT (tangent.all.mean(), 5.);
  EXPECT_EQ (tangent.tangent_there.mean(), tangent.all.mean());
  EXPECT_LT (pcl_mode.tangent_there.mean(), 0.1);
  EXPECT_LT (pcl_mode.tangent_there_edges.mean(), 0.1);
  EXPECT_EQ (pcl_mode.tangent_there.coveragePercent(), 100.);
}

TEST (NormalComparison, RadiusOfTwoRunPca)
{
  // Neighbouring pixels are more than 1 mm apart.
  NormalComparison comparison ({1}, [] (float) { return 0.001f; });
  comparison.add (makeFrame (0.f, 0.f));
  EXPECT_EQ (find (comparison, "two_run_pca").all.coveragePercent(), 0.);
}

TEST (NormalComparison, OnlyMeasuredPointsCount)
{
  Frame frame = makeFrame (7.f, 7.f);
  for (std::size_t i = 0; i < frame.cloud->size() / 3; ++i)
    (*frame.cloud)[i].getVector3fMap().setConstant (synthetic::nan);
  NormalComparison comparison ({1}, nearRadius);
  comparison.add (frame);
  EXPECT_GT (find (comparison, "two_run_pca").all.coveragePercent(), 99.9);
}

TEST (NormalComparison, TwoRunPcaIsTheReferenceWithoutTruth)
{
  Frame frame = makeFrame (0.f, 0.f);
  frame.truth.reset();
  NormalComparison comparison ({1, 4}, nearRadius);
  comparison.add (frame);
  comparison.add (frame);
  for (const NormalResult& result : comparison.results()) {
    EXPECT_EQ (result.reference, "two_run_pca");
    EXPECT_NE (result.method, "two_run_pca");
    EXPECT_EQ (result.milliseconds.size(), 2u);
    EXPECT_TRUE (std::isnan (result.edges.coveragePercent()));
  }
  EXPECT_LT (find (comparison, "tangent").all.mean(), 0.1);
}

TEST (NormalComparison, TooSmallFrame)
{
  Frame frame = makeFrame (0.f, 0.f);
  pcl::PointCloud<pcl::PointXYZRGB> small (39, 60, frame.cloud->at (0, 0));
  *frame.cloud = small;
  frame.truth.reset();
  NormalComparison comparison ({1}, nearRadius);
  EXPECT_THROW (comparison.add (frame), AppError);
}
