// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace plane_clouds;
using synthetic::angleDegrees;

TEST (PlaneSettings, Defaults)
{
  const Ours segmentation;
  EXPECT_EQ (segmentation.getMinInliers(), 1000u);
  EXPECT_EQ (segmentation.getAngularThreshold(), 0.2);
  EXPECT_EQ (segmentation.getDistanceThreshold(), 0.009);
  EXPECT_EQ (segmentation.getMaximumCurvature(), 1.);
  EXPECT_EQ (segmentation.getMaximumPointCurvature(), 0.08);
  EXPECT_EQ (segmentation.getMinimumNearNormals(), 0.75);
  EXPECT_EQ (segmentation.getNormalSpaceGrid(),
             pcl::rgbd_planes::NormalSpaceGrid::voxels);
  EXPECT_EQ (segmentation.getMinimumCellShare(), 2.5e-4);
  EXPECT_FALSE (segmentation.getProjectPoints());
}

/** A wall, and a board that is a hundredth of the image. */
TEST (PlaneSettings, CellsWithFewPointsStartNoCluster)
{
  const std::vector<Surface> surfaces{tiltedPlane (2.f, 0.f, 20.f),
                                      board (140, 172, 100, 124)};
  const Scene scene = render (surfaces, 320, 240);
  Ours segmentation;
  segmentation.setMinInliers (250);
  segmentation.setInputCloud (scene.cloud);
  segmentation.setInputNormals (trueNormals (scene, surfaces));
  const auto numberOfPlanes = [&segmentation] {
    Result result;
    segment (segmentation, result);
    return result.models.size();
  };
  for (const double share : {0., 2.5e-4, 0.005}) {
    segmentation.setMinimumCellShare (share);
    EXPECT_EQ (segmentation.getMinimumCellShare(), share);
    EXPECT_EQ (numberOfPlanes(), 2u) << share;
  }
  segmentation.setMinimumCellShare (0.02);
  EXPECT_EQ (numberOfPlanes(), 1u);
  for (const double wrong : {-0.1, 1.1, std::nan ("")}) {
    segmentation.setMinimumCellShare (wrong);
    EXPECT_EQ (segmentation.getMinimumCellShare(), 0.02);
  }
}

/** A wall 3 m away, whose points spread by 2 cm, and a board 1.5 m away: the curvature of a region
 * is what counts, as in PCL's class. */
TEST (PlaneSettings, PlanesWithALargerCurvatureAreDropped)
{
  const Scene scene = render (
      {tiltedPlane (3.f, 0.f, 0.f), board (100, 220, 60, 180)}, 320, 240, kinectSigma);
  Ours segmentation;
  Ours::Regions all, some;
  segmentation.setMinInliers (500);
  segmentation.setInputCloud (scene.cloud);
  segmentation.setInputNormals (estimateNormals (scene.cloud));
  segmentation.segment (all);
  ASSERT_EQ (all.size(), 2u);
  const std::size_t curved = segmentation.getRejections().curved;
  const float least = std::min (all[0].getCurvature(), all[1].getCurvature());
  const float most = std::max (all[0].getCurvature(), all[1].getCurvature());
  ASSERT_GT (least, 0.f);
  ASSERT_LT (1.1f * least, most);
  segmentation.setMaximumCurvature (0.5f * (least + most));
  segmentation.segment (some);
  ASSERT_EQ (some.size(), 1u);
  EXPECT_EQ (some[0].getCurvature(), least);
  EXPECT_EQ (segmentation.getRejections().curved, curved + 1);
  segmentation.setMaximumCurvature (0.5 * least);
  segmentation.segment (some);
  EXPECT_TRUE (some.empty());
}

TEST (PlaneSettings, DepthNoiseSaysHowFarPointsSpread)
{
  const Scene scene = render ({tiltedPlane (4.f, 0.f, 0.f)}, 320, 240, kinectSigma);
  Ours segmentation;
  segmentation.setMinInliers (100);
  Result result;
  segment (segmentation, scene.cloud, result);
  EXPECT_GE (coveredPercent (result, *scene.cloud), 95.);
  segmentation.setDepthNoise ({0.003f, 0.f});
  EXPECT_EQ (segmentation.getDepthNoise().constant, 0.003f);
  EXPECT_EQ (segmentation.getDepthNoise().quadratic, 0.f);
  segment (segmentation, result);
  // Three standard deviations are 9 mm now, and hold a fifth of points that spread by
  // 33 mm.
  const auto largest =
      std::count_if (result.labels.begin(),
                     result.labels.end(),
                     [] (const pcl::Label& label) { return label.label == 0; });
  EXPECT_LE (static_cast<double> (largest), 0.3 * result.labels.size());
}

namespace {

/** A wall 1 m away, and another level of half of it, \a step behind. */
Scene
twoLevels (float step)
{
  Scene scene = render ({tiltedPlane (1.f, 0.f, 0.f)}, 320, 240);
  for (std::size_t i = 0; i < scene.cloud->size(); ++i)
    if (i % 320 > 160)
      (*scene.cloud)[i].getVector3fMap() *= 1.f + step;
  return scene;
}

} // namespace

TEST (PlaneSettings, LevelsAreTold)
{
  Ours segmentation;
  segmentation.setMinInliers (250);
  const auto expectBoth = [&segmentation] (float step) {
    Result result;
    segment (segmentation, twoLevels (step).cloud, result);
    ASSERT_EQ (result.models.size(), 2u) << step;
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_LE (angleDegrees (result.normal (k), {0.f, 0.f, -1.f}), 0.1f) << step;
      EXPECT_NEAR (result.inliers[k].indices.size(), 38400., 400.) << step;
    }
  };
  for (const float step : {0.015f, 0.02f, 0.025f, 0.03f, 0.05f})
    expectBoth (step);
  segmentation.setDepthNoise ({1e-4f, 1e-4f});
  for (const float step : {0.002f, 0.003f, 0.005f, 0.01f})
    expectBoth (step);
}

TEST (PlaneSettings, PreciseSensorsTellSmallSteps)
{
  const Scene scene = twoLevels (0.002f);
  const pcl::rgbd_planes::DepthNoise precise{1e-4f, 1e-4f};
  Ours segmentation;
  EXPECT_EQ (segmentation.getDistanceThreshold(), 0.009);
  segmentation.setMinInliers (250);
  Result result;
  segment (segmentation, scene.cloud, result);
  EXPECT_EQ (result.models.size(), 1u);
  segmentation.setDepthNoise (precise);
  EXPECT_NEAR (segmentation.getDistanceThreshold(), 0.0009, 1e-9);
  segment (segmentation, result);
  EXPECT_EQ (result.models.size(), 2u);
  segmentation.setDistanceThreshold (0.009);
  segment (segmentation, result);
  EXPECT_EQ (result.models.size(), 1u);
}

TEST (PlaneSettings, NoisySensorsHaveAWiderThreshold)
{
  const pcl::rgbd_planes::DepthNoise noise{0.004f, 0.004f};
  const Scene scene = render ({tiltedPlane (1.f, 0.f, 30.f)}, 640, 480, [&] (float z) {
    return noise.sigmaAtSquare (z * z);
  });
  Ours segmentation;
  segmentation.setDepthNoise (noise);
  EXPECT_NEAR (segmentation.getDistanceThreshold(), 0.012, 1e-6);
  Result result;
  segment (segmentation, scene.cloud, result);
  ASSERT_EQ (result.models.size(), 1u);
  // 1.5 standard deviations; within 9 mm are 74 %.
  EXPECT_GE (result.inliers[0].indices.size(), 0.8 * scene.cloud->size());
}

TEST (PlaneSettings, FramesMayHaveMoreNoiseThanIsNotSet)
{
  const Scene scene = render ({tiltedPlane (0.5f, 0.f, 0.f)}, 640, 480, [] (float z) {
    return 3.f * kinectSigma (z);
  });
  Ours segmentation;
  EXPECT_TRUE (segmentation.getDepthNoise().is_least);
  Result result;
  segment (segmentation, scene.cloud, result);
  ASSERT_EQ (result.models.size(), 1u);
  EXPECT_GE (result.inliers[0].indices.size(), 0.75 * scene.cloud->size());
  // So far off are points of uneven surfaces alone, where these are no wider than clothes.
  segmentation.setDepthNoise (pcl::rgbd_planes::DepthNoise());
  segment (segmentation, result);
  EXPECT_EQ (result.models.size(), 0u);
}

TEST (PlaneSettings, ThresholdIsWiderAmidAPlaneThanAtItsBorder)
{
  const Scene scene = render ({tiltedPlane (1.f, 0.f, 0.f)}, 640, 480);
  constexpr std::size_t border = 325;
  for (std::size_t i = 0; i < scene.cloud->size(); ++i)
    if (i % 640 < border)
      (*scene.cloud)[i].getVector3fMap().setConstant (synthetic::nan);
  Ours segmentation;
  segmentation.setDistanceThreshold (0.01);
  const auto isOnPlane = [&] (std::size_t u, std::size_t v, float off) {
    const auto cloud = pcl::make_shared<Cloud> (*scene.cloud);
    const std::size_t i = v * 640 + u;
    (*cloud)[i].z += off;
    Result result;
    segment (segmentation, cloud, result);
    return result.labels[i].label == 0;
  };
  EXPECT_TRUE (isOnPlane (482, 242, 0.011f));
  EXPECT_FALSE (isOnPlane (482, 242, 0.012f));
  EXPECT_TRUE (isOnPlane (border + 3, 242, 0.0085f));
  EXPECT_FALSE (isOnPlane (border + 3, 242, 0.0095f));
}

TEST (PlaneSettings, PointsBeyondTheRangeTakeNoPart)
{
  const Scene scene = render (
      {tiltedPlane (4.f, 0.f, 0.f), {{0.f, -1.f, 0.f}, 0.7f}}, 320, 240, kinectSigma);
  Ours segmentation;
  segmentation.setMinInliers (250);
  auto noise = segmentation.getDepthNoise();
  noise.max_range = 3.f;
  segmentation.setDepthNoise (noise);
  Result result;
  segment (segmentation, scene.cloud, result);
  ASSERT_EQ (result.models.size(), 1u);
  EXPECT_LE (angleDegrees (result.normal (0), {0.f, -1.f, 0.f}), 0.5f);
  for (const pcl::index_t i : result.inliers[0].indices)
    EXPECT_LE ((*scene.cloud)[i].getVector3fMap().norm(), 3.f);
}

TEST (PlaneSettings, BothGridsFindTheSame)
{
  const Scene scene = render (corner(), 640, 480, kinectSigma);
  Ours segmentation;
  EXPECT_EQ (segmentation.getNormalSpaceGrid(),
             pcl::rgbd_planes::NormalSpaceGrid::voxels);
  Result voxels, spherical;
  segment (segmentation, scene.cloud, voxels);
  segmentation.setNormalSpaceGrid (pcl::rgbd_planes::NormalSpaceGrid::spherical);
  EXPECT_EQ (segmentation.getNormalSpaceGrid(),
             pcl::rgbd_planes::NormalSpaceGrid::spherical);
  segment (segmentation, spherical);
  ASSERT_EQ (voxels.models.size(), 3u);
  ASSERT_EQ (spherical.models.size(), 3u);
  std::size_t same = 0;
  for (std::size_t i = 0; i < scene.cloud->size(); ++i)
    same += voxels.labels[i].label == spherical.labels[i].label;
  EXPECT_GE (same, scene.cloud->size() * 99 / 100);

  // They are not one: clusters of less than the noise of normals differ.
  segmentation.setAngularThreshold (0.02);
  segment (segmentation, spherical);
  const std::size_t candidates = segmentation.getRejections().claimed_by_larger;
  segmentation.setNormalSpaceGrid (pcl::rgbd_planes::NormalSpaceGrid::voxels);
  segment (segmentation, voxels);
  EXPECT_NE (segmentation.getRejections().claimed_by_larger, candidates);
}

/** With the default, clusters hold normals of both. */
TEST (PlaneSettings, AngularThresholdPartsPlanesThatMeetAtAFlatAngle)
{
  const std::vector<Surface> surfaces{tiltedPlane (1.5f, 0.f, -4.f),
                                      tiltedPlane (1.5f, 0.f, 4.f)};
  const Scene scene = render (surfaces, 640, 480, kinectSigma);
  Ours segmentation;
  segmentation.setAngularThreshold (0.1);
  Result result;
  segment (segmentation, scene.cloud, result);
  ASSERT_EQ (result.models.size(), 2u);
  for (const auto& surface : surfaces)
    EXPECT_LE (std::min (angleDegrees (result.normal (0), surface.normal),
                         angleDegrees (result.normal (1), surface.normal)),
               0.5f);
}

TEST (PlaneSettings, BadNoiseIsRefused)
{
  Ours segmentation;
  segmentation.setDepthNoise (pcl::rgbd_planes::DepthNoise::activeStereo());
  const float inf = std::numeric_limits<float>::infinity();
  using Noise = pcl::rgbd_planes::DepthNoise;
  for (const Noise& bad : {Noise{0.f, 0.f, 1.f},
                           Noise{-0.001f, 0.002f, 1.f},
                           Noise{0.001f, -0.002f, 1.f},
                           Noise{synthetic::nan, 0.002f, 1.f},
                           Noise{0.001f, inf, 1.f},
                           Noise{0.001f, 0.002f, 0.f},
                           Noise{0.001f, 0.002f, synthetic::nan}}) {
    segmentation.setDepthNoise (bad);
    EXPECT_EQ (segmentation.getDepthNoise().constant, 0.0005f);
    EXPECT_EQ (segmentation.getDepthNoise().quadratic, 0.003f);
    EXPECT_EQ (segmentation.getDepthNoise().max_range, 5.f);
  }
}

TEST (PlaneRejections, CountPlanesWithTooFewPoints)
{
  const std::vector<Surface> surfaces{tiltedPlane (2.f, 0.f, 20.f),
                                      board (100, 140, 80, 120)};
  Ours segmentation;
  const Scene both = render (surfaces);
  segmentation.setInputCloud (both.cloud);
  segmentation.setInputNormals (trueNormals (both, surfaces));
  Result result;
  segmentation.setMinInliers (6000);
  segment (segmentation, result);
  EXPECT_EQ (result.models.size(), 1u);
  EXPECT_GE (segmentation.getRejections().too_few_points, 1u) << "seen while it grows";
  segmentation.setMinInliers (2000);
  segment (segmentation, result);
  EXPECT_EQ (result.models.size(), 1u);
  EXPECT_EQ (segmentation.getRejections().too_few_points, 1u);

  const Scene wall = render ({surfaces[0]});
  segmentation.setInputCloud (wall.cloud);
  segmentation.setInputNormals (trueNormals (wall, surfaces));
  segment (segmentation, result);
  EXPECT_EQ (result.models.size(), 1u);
  EXPECT_EQ (segmentation.getRejections().too_few_points, 0u);
  EXPECT_EQ (segmentation.getRejections().curved, 0u);
  EXPECT_EQ (segmentation.getRejections().claimed_by_larger, 0u);
}

/** Clusters of less than the noise of normals: each plane takes the points of many. */
TEST (PlaneRejections, CountCandidatesWhoseSeedsWereTaken)
{
  const Scene scene = render (corner(), 640, 480, kinectSigma);
  Ours segmentation;
  segmentation.setAngularThreshold (0.02);
  Result result;
  segment (segmentation, scene.cloud, result);
  EXPECT_EQ (result.models.size(), 3u);
  EXPECT_GT (segmentation.getRejections().claimed_by_larger, 10u);
  segmentation.setAngularThreshold (0.2);
  segment (segmentation, result);
  EXPECT_EQ (result.models.size(), 3u);
  EXPECT_EQ (segmentation.getRejections().claimed_by_larger, 0u);
}
