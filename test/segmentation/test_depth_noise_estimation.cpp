// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "noisy_clouds.h"

#include <pcl/common/transforms.h>
#include <pcl/segmentation/depth_noise_estimation.h>
#include <pcl/simulation/simulate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace noisy_clouds;
using namespace synthetic;
using pcl::DepthNoiseEstimation;

namespace {

/** Walls from 0.5 to 5 m, of which the lower half of the image sees one, turned by 40 degrees;
 * a tenth of the blocks see steps. */
void
addWalls (const DepthNoise& noise, unsigned step, DepthNoiseEstimation& estimation)
{
  for (const float depth : {0.5f, 1.f, 1.5f, 2.f, 3.f, 4.f, 5.f}) {
    Surface near = tiltedPlane (0.8f * depth, 0.f, 40.f);
    near.covers = [] (int, int v) { return v > 245; };
    const Cloud cloud = renderNoisy ({tiltedPlane (depth, 5.f, 10.f), near}, noise);
    EXPECT_TRUE (estimation.addFrame (*subsample (cloud, step)));
  }
}

Cloud
constant (unsigned width, unsigned height, float coordinate)
{
  return {width, height, {coordinate, coordinate, coordinate}};
}

} // namespace

TEST (DepthNoiseEstimation, TwiceTheDeviationOfPixels)
{
  for (const DepthNoise& truth : {DepthNoise{0.001f, 0.0002f},
                                  DepthNoise{0.0005f, 0.0015f},
                                  DepthNoise{0.f, 0.003f},
                                  DepthNoise{0.02f, 0.0002f},
                                  DepthNoise{0.002f, 0.004f}})
    for (const unsigned step : {1u, 2u}) {
      DepthNoiseEstimation estimation;
      addWalls (truth, step, estimation);
      EXPECT_EQ (estimation.getNumberOfFrames(), 7u);
      const DepthNoise noise = estimate (estimation);
      for (const float range : {0.7f, 1.f, 2.f, 4.f})
        EXPECT_NEAR (noise.sigmaAtSquare (range * range) /
                         truth.sigmaAtSquare (range * range),
                     2.,
                     0.3)
            << truth.constant << ' ' << truth.quadratic << " at " << range;
      EXPECT_EQ (noise.max_range, INFINITY);
      EXPECT_EQ (noise.normal_scatter, 1.f) << "pixels share no errors";
      float last = 0.f;
      for (const auto& level : estimation.getLevels()) {
        EXPECT_GT (level.range, last);
        EXPECT_GE (level.blocks, 20u);
        EXPECT_NEAR (
            level.sigma / truth.sigmaAtSquare (level.range * level.range), 1., 0.2);
        last = level.range;
      }
    }
}

TEST (DepthNoiseEstimation, ASimulatedKinectIsTheFirstPreset)
{
  DepthNoiseEstimation estimation;
  for (unsigned seed = 1; seed <= 3; ++seed)
    for (const char* scene : {"table_cluttered", "room", "corridor"})
      estimation.addFrame (
          *pcl::rgbd_planes::simulate (scene, seed, pcl::rgbd_planes::Sensor::kinect)
               .cloud);
  const DepthNoise noise = estimate (estimation), preset = DepthNoise::kinectV1();
  for (const float range : {1.f, 2.f, 3.f, 5.f})
    EXPECT_NEAR (noise.sigmaAtSquare (range * range) /
                     preset.sigmaAtSquare (range * range),
                 1.,
                 0.25)
        << range;
  EXPECT_NEAR (noise.normal_scatter, 1., 0.2);
}

TEST (DepthNoiseEstimation, ACameraMayBeOnItsSide)
{
  DepthNoiseEstimation upright, on_its_side;
  for (unsigned seed = 1; seed <= 2; ++seed) {
    const auto frame =
        pcl::rgbd_planes::simulate ("room", seed, pcl::rgbd_planes::Sensor::kinect);
    const auto& cloud = *frame.cloud;
    Cloud transposed (cloud.height, cloud.width);
    for (std::uint32_t v = 0; v < cloud.height; ++v)
      for (std::uint32_t u = 0; u < cloud.width; ++u)
        transposed (v, u).getVector3fMap() << cloud (u, v).y, cloud (u, v).x,
            cloud (u, v).z;
    upright.addFrame (cloud);
    on_its_side.addFrame (transposed);
  }
  const DepthNoise expected = estimate (upright), noise = estimate (on_its_side);
  EXPECT_NEAR (noise.constant, expected.constant, 0.02f * expected.constant);
  EXPECT_NEAR (noise.quadratic, expected.quadratic, 0.02f * expected.quadratic);
  EXPECT_NEAR (noise.normal_scatter, expected.normal_scatter, 0.02f);
}

// Few rows see 90 degrees, so that blocks of a fortieth of the columns see floor, wall and
// ceiling.
TEST (DepthNoiseEstimation, RowsOfALaserScannerAreFew)
{
  constexpr float sigma = 0.01f;
  std::mt19937 generator (1);
  std::normal_distribution<float> gauss;
  Cloud cloud (1024, 64);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto turn = static_cast<float> (2. * M_PI * (i % 1024) / 1024.),
               slope = static_cast<float> (M_PI / 4. - M_PI / 2. * (i / 1024) / 63.);
    const Eigen::Vector3f ray (std::cos (slope) * std::cos (turn),
                               std::cos (slope) * std::sin (turn),
                               std::sin (slope));
    const float height = ray.z() > 0.f ? 1.f : 1.6f;
    const float range =
        std::min (height / std::abs (ray.z()),
                  std::min (4.f / std::abs (ray.x()), 3.f / std::abs (ray.y())));
    cloud[i].getVector3fMap() = (range + sigma * gauss (generator)) * ray;
  }
  DepthNoiseEstimation estimation;
  estimation.addFrame (cloud);
  const DepthNoise noise = estimate (estimation);
  for (const float range : {1.5f, 2.f, 4.f})
    EXPECT_NEAR (noise.sigmaAtSquare (range * range) / sigma, 2., 0.4) << range;
}

TEST (DepthNoiseEstimation, WithoutNoiseWhatNumbersAllow)
{
  DepthNoiseEstimation estimation;
  addWalls ({0.f, 0.f}, 1, estimation);
  const DepthNoise noise = estimate (estimation);
  EXPECT_EQ (noise.constant, 0.0001f);
  EXPECT_EQ (noise.quadratic, 0.0002f);
}

TEST (DepthNoiseEstimation, StepsOfDepthAreErrors)
{
  constexpr float step = 0.01f;
  for (const float tilt : {2.f, 20.f}) {
    DepthNoiseEstimation estimation;
    for (const float depth : {1.f, 1.5f, 2.f, 3.f}) {
      Cloud cloud = *render ({tiltedPlane (depth, tilt, 0.f)}).cloud;
      for (auto& point : cloud)
        point.getVector3fMap() *= std::round (point.z / step) * step / point.z;
      EXPECT_TRUE (estimation.addFrame (cloud));
    }
    const float uniform = step / std::sqrt (12.f);
    EXPECT_GT (estimate (estimation).sigmaAtSquare (1.f), uniform) << tilt;
    EXPECT_LT (estimate (estimation).sigmaAtSquare (1.f), 3.f * uniform) << tilt;
  }
}

TEST (DepthNoiseEstimation, InAnyFrame)
{
  DepthNoiseEstimation estimation, moved;
  for (const float depth : {1.f, 2.f, 3.f}) {
    const Cloud cloud =
        renderNoisy ({tiltedPlane (depth, 20.f, 10.f)}, {0.001f, 0.002f}, 320, 240);
    estimation.addFrame (cloud);
    Eigen::Affine3f transform = Eigen::Affine3f::Identity();
    transform.rotate (Eigen::AngleAxisf (1.f, Eigen::Vector3f (1.f, 2.f, 2.f) / 3.f));
    transform.translation() << 1.f, -2.f, 0.5f;
    Cloud in_base;
    pcl::transformPointCloud (cloud, in_base, transform);
    in_base.sensor_origin_.head<3>() = transform.translation();
    moved.addFrame (in_base);
  }
  const DepthNoise noise = estimate (estimation), noise_moved = estimate (moved);
  EXPECT_NEAR (noise_moved.constant, noise.constant, 0.05f * noise.constant);
  EXPECT_NEAR (noise_moved.quadratic, noise.quadratic, 0.05f * noise.quadratic);
}

// What is far tells the quadratic part only: the constant one is not made of its curve.
TEST (DepthNoiseEstimation, FarSurfacesAlone)
{
  DepthNoiseEstimation estimation;
  for (const float depth : {3.f, 3.5f})
    estimation.addFrame (
        *render ({tiltedPlane (depth, 5.f, 5.f)}, 640, 480, [] (float z) {
           return 0.001f * z * z;
         }).cloud);
  const DepthNoise noise = estimate (estimation);
  EXPECT_LT (noise.constant, 0.003f);
  EXPECT_NEAR (noise.quadratic, 0.002f, 0.0003f);
}

TEST (DepthNoiseEstimation, LevelsHave20BlocksOrMore)
{
  // Blocks of 8 x 8 pixels: 5 x 4 of them, and 19 where one is missing.
  Cloud cloud (40, 32);
  for (int v = 0; v < 32; ++v)
    for (int u = 0; u < 40; ++u)
      cloud (u, v) = {0.002f * u, 0.002f * v, 1.05f};
  DepthNoiseEstimation all, missing;
  EXPECT_TRUE (all.addFrame (cloud));
  EXPECT_EQ (all.getLevels().size(), 1u);
  for (int u = 0; u < 8; ++u)
    cloud (u, 0).z = synthetic::nan;
  EXPECT_TRUE (missing.addFrame (cloud));
  EXPECT_TRUE (missing.getLevels().empty());
}

TEST (DepthNoiseEstimation, NormalsScatterFiveTimesAtMost)
{
  // Each block is tilted on its own.
  const DepthNoise precise{0.0001f, 0.0001f};
  Cloud cloud = renderNoisy ({tiltedPlane (1.f, 0.f, 0.f)}, precise, 320, 240);
  std::mt19937 generator (2);
  std::uniform_real_distribution<float> slope (-0.02f, 0.02f);
  for (int v = 0; v < 240; v += 8)
    for (int u = 0; u < 320; u += 8) {
      const float right = slope (generator), down = slope (generator);
      for (int k = 0; k < 64; ++k) {
        auto point = cloud (u + k % 8, v + k / 8).getVector3fMap();
        point *= 1.f + right * (k % 8 - 3.5f) / 8.f + down * (k / 8 - 3.5f) / 8.f;
      }
    }
  DepthNoiseEstimation estimation;
  EXPECT_TRUE (estimation.addFrame (cloud));
  EXPECT_EQ (estimate (estimation).normal_scatter, DepthNoise::max_normal_scatter);
}

TEST (DepthNoiseEstimation, NothingStaysOfAnotherCamera)
{
  const Surface wall = tiltedPlane (2.f, 0.f, 10.f);
  DepthNoiseEstimation used, fresh;
  EXPECT_TRUE (used.addFrame (renderNoisy ({wall}, {0.01f, 0.01f}, 320, 240)));
  used.clearFrames();
  for (DepthNoiseEstimation* estimation : {&used, &fresh})
    EXPECT_TRUE (
        estimation->addFrame (renderNoisy ({wall}, {0.001f, 0.002f}, 320, 240)));
  const DepthNoise noise = estimate (used), expected = estimate (fresh);
  EXPECT_EQ (noise.constant, expected.constant);
  EXPECT_EQ (noise.quadratic, expected.quadratic);
  EXPECT_EQ (noise.normal_scatter, expected.normal_scatter);
}

TEST (DepthNoiseEstimation, BadInput)
{
  DepthNoiseEstimation estimation;
  DepthNoise noise{0.1f, 0.2f, 3.f};
  EXPECT_FALSE (estimation.addFrame (Cloud()));
  Cloud unorganized (100, 1);
  EXPECT_FALSE (estimation.addFrame (unorganized));
  Cloud nowhere = *render ({tiltedPlane (1.f, 0.f, 20.f)}).cloud;
  nowhere.sensor_origin_[1] = synthetic::nan;
  EXPECT_FALSE (estimation.addFrame (nowhere));
  EXPECT_EQ (estimation.getNumberOfFrames(), 0u);
  EXPECT_TRUE (estimation.addFrame (Cloud (640, 480))); // all at (0, 0, 0)
  EXPECT_TRUE (estimation.addFrame (constant (640, 480, synthetic::nan)));
  EXPECT_TRUE (estimation.addFrame (constant (3, 2, 1.f)));
  Cloud huge (640, 480);
  for (std::size_t i = 0; i < huge.size(); ++i)
    huge[i].getVector3fMap() << 1e30f, -1e30f, (i % 7) * 1e30f;
  EXPECT_TRUE (estimation.addFrame (huge));
  EXPECT_EQ (estimation.getNumberOfFrames(), 4u);
  EXPECT_TRUE (estimation.getLevels().empty());
  EXPECT_FALSE (estimation.estimate (noise));
  estimation.clearFrames();
  EXPECT_EQ (estimation.getNumberOfFrames(), 0u);
  EXPECT_FALSE (estimation.estimate (noise));
  EXPECT_EQ (noise.constant, 0.1f);
  EXPECT_EQ (noise.quadratic, 0.2f);
  EXPECT_EQ (noise.max_range, 3.f);
}
