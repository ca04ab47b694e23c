// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_clouds.h"

#include <pcl/common/io.h>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

using namespace plane_clouds;
using synthetic::angleDegrees;

namespace {

/** Every surface is found once within \a degrees, and nothing else. */
void
expectNormals (const Result& result,
               const std::vector<Eigen::Vector3f>& normals,
               float degrees)
{
  ASSERT_EQ (result.models.size(), normals.size());
  for (const auto& normal : normals) {
    float nearest = 180.f;
    for (std::size_t k = 0; k < result.models.size(); ++k)
      nearest = std::min (nearest, angleDegrees (result.normal (k), normal));
    EXPECT_LE (nearest, degrees);
  }
}

std::vector<Eigen::Vector3f>
cornerNormals ()
{
  std::vector<Eigen::Vector3f> normals;
  for (const auto& surface : corner())
    normals.push_back (surface.normal);
  return normals;
}

std::size_t
labelledPoints (const Result& result)
{
  return static_cast<std::size_t> (std::count_if (
      result.labels.begin(), result.labels.end(), [] (const pcl::Label& label) {
        return label.label != Ours::unlabelled;
      }));
}

/** A scanner that turns in equal angles, x forward and z up, in a box of a room: no
 * pinhole camera. */
Cloud::Ptr
scanRoom ()
{
  const std::vector<Eigen::Vector4f> room{{-1.f, 0.f, 0.f, 3.f},
                                          {0.f, 1.f, 0.f, 1.5f},
                                          {0.f, -1.f, 0.f, 1.2f},
                                          {0.f, 0.f, 1.f, 1.f}};
  std::mt19937 generator (4);
  std::normal_distribution<float> noise (0.f, 0.002f);
  auto cloud = pcl::make_shared<Cloud> (400, 300);
  for (std::uint32_t v = 0; v < cloud->height; ++v)
    for (std::uint32_t u = 0; u < cloud->width; ++u) {
      const float azimuth = pcl::deg2rad (35.f - 0.175f * static_cast<float> (u));
      const float elevation = pcl::deg2rad (20.f - 0.2f * static_cast<float> (v));
      const Eigen::Vector3f ray (std::cos (elevation) * std::cos (azimuth),
                                 std::cos (elevation) * std::sin (azimuth),
                                 std::sin (elevation));
      float range = std::numeric_limits<float>::infinity();
      for (const auto& plane : room)
        if (plane.head<3>().dot (ray) < 0.f)
          range = std::min (range, -plane[3] / plane.head<3>().dot (ray));
      (*cloud) (u, v).getVector3fMap() = (range + noise (generator)) * ray;
    }
  return cloud;
}

} // namespace

TEST (PlaneInputs, PixelsFartherThanDepthTellsAnythingAreNotMeasured)
{
  const Cloud::Ptr cloud = render (corner(), 320, 240, kinectSigma).cloud;
  const Normals::Ptr normals = estimateNormals (cloud);
  // What others write where they measure nothing: the largest of 16 bits, in metres or not.
  for (const float far : {65.535f, 1000.f, 65535.f, 1e7f}) {
    Result results[2];
    for (const bool is_missing : {true, false}) {
      const auto spoiled = pcl::make_shared<Cloud> (*cloud);
      for (std::size_t i = 0; i < spoiled->size(); i += 101)
        (*spoiled)[i].getVector3fMap() *=
            is_missing ? std::numeric_limits<float>::quiet_NaN() : far / (*cloud)[i].z;
      Ours segmentation;
      segmentation.setMinInliers (250);
      segmentation.setInputCloud (spoiled);
      segmentation.setInputNormals (normals);
      segment (segmentation, results[is_missing]);
    }
    EXPECT_EQ (results[true].models.size(), 3u);
    expectSame (results[true], results[false]);
  }
}

TEST (PlaneInputs, MillimetresAreToldOnceInARow)
{
  Ours segmentation;
  const auto warningAt = [&segmentation] (float units_per_metre) {
    const Cloud::Ptr cloud = render (corner()).cloud;
    for (auto& p : *cloud)
      p.getVector3fMap() *= units_per_metre;
    Result result;
    testing::internal::CaptureStderr();
    segment (segmentation, cloud, result);
    return testing::internal::GetCapturedStderr();
  };
  EXPECT_EQ (warningAt (1.f), "");
  for (int stream = 0; stream < 2; ++stream) {
    EXPECT_NE (warningAt (1000.f).find ("millimetres"), std::string::npos);
    EXPECT_EQ (warningAt (1000.f), "") << "a stream of frames fills no log";
    EXPECT_EQ (warningAt (1.f), "");
  }
}

TEST (PlaneInputs, NoMillimetresAreToldOfOneFarPlaneOrAFarSensor)
{
  // The walls of a corner in hundreds of metres, and half of a wall.
  const Cloud::Ptr far = render (corner(), 320, 240).cloud;
  const Cloud::Ptr half = render ({tiltedPlane (2.f, 0.f, 0.f)}, 320, 240).cloud;
  const Cloud::Ptr elsewhere = render (corner(), 320, 240).cloud;
  const Eigen::Vector3f place (200.f, 0.f, 0.f);
  for (std::size_t i = 0; i < far->size(); ++i) {
    (*far)[i].getVector3fMap() *= 80.f;
    if (i % 320 < 160)
      (*half)[i].getVector3fMap() *= 80.f;
    (*elsewhere)[i].getVector3fMap() += place;
  }
  elsewhere->sensor_origin_.head<3>() = place;
  for (const auto& [cloud, is_told] :
       {std::pair (far, true), {half, false}, {elsewhere, false}}) {
    Ours segmentation;
    segmentation.setMinInliers (250);
    segmentation.setDepthNoise ({0.001f, 0.00001f});
    Result result;
    testing::internal::CaptureStderr();
    segment (segmentation, cloud, result);
    const std::string warning = testing::internal::GetCapturedStderr();
    EXPECT_EQ (warning.find ("millimetres") != std::string::npos, is_told);
    EXPECT_GE (result.models.size(), 2u);
  }
}

TEST (PlaneInputs, PointsBeyondTheRangeOfTheSensorAreToldOnceInARow)
{
  Ours segmentation;
  segmentation.setDepthNoise (pcl::rgbd_planes::DepthNoise::structuredLight());
  const auto warningAt = [&segmentation] (float distance) {
    Result result;
    testing::internal::CaptureStderr();
    segment (segmentation, render ({tiltedPlane (distance, 0.f, 0.f)}).cloud, result);
    return testing::internal::GetCapturedStderr();
  };
  for (int stream = 0; stream < 2; ++stream) {
    EXPECT_EQ (warningAt (2.f), "");
    EXPECT_NE (warningAt (4.f).find ("beyond 3.5 m"), std::string::npos);
    EXPECT_EQ (warningAt (4.f), "");
  }
}

TEST (PlaneInputs, NormalsMayFaceAway)
{
  const Scene scene = render (corner(), 320, 240, kinectSigma);
  const Normals::Ptr normals = estimateNormals (scene.cloud);
  Ours segmentation;
  segmentation.setMinInliers (250);
  segmentation.setInputCloud (scene.cloud);
  segmentation.setInputNormals (normals);
  Result facing, away;
  segment (segmentation, facing);
  expectNormals (facing, cornerNormals(), 0.2f);
  for (auto& normal : *normals)
    normal.getNormalVector3fMap() *= -1.f;
  segment (segmentation, away);
  expectNormals (away, cornerNormals(), 0.2f);
  expectSame (away, facing);
  for (std::size_t i = 0; i < normals->size(); i += 3)
    (*normals)[i].getNormalVector3fMap() *= -1.f;
  segment (segmentation, away);
  expectSame (away, facing);
}

TEST (PlaneInputs, OddSizes)
{
  Ours segmentation;
  segmentation.setMinInliers (1);
  Result result;
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{{2, 2},
                                                                      {3, 2},
                                                                      {2, 100},
                                                                      {100, 2},
                                                                      {3, 3},
                                                                      {37, 23},
                                                                      {641, 479},
                                                                      {17, 1001}}) {
    const Scene scene = render ({tiltedPlane (1.f, 10.f, 20.f)}, width, height);
    segment (segmentation, scene.cloud, result);
    EXPECT_EQ (result.labels.width, static_cast<std::uint32_t> (width));
    EXPECT_EQ (result.labels.height, static_cast<std::uint32_t> (height));
    if (width < 37 || height < 23)
      continue;
    ASSERT_EQ (result.models.size(), 1u) << width << " x " << height;
    EXPECT_EQ (result.inliers[0].indices.size(), scene.cloud->size());
  }
}

// Tiles of samples are as long as the longer side needs, but no larger than the image.
TEST (PlaneInputs, LongStrips)
{
  for (const auto& [width, height] : {std::pair{1000000u, 2u}, {2u, 1000000u}}) {
    auto cloud = pcl::make_shared<Cloud> (width, height);
    for (std::uint32_t v = 0; v < height; ++v)
      for (std::uint32_t u = 0; u < width; ++u)
        (*cloud) (u, v).getVector3fMap() << 1e-6f * static_cast<float> (u),
            1e-6f * static_cast<float> (v), 1.f;
    Ours segmentation;
    segmentation.setInputCloud (cloud);
    segmentation.setInputNormals (
        pcl::make_shared<Normals> (width, height, pcl::Normal (0.f, 0.f, -1.f)));
    Result result;
    segment (segmentation, result);
    EXPECT_EQ (result.labels.width, width);
    EXPECT_EQ (result.labels.height, height);
  }
}

/** Planes that noise leaves open, as those of points in a line of pixels, came with a covariance as
 * if they were certain; and so did planes of the noise of three or four rows. */
TEST (PlaneInputs, PlanesOfFewRowsAreAsCertainAsTheySay)
{
  std::size_t planes = 0;
  for (const int rows : {2, 3, 4, 8})
    for (unsigned seed = 0; seed < 100; ++seed) {
      std::mt19937 random (seed);
      std::uniform_real_distribution<float> tilt (-0.6f, 0.6f);
      const float x = tilt (random), y = tilt (random); // arguments have no order
      const Eigen::Vector3f normal = Eigen::Vector3f (x, y, -1.f).normalized();
      const auto cloud = render ({{normal, 1.5f}}, 640, rows, kinectSigma).cloud;
      Ours segmentation;
      segmentation.setMinInliers (10);
      Result result;
      segment (segmentation, cloud, result);
      // What so few rows had were planes of noise, most of them 20 degrees off and more.
      EXPECT_TRUE (rows > 4 || result.models.empty()) << rows << " rows, seed " << seed;
      for (std::size_t k = 0; k < result.models.size(); ++k) {
        const Eigen::Matrix4d& covariance = segmentation.getParameterCovariances()[k];
        const Eigen::Vector4d variances =
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> (covariance).eigenvalues();
        EXPECT_GT (variances[0], -1e-9 * variances[3]);
        EXPECT_LT (pcl::deg2rad (angleDegrees (result.normal (k), normal)),
                   6. * std::sqrt (covariance.topLeftCorner<3, 3>().trace()))
            << rows << " rows, seed " << seed;
        ++planes;
      }
    }
  EXPECT_GT (planes, 50u);
}

TEST (PlaneInputs, NormalsMayBeMissing)
{
  const Scene scene = render (corner(), 320, 240);
  const Normals::Ptr normals = estimateNormals (scene.cloud);
  for (std::size_t i = 0; i < normals->size(); ++i)
    if (i % 3 != 0)
      (*normals)[i] = pcl::Normal (synthetic::nan, synthetic::nan, synthetic::nan);
  Ours segmentation;
  segmentation.setMinInliers (250);
  segmentation.setInputCloud (scene.cloud);
  segmentation.setInputNormals (normals);
  Result result;
  segment (segmentation, result);
  expectNormals (result, cornerNormals(), 0.2f);
  for (auto& normal : *normals)
    normal.normal_x = synthetic::nan;
  segment (segmentation, result);
  EXPECT_TRUE (result.models.empty());
  EXPECT_EQ (labelledPoints (result), 0u);
}

TEST (PlaneInputs, CloudsThatAreNotProjective)
{
  Ours segmentation;
  Result result;
  segment (segmentation, scanRoom(), result);
  expectNormals (result,
                 {{-1.f, 0.f, 0.f}, {0.f, 1.f, 0.f}, {0.f, -1.f, 0.f}, {0.f, 0.f, 1.f}},
                 0.3f);
  EXPECT_GE (labelledPoints (result), result.labels.size() * 95 / 100);
}

TEST (PlaneInputs, CopiesWorkOnTheirOwn)
{
  const Scene first = render (corner(), 320, 240, kinectSigma);
  const Scene second = render ({tiltedPlane (1.f, 0.f, 0.f)}, 160, 120);
  Ours original;
  original.setMinInliers (250);
  Result expected, result;
  segment (original, first.cloud, expected);
  Ours copy = original;
  segment (copy, second.cloud, result);
  EXPECT_EQ (result.models.size(), 1u);
  segment (original, result);
  expectSame (result, expected);
  copy = original;
  segment (copy, result);
  expectSame (result, expected);
}

TEST (PlaneInputs, OtherPointTypes)
{
  const Scene scene = render (corner(), 320, 240, kinectSigma);
  Ours plain;
  plain.setMinInliers (250);
  Result expected, result;
  segment (plain, scene.cloud, expected);

  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGBNormal>>();
  pcl::copyPointCloud (*scene.cloud, *cloud);
  pcl::copyPointCloud (*plain.getInputNormals(), *cloud);
  pcl::NormalSpacePlaneSegmentation<pcl::PointXYZRGBNormal, pcl::PointXYZRGBNormal>
      coloured;
  coloured.setMinInliers (250);
  coloured.setInputCloud (cloud);
  coloured.setInputNormals (cloud);
  segment (coloured, result);
  expectSame (result, expected);
}

TEST (PlaneInputs, EverySetterHasAnEffect)
{
  const auto small = [] (int u, int v) { return u < 40 && v < 40; };
  const Scene scene = render (
      {tiltedPlane (2.f, 0.f, 0.f), {tiltedPlane (1.f, 0.f, 30.f).normal, 0.9f, small}},
      640,
      480,
      kinectSigma);
  Ours segmentation;
  Result result;
  segmentation.setMinInliers (1000);
  segment (segmentation, scene.cloud, result);
  EXPECT_EQ (result.models.size(), 2u);
  const std::size_t wall = result.inliers[0].indices.size();
  segmentation.setMinInliers (2000);
  segment (segmentation, result);
  EXPECT_EQ (result.models.size(), 1u);
  segmentation.setMinInliers (1000);
  segmentation.setDistanceThreshold (0.002); // less than the noise
  segment (segmentation, result);
  ASSERT_FALSE (result.inliers.empty());
  EXPECT_LT (result.inliers[0].indices.size(), wall * 3 / 4);
  segmentation.setDistanceThreshold (0.009);
  segmentation.setMaximumPointCurvature (0.);
  segment (segmentation, result);
  EXPECT_TRUE (result.models.empty()) << "noise bends everything";
}

TEST (PlaneInputs, SharesAndCurvaturesThatMakeNoSenseAreRefused)
{
  Ours segmentation;
  for (const double wrong : {-0.1, std::numeric_limits<double>::quiet_NaN()}) {
    segmentation.setMinimumNearNormals (wrong);
    segmentation.setMaximumCurvature (wrong);
    segmentation.setMaximumPointCurvature (wrong);
  }
  segmentation.setMinimumNearNormals (1.1);
  EXPECT_EQ (segmentation.getMinimumNearNormals(), 0.75);
  EXPECT_EQ (segmentation.getMaximumCurvature(), 1.);
  EXPECT_EQ (segmentation.getMaximumPointCurvature(), 0.08);
  segmentation.setMinimumNearNormals (1.);
  EXPECT_EQ (segmentation.getMinimumNearNormals(), 1.);
  segmentation.setMaximumCurvature (std::numeric_limits<double>::infinity());
  EXPECT_TRUE (std::isinf (segmentation.getMaximumCurvature()));
  segmentation.setMaximumPointCurvature (std::numeric_limits<double>::infinity());
  EXPECT_TRUE (std::isinf (segmentation.getMaximumPointCurvature()));
}
