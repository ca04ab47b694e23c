// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "normal_clouds.h"

#include <pcl/common/io.h>
#include <pcl/features/depth_noise.h>
#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/features/two_run_normal.h>
#include <pcl/io/pcd_io.h>
#include <pcl/simulation/simulate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

using synthetic::angleDegrees;
using namespace normal_clouds;
using pcl::rgbd_planes::SimulatedFrame;
using Estimation =
    pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal>;

namespace {

/** How far normals are off others, over the points that have the others. */
struct Errors {
  std::size_t count = 0, missing = 0, above_25 = 0;
  double sum = 0.;

  void
  add (const Eigen::Vector3f& normal, const Eigen::Vector3f& expected)
  {
    const float angle = angleDegrees (normal, expected);
    ++count;
    if (std::isnan (angle)) {
      ++missing;
      return;
    }
    sum += angle;
    above_25 += angle > 25.f;
  }

  void
  add (const Normals& normals, const Normals& expected)
  {
    for (std::size_t i = 0; i < normals.size(); ++i)
      if (std::isfinite (expected[i].normal_x))
        add (normals[i].getNormalVector3fMap(), expected[i].getNormalVector3fMap());
  }

  double
  mean () const
  {
    return sum / static_cast<double> (count - missing);
  }

  double
  shareAbove25 () const
  {
    return static_cast<double> (above_25) / static_cast<double> (count - missing);
  }

  double
  shareMissing () const
  {
    return static_cast<double> (missing) / static_cast<double> (count);
  }
};

Cloud
load (const std::string& name)
{
  Cloud cloud;
  EXPECT_EQ (pcl::io::loadPCDFile (
                 synthetic::dataFolder() + "/mosd_learn/" + name + ".pcd", cloud),
             0);
  return cloud;
}

/** One frame of each scene. */
const std::vector<SimulatedFrame>&
kinectFrames ()
{
  static const std::vector<SimulatedFrame> frames = [] {
    std::vector<SimulatedFrame> all;
    for (const std::string& scene : pcl::rgbd_planes::sceneNames())
      all.push_back (
          pcl::rgbd_planes::simulate (scene, 1, pcl::rgbd_planes::Sensor::kinect));
    return all;
  }();
  return frames;
}

/** Against truth: all points, and those at least 3 m away that see no edge. */
struct TruthErrors {
  Errors all, far_interior;
};

TruthErrors
errorsInSimulation (Estimation estimation)
{
  TruthErrors errors;
  for (const auto& frame : kinectFrames()) {
    const auto cloud = pcl::make_shared<Cloud>();
    pcl::copyPointCloud (*frame.cloud, *cloud);
    const Normals normals = estimate (estimation, cloud);
    for (std::size_t i = 0; i < cloud->size(); ++i) {
      const auto& truth = (*frame.truth)[i];
      if (!pcl::isFinite ((*cloud)[i]) || !std::isfinite (truth.normal_x))
        continue;
      const Eigen::Vector3f normal = normals[i].getNormalVector3fMap();
      errors.all.add (normal, truth.getNormalVector3fMap());
      if (truth.edge == 0 && truth.getVector3fMap().norm() > 3.f)
        errors.far_interior.add (normal, truth.getNormalVector3fMap());
    }
  }
  std::printf (
      "all: %.2f deg, %.2f %% above 25, %.3f %% missing; far interior: %.2f deg, "
      "%.2f %% above 25\n",
      errors.all.mean(),
      100. * errors.all.shareAbove25(),
      100. * errors.all.shareMissing(),
      errors.far_interior.mean(),
      100. * errors.far_interior.shareAbove25());
  return errors;
}

/** The points of a frame with Gaussian noise of depth. */
Cloud
withNoise (const SimulatedFrame& frame, const pcl::rgbd_planes::DepthNoise& noise)
{
  Cloud cloud;
  pcl::copyPointCloud (*frame.cloud, cloud);
  std::mt19937 generator (1);
  std::normal_distribution<float> normal;
  for (auto& point : cloud)
    point.getVector3fMap() *=
        1.f + normal (generator) * noise.sigmaAtSquare (point.z * point.z) / point.z;
  return cloud;
}

/** The angle between the normal of a plane 2.5 m away and the mean of those that are
 * estimated, with \a noise times that of a Kinect. */
float
meanTurn (float degrees, float noise)
{
  const auto plane = synthetic::tiltedPlane (2.5f, degrees, 0.f);
  const auto cloud =
      synthetic::render ({plane}, 640, 480, [=] (float z) {
        return noise * pcl::rgbd_planes::DepthNoise().sigmaAtSquare (z * z);
      }).cloud;
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (const auto& normal : estimate<Estimation> (cloud))
    if (pcl::isNormalFinite (normal))
      sum += normal.getNormalVector3fMap();
  return angleDegrees (sum, plane.normal);
}

} // namespace

/** Principal component analysis in two runs at full resolution is edge-aware as well. The
 * points of all clouds count together, as in pcl_evaluate_normals. */
TEST (TangentNormalAccuracy, AgreesWithTwoRunPcaOnRecordings)
{
  SKIP_WITHOUT_RECORDINGS();
  struct Resolution {
    unsigned step;
    double max_mean, max_above_25;
    Errors errors;
  };
  Resolution resolutions[] = {
      {1, 2.5, 0.005, {}}, {2, 2.5, 0.005, {}}, {4, 3., 0.01, {}}};
  for (const auto* name : {"learn0", "learn20", "learn40"}) {
    const auto full = pcl::make_shared<Cloud> (load (name));
    const Normals reference =
        estimate<pcl::TwoRunNormalEstimation<pcl::PointXYZ, pcl::Normal>> (full);
    for (auto& resolution : resolutions)
      resolution.errors.add (
          estimate<Estimation> (synthetic::subsample (*full, resolution.step)),
          *synthetic::subsample (reference, resolution.step));
  }
  for (const auto& [step, max_mean, max_above_25, errors] : resolutions) {
    std::printf ("step %u: %.2f deg, %.2f %% above 25, %.3f %% missing\n",
                 step,
                 errors.mean(),
                 100. * errors.shareAbove25(),
                 100. * errors.shareMissing());
    EXPECT_LE (errors.mean(), max_mean) << "step " << step;
    EXPECT_LE (errors.shareAbove25(), max_above_25) << "step " << step;
    EXPECT_LE (errors.shareMissing(), 0.001) << "step " << step;
  }
}

TEST (TangentNormalAccuracy, EveryAdditionHelpsInSimulation)
{
  Estimation plain, by_depth, scales;
  plain.setEdgeAware (false);
  by_depth.setDepthDependentSmoothing (true);
  scales.setScaleSelection (true);
  const TruthErrors by_default = errorsInSimulation (Estimation());
  const TruthErrors of_plain = errorsInSimulation (plain);
  EXPECT_LT (by_default.all.mean(), of_plain.all.mean());
  EXPECT_LT (by_default.all.shareAbove25(), of_plain.all.shareAbove25());
  EXPECT_LE (by_default.all.shareMissing(), 0.001);
  for (const auto* estimation : {&by_depth, &scales}) {
    const TruthErrors errors = errorsInSimulation (*estimation);
    EXPECT_LT (errors.all.mean(), by_default.all.mean());
    EXPECT_LT (errors.far_interior.mean(), by_default.far_interior.mean());
    EXPECT_LE (errors.all.shareMissing(), 0.001);
  }
}

/** Gaussian noise, with these figures and with those of a Kinect expected. */
TEST (TangentNormalAccuracy, IsBetterWithTheNoiseOfTheSensor)
{
  const pcl::rgbd_planes::DepthNoise sensors[] = {{0.0002f, 0.0004f}, {0.002f, 0.004f}};
  for (const auto& noise : sensors)
    for (const unsigned step : {1u, 2u, 4u}) {
      Estimation informed;
      informed.setDepthNoise (noise);
      Errors by_default, better;
      for (const auto* scene : {"room", "table_cluttered"}) {
        const auto frame =
            pcl::rgbd_planes::simulate (scene, 1, pcl::rgbd_planes::Sensor::ideal);
        const auto cloud = synthetic::subsample (withNoise (frame, noise), step);
        Normals normals;
        pcl::copyPointCloud (*frame.truth, normals);
        const auto truth = synthetic::subsample (normals, step);
        by_default.add (estimate<Estimation> (cloud), *truth);
        better.add (estimate (informed, cloud), *truth);
      }
      EXPECT_LT (better.mean(), 0.95 * by_default.mean())
          << noise.quadratic << " step " << step;
      EXPECT_LE (better.shareAbove25(), by_default.shareAbove25())
          << noise.quadratic << " step " << step;
    }
}

/** Noise of one pixel of each cell of 2 x 2 does as much harm, whichever it is. */
TEST (TangentNormalAccuracy, PixelsOfACellCountAlike)
{
  const auto walls = twoWalls();
  const auto view = synthetic::render (walls);
  std::vector<double> means;
  for (unsigned noisy = 0; noisy < 4; ++noisy) {
    const auto cloud = pcl::make_shared<Cloud> (*view.cloud);
    std::mt19937 generator (1);
    std::normal_distribution<float> normal (0.f, 0.005f);
    for (unsigned v = noisy / 2; v < cloud->height; v += 2)
      for (unsigned u = noisy % 2; u < cloud->width; u += 2)
        (*cloud) (u, v).getVector3fMap() *= 1.f + normal (generator);
    const Normals normals = estimate<Estimation> (cloud);
    Errors errors;
    for (std::size_t i = 0; i < normals.size(); ++i)
      errors.add (normals[i].getNormalVector3fMap(),
                  walls[static_cast<std::size_t> (view.surface[i])].normal);
    means.push_back (errors.mean());
  }
  const auto [best, worst] = std::minmax_element (means.begin(), means.end());
  EXPECT_LT (*worst, 1.1 * *best);
}

/** Differences of depth that noise makes too large to count were so in one direction only. */
TEST (TangentNormalAccuracy, NoiseDoesNotTurnSlantedPlanes)
{
  for (const float degrees : {50.f, 65.f}) {
    EXPECT_LE (meanTurn (degrees, 1.f), 0.5f) << degrees << " degrees";
    EXPECT_LE (meanTurn (degrees, 1.5f), 2.f) << degrees << " degrees";
  }
}

/** A camera that is turned by 90 degrees sees the same. */
TEST (TangentNormalAccuracy, PortraitImagesAreAsGood)
{
  for (const int width : {320, 640}) {
    const auto plane = synthetic::tiltedPlane (1.5f, 20.f, 30.f);
    const auto cloud = synthetic::render ({plane}, width, width * 3 / 4, [] (float z) {
                         return pcl::rgbd_planes::DepthNoise().sigmaAtSquare (z * z);
                       }).cloud;
    const auto turned = pcl::make_shared<Cloud> (cloud->height, cloud->width);
    for (unsigned v = 0; v < cloud->height; ++v)
      for (unsigned u = 0; u < cloud->width; ++u)
        (*turned) (v, u) = (*cloud) (u, v);
    Errors upright, portrait;
    for (const auto& normal : estimate<Estimation> (cloud))
      upright.add (normal.getNormalVector3fMap(), plane.normal);
    for (const auto& normal : estimate<Estimation> (turned))
      portrait.add (normal.getNormalVector3fMap(), plane.normal);
    EXPECT_LT (portrait.mean(), 1.05 * upright.mean()) << width;
  }
}
