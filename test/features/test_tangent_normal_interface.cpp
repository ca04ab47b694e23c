// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "normal_clouds.h"

#include <pcl/features/impl/set_parameter.h>
#include <pcl/features/integral_image_tangent_normal.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

using synthetic::angleDegrees;
using synthetic::render;
using synthetic::tiltedPlane;
using namespace normal_clouds;
using Estimation =
    pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal>;

namespace {

/** The mean angle to \a truth, in degrees; NaN if a normal is missing. */
double
meanErrorDegrees (const Normals& normals, const Eigen::Vector3f& truth)
{
  double sum = 0.;
  for (const auto& normal : normals)
    sum += angleDegrees (normal.getNormalVector3fMap(), truth);
  return sum / static_cast<double> (normals.size());
}

/** A few pixels of an image of \a plane. */
Cloud::Ptr
crop (const synthetic::Surface& plane, int width, int height)
{
  const Cloud::Ptr image = render ({plane}, 160, 120).cloud;
  const auto cloud = pcl::make_shared<Cloud> (width, height);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      (*cloud) (u, v) = (*image) (u, v);
  return cloud;
}

} // namespace

TEST (TangentNormalInterface, UnorganizedCloudsGiveOneErrorThatNamesTheCure)
{
  Estimation estimation;
  pcl::Feature<pcl::PointXYZ, pcl::Normal>* feature = &estimation;
  feature->setInputCloud (pcl::make_shared<Cloud> (100, 1));
  Normals normals (3, 2);
  ::testing::internal::CaptureStderr();
  feature->compute (normals);
  const std::string error = ::testing::internal::GetCapturedStderr();
  EXPECT_TRUE (normals.empty() && normals.width == 0 && normals.height == 0);
  EXPECT_EQ (std::count (error.begin(), error.end(), '\n'), 1) << error;
  EXPECT_NE (error.find ("ask your camera driver for ordered point clouds"),
             std::string::npos)
      << error;
}

TEST (TangentNormalInterface, SearchSurfacesOfUnorganizedCloudsAreExplained)
{
  Estimation estimation;
  estimation.setInputCloud (pcl::make_shared<Cloud> (100, 1));
  estimation.setSearchSurface (pcl::make_shared<Cloud> (10, 10));
  Normals normals;
  ::testing::internal::CaptureStderr();
  estimation.compute (normals);
  const std::string error = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ (std::count (error.begin(), error.end(), '\n'), 1) << error;
  EXPECT_NE (error.find ("setIndices takes the points"), std::string::npos) << error;
}

TEST (TangentNormalInterface, RefusedNumbersSayWhatStays)
{
  Estimation estimation;
  const auto errorOf = [&estimation] (float size) {
    ::testing::internal::CaptureStderr();
    estimation.setNormalSmoothingSize (size);
    return ::testing::internal::GetCapturedStderr();
  };
  EXPECT_NE (errorOf (0.f).find ("got 0. Keeping the default, which goes with the "
                                 "input."),
             std::string::npos);
  estimation.setNormalSmoothingSize (8.5f);
  EXPECT_NE (errorOf (-1.f).find ("got -1. Keeping 8.5."), std::string::npos);
  double share = 0.;
  ::testing::internal::CaptureStderr();
  pcl::rgbd_planes::setParameter (
      "set", 2., share, pcl::rgbd_planes::Zero::allowed, 1.);
  EXPECT_NE (::testing::internal::GetCapturedStderr().find (
                 "at least 0 and at most 1, got 2. Keeping 0."),
             std::string::npos);
}

/** Depth registered with a camera of twice the resolution, without filling holes. */
TEST (TangentNormalInterface, CloudsOfWhichFewPointsHaveANormalAreToldOnceInARow)
{
  const auto whole = render ({tiltedPlane (1.f, 10.f, 20.f)}, 64, 48).cloud;
  const auto interlaced =
      pcl::make_shared<Cloud> (64, 48, pcl::PointXYZ (0.f, 0.f, 0.f));
  for (int v = 0; v < 48; v += 2)
    for (int u = 0; u < 64; u += 2)
      (*interlaced) (u, v) = (*whole) (u, v);
  // Whole down to a row, and from there on every second one.
  const auto interlacedFrom = [&whole] (int row) {
    const auto cloud = pcl::make_shared<Cloud> (*whole);
    for (int v = row + 1; v < 48; v += 2)
      for (int u = 0; u < 64; ++u)
        (*cloud) (u, v) = {0.f, 0.f, 0.f};
    return cloud;
  };
  const auto covered = pcl::make_shared<Cloud> (64, 48, pcl::PointXYZ (0.f, 0.f, 0.f));
  (*covered) (20, 10) = (*whole) (20, 10);
  Estimation estimation;
  const auto warningFor = [&estimation] (const Cloud::ConstPtr& cloud) {
    ::testing::internal::CaptureStderr();
    estimate (estimation, cloud);
    return ::testing::internal::GetCapturedStderr();
  };
  for (int stream = 0; stream < 2; ++stream) {
    const std::string warning = warningFor (interlaced);
    EXPECT_NE (warning.find ("Only 0 of the 768 measured points have a normal"),
               std::string::npos)
        << warning;
    EXPECT_EQ (warningFor (interlaced), "") << "a stream of frames fills no log";
    EXPECT_EQ (warningFor (whole), "");
    EXPECT_EQ (warningFor (covered), "") << "a speck is no surface";
    EXPECT_EQ (warningFor (interlacedFrom (20)), "") << "most points have one";
    EXPECT_NE (warningFor (interlacedFrom (10)).find ("have a normal"),
               std::string::npos);
    EXPECT_EQ (warningFor (whole), "");
  }
  // Here it is the policy that leaves all points out.
  estimation.setBorderPolicy (Estimation::BORDER_POLICY_IGNORE);
  estimation.setNormalSmoothingSize (100.f);
  EXPECT_EQ (warningFor (whole), "");
}

TEST (TangentNormalInterface, BadSettingsAreRefused)
{
  const Cloud::Ptr cloud = makeHoles();
  Estimation estimation, expected;
  estimation.setNormalSmoothingSize (7.f);
  expected.setNormalSmoothingSize (7.f);
  estimation.setNormalSmoothingSize (0.f);
  estimation.setNormalSmoothingSize (synthetic::nan);
  estimation.setRectSize (0, 5);
  estimation.setRectSize (5, -1);
  estimation.setMaxDepthChangeFactor (-1.f);
  estimation.setDepthNoise ({0.001f, -0.001f});
  for (const float scatter : {0.f, 0.9f, 5.1f})
    estimation.setDepthNoise ({0.001f, 0.001f, 5.f, true, scatter});
  EXPECT_EQ (estimation.getDepthNoise().quadratic, 0.002f);
  EXPECT_TRUE (sameBits (estimate (estimation, cloud), estimate (expected, cloud)));
}

TEST (TangentNormalInterface,
      TheSizeIsThreeOf160PartsOfTheLongerSideInWholeCellsAndFourAtLeast)
{
  const auto noise = [] (float z) { return 0.001f * z; };
  for (const auto& [width, size] : {std::pair (1024, 20.f),
                                    {960, 20.f},
                                    {848, 16.f},
                                    {640, 10.f}, // of PCL's tutorials
                                    {640, 13.9f},
                                    {480, 8.f},
                                    {424, 8.f},
                                    {320, 6.f},
                                    {160, 4.f},
                                    {80, 4.f}}) {
    const Cloud::Ptr cloud =
        render ({tiltedPlane (1.f, 30.f, 20.f)}, width, width * 3 / 4, noise).cloud;
    Estimation estimation;
    const Normals normals = estimate (estimation, cloud);
    estimation.setNormalSmoothingSize (size);
    EXPECT_TRUE (sameBits (normals, estimate (estimation, cloud))) << width;
  }
}

TEST (TangentNormalInterface, DepthDependentSmoothingGrowsWithTheRootOfTheRange)
{
  // All ranges are 1.6 to 2.6 m: those of areas 1.4 times as large as at 1 m.
  const auto noise = [] (float z) { return 0.001f * z; };
  const Cloud::Ptr cloud =
      render ({tiltedPlane (1.9f, 0.f, 0.f)}, 160, 120, noise).cloud;
  Estimation growing, fixed;
  growing.setDepthDependentSmoothing (true);
  growing.setNormalSmoothingSize (10.f);
  fixed.setNormalSmoothingSize (14.f);
  for (Estimation* estimation : {&growing, &fixed}) {
    estimation->setEdgeAware (false);
    estimation->setScaleSelection (false);
  }
  const Normals normals = estimate (growing, cloud), expected = estimate (fixed, cloud);
  for (std::size_t i = 0; i < normals.size(); ++i)
    EXPECT_LT (angleDegrees (normals[i].getNormalVector3fMap(),
                             expected[i].getNormalVector3fMap()),
               0.1f)
        << i;
}

TEST (TangentNormalInterface, SettersTakeEffectInAnyOrder)
{
  const Cloud::Ptr cloud = makeHoles();
  const std::vector<std::function<void (Estimation&)>> setters{
      [] (Estimation& e) { e.setRectSize (7, 5); },
      [] (Estimation& e) { e.setDepthDependentSmoothing (true); },
      [] (Estimation& e) { e.setMaxDepthChangeFactor (0.01f); },
      [] (Estimation& e) { e.setBorderPolicy (Estimation::BORDER_POLICY_IGNORE); },
      [] (Estimation& e) { e.setViewPoint (0.f, 0.f, -0.5f); },
      [] (Estimation& e) { e.setEdgeAware (false); },
      [&] (Estimation& e) { e.setInputCloud (cloud); }};
  Normals forwards, backwards;
  Estimation first, second;
  for (const auto& set : setters)
    set (first);
  first.compute (forwards);
  std::for_each (setters.rbegin(), setters.rend(), [&] (const auto& set) {
    second.compute (backwards); // what was computed before must not matter
    set (second);
  });
  second.compute (backwards);
  EXPECT_TRUE (sameBits (forwards, backwards));
  EXPECT_FALSE (sameBits (forwards, estimate<Estimation> (cloud)));
}

TEST (TangentNormalInterface, EverySetterHasAnEffect)
{
  // 2.5 m away
  const Cloud::Ptr cloud = makeHoles();
  for (auto& p : *cloud)
    p.getVector3fMap() *= 2.5f;
  const Normals by_default = estimate<Estimation> (cloud);
  const std::vector<std::function<void (Estimation&)>> setters{
      [] (Estimation& e) { e.setNormalSmoothingSize (9.f); },
      [] (Estimation& e) { e.setRectSize (9, 5); },
      [] (Estimation& e) { e.setDepthDependentSmoothing (true); },
      [] (Estimation& e) { e.setScaleSelection (true); },
      [] (Estimation& e) { e.setMaxDepthChangeFactor (0.f); },
      [] (Estimation& e) {
        e.setDepthNoise ({0.001f, 0.005f});
      },
      [] (Estimation& e) { e.setBorderPolicy (Estimation::BORDER_POLICY_IGNORE); },
      [] (Estimation& e) { e.setViewPoint (0.f, 0.f, 5.f); },
      [] (Estimation& e) { e.setEdgeAware (false); }};
  for (std::size_t i = 0; i < setters.size(); ++i) {
    Estimation estimation;
    setters[i](estimation);
    EXPECT_FALSE (sameBits (estimate (estimation, cloud), by_default))
        << "setter " << i;
  }
}

TEST (TangentNormalInterface, SearchSurfaceHasNoEffect)
{
  const Cloud::Ptr cloud = makeHoles();
  Estimation estimation;
  estimation.setSearchSurface (render ({tiltedPlane (2.f, 0.f, 0.f)}, 8, 8).cloud);
  EXPECT_TRUE (sameBits (estimate (estimation, cloud), estimate<Estimation> (cloud)));
}

TEST (TangentNormalInterface, BorderPolicyIgnoreLeavesTheBorderOut)
{
  const Cloud::Ptr cloud = render ({tiltedPlane (1.f, 0.f, 0.f)}, 64, 48).cloud;
  Estimation estimation;
  estimation.setRectSize (8, 4);
  estimation.setBorderPolicy (Estimation::BORDER_POLICY_IGNORE);
  const Normals normals = estimate (estimation, cloud);
  for (int v = 0; v < 48; ++v)
    for (int u = 0; u < 64; ++u)
      EXPECT_EQ (std::isfinite (normals (u, v).normal_x),
                 u >= 4 && u < 60 && v >= 2 && v < 46)
          << u << " " << v;
}

/** A row or a column of points spans no surface; anything larger does. */
TEST (TangentNormalInterface, SmallestImagesAreSafe)
{
  const auto plane = tiltedPlane (1.f, 10.f, 20.f);
  for (const auto& size :
       {std::pair (1, 2), {1, 64}, {2, 2}, {2, 3}, {3, 2}, {2, 64}, {64, 2}})
    for (const bool edge_aware : {false, true}) {
      Estimation estimation;
      estimation.setEdgeAware (edge_aware);
      const Normals normals =
          estimate (estimation, crop (plane, size.first, size.second));
      ASSERT_EQ (normals.width, size.first);
      ASSERT_EQ (normals.height, size.second);
      EXPECT_EQ (normals.is_dense, size.first > 1);
      const double error = meanErrorDegrees (normals, plane.normal);
      EXPECT_TRUE (size.first > 1 ? error < 0.1 : std::isnan (error))
          << error << " degrees for " << size.first << " x " << size.second;
    }
}

/** PCL's point clouds of height 1 are unorganized, whatever their width. */
TEST (TangentNormalInterface, SinglePointIsRefused)
{
  const Normals normals =
      estimate<Estimation> (crop (tiltedPlane (1.f, 0.f, 0.f), 1, 1));
  EXPECT_TRUE (normals.empty() && normals.width == 0 && normals.height == 0);
}

TEST (TangentNormalInterface, SmoothingLargerThanTheImageIsSafe)
{
  const auto plane = tiltedPlane (1.f, 10.f, 20.f);
  const Cloud::Ptr cloud = render ({plane}, 31, 23).cloud;
  for (const float size : {32.f, 1000.f, 1e9f}) {
    Estimation estimation;
    estimation.setNormalSmoothingSize (size);
    const Normals normals = estimate (estimation, cloud);
    for (const auto& normal : normals)
      ASSERT_LE (angleDegrees (normal.getNormalVector3fMap(), plane.normal), 0.1f)
          << size;
  }
}

/** pcl::IntegralImageNormalEstimation crashes on an image of 8 x 8 points. */
TEST (TangentNormalInterface, TinyCloudGetsItsNormals)
{
  const auto plane = tiltedPlane (1.f, 30.f, 0.f);
  const Normals normals = estimate<Estimation> (crop (plane, 8, 8));
  ASSERT_EQ (normals.size(), 64u);
  EXPECT_LE (meanErrorDegrees (normals, plane.normal), 0.1);
}

/** pcl::IntegralImageNormalEstimation loses 7 % of them, has no curvature, and calls a
 * cloud without NaN not dense. */
TEST (TangentNormalInterface, PerfectPlaneKeepsAllNormals)
{
  const auto plane = tiltedPlane (1.f, 0.f, 0.f);
  const Normals normals = estimate<Estimation> (render ({plane}).cloud);
  ASSERT_EQ (normals.size(), 640u * 480u);
  EXPECT_TRUE (normals.is_dense);
  for (const auto& normal : normals) {
    ASSERT_LE (angleDegrees (normal.getNormalVector3fMap(), plane.normal), 0.1f);
    ASSERT_NEAR (normal.curvature, 0.f, 1e-5f);
  }
}

/** In pcl::IntegralImageNormalEstimation they blank normals in the left column. */
TEST (TangentNormalInterface, MissingPointsOnTheRightChangeNothingOnTheLeft)
{
  const Cloud::Ptr whole =
      render (twoWalls(), 64, 48, [] (float) { return 0.001f; }).cloud;
  const auto torn = pcl::make_shared<Cloud> (*whole);
  for (int v = 0; v < 48; ++v)
    (*torn) (63, v).getVector3fMap().setConstant (synthetic::nan);
  Estimation estimation;
  estimation.setNormalSmoothingSize (10.f);
  const Normals expected = estimate (estimation, whole);
  const Normals normals = estimate (estimation, torn);
  for (int v = 0; v < 48; ++v)
    for (int u = 0; u < 40; ++u) {
      ASSERT_TRUE (std::isfinite (normals (u, v).normal_x)) << u << " " << v;
      ASSERT_TRUE (sameBits (normals (u, v), expected (u, v))) << u << " " << v;
    }
}

/** pcl::IntegralImageNormalEstimation adds a tenth of the depth to the size in pixels,
 * which is nothing for depth in metres. */
TEST (TangentNormalInterface, DepthDependentSmoothingActsOnMetres)
{
  const auto meanError = [] (float depth, bool depth_dependent) {
    const auto plane = tiltedPlane (depth, 0.f, 0.f);
    const auto scene = render ({plane}, 320, 240, [] (float z) { return 0.001f * z; });
    Estimation estimation;
    estimation.setEdgeAware (false); // means of planes smooth, too
    estimation.setDepthDependentSmoothing (depth_dependent);
    return meanErrorDegrees (estimate (estimation, scene.cloud), plane.normal);
  };
  EXPECT_NEAR (meanError (4.f, false), meanError (1.f, false), 0.1);
  EXPECT_LT (meanError (4.f, true), 0.5 * meanError (4.f, false));
  EXPECT_NEAR (meanError (1.f, true) / meanError (1.f, false), 1., 0.25);
}
