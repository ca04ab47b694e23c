// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "active_stereo.h"
#include "kinect.h"
#include "plane_noise.h"
#include "synthetic_clouds.h"

#include <pcl/apps/frame_source.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using namespace pcl::rgbd_planes;

namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();

using Depth = std::vector<float>;
/** What a sensor measures. */
using Measure = std::function<Depth (
    const std::vector<RenderedPixel>& image, const Camera& camera, Random& random)>;

Depth
measuredWithKinect (const std::vector<RenderedPixel>& image,
                    const Camera& camera,
                    Random& random)
{
  return measureWithKinect (image, camera, random, random);
}

/** What the sensor would measure if every pixel saw the plane with this inverse depth.
 */
Depth
measurePlane (const std::array<double, 3>& plane,
              unsigned seed,
              const Camera& camera,
              const Measure& measure)
{
  const Eigen::Vector3d normal (plane[0] * camera.fx,
                                plane[1] * camera.fy,
                                plane[0] * camera.cx + plane[1] * camera.cy + plane[2]);
  std::vector<RenderedPixel> image;
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      RenderedPixel pixel;
      const double inverse_depth = plane[0] * u + plane[1] * v + plane[2];
      if (inverse_depth > 0.) {
        pixel.surface = 0;
        pixel.point =
            rayThrough (camera, static_cast<float> (u), static_cast<float> (v)) /
            static_cast<float> (inverse_depth);
        pixel.normal = -normal.normalized().cast<float>();
        pixel.color.setConstant (0.7f);
      }
      image.push_back (pixel);
    }
  Random random (seed);
  return measure (image, camera, random);
}

Depth
maskedBy (const Depth& mask, Depth depth)
{
  for (std::size_t i = 0; i < depth.size(); ++i)
    if (!std::isfinite (mask[i]))
      depth[i] = missing;
  return depth;
}

/** The mean over several measurements. */
PlaneNoise
mean (const std::vector<PlaneNoise>& all)
{
  PlaneNoise sum;
  const double share = 1. / static_cast<double> (all.size());
  for (const auto& noise : all) {
    sum.points += noise.points;
    sum.depth_m += share * noise.depth_m;
    sum.step_m += share * noise.step_m;
    sum.local_rms_m += share * noise.local_rms_m;
    sum.global_rms_m += share * noise.global_rms_m;
    for (std::size_t i = 0; i < PlaneNoise::lags.size(); ++i) {
      sum.correlation_right[i] += share * noise.correlation_right[i];
      sum.correlation_down[i] += share * noise.correlation_down[i];
    }
  }
  return sum;
}

void
print (const std::string& name, const PlaneNoise& noise)
{
  std::printf ("| %s | %.2f | %.1f | %.2f | %.2f |",
               name.c_str(),
               noise.depth_m,
               1e3 * noise.step_m,
               1e3 * noise.local_rms_m,
               1e3 * noise.global_rms_m);
  for (const auto& correlations : {noise.correlation_right, noise.correlation_down}) {
    for (const double correlation : correlations)
      std::printf (" %.2f", correlation);
    std::printf (" |");
  }
  std::printf ("\n");
}

/** Compares recordings of planes with the simulation of the same planes, seen at the
 * same pixels. */
void
compare (const std::string& name,
         const std::vector<Depth>& recordings,
         const Camera& camera = {},
         const Measure& measure = measuredWithKinect)
{
  constexpr unsigned simulations = 10;
  const int width = camera.width;
  std::vector<PlaneNoise> recorded;
  std::vector<PlaneNoise> simulated;
  for (const auto& recording : recordings)
    recorded.push_back (measurePlaneNoise (recording, width));
  for (unsigned seed = 0; seed < simulations; ++seed) {
    const std::size_t i = seed % recordings.size();
    const Depth depth = measurePlane (recorded[i].plane, seed, camera, measure);
    simulated.push_back (measurePlaneNoise (maskedBy (recordings[i], depth), width));
  }
  const PlaneNoise real = mean (recorded);
  const PlaneNoise model = mean (simulated);
  std::printf (
      "| plane | depth m | step mm | local rms mm | global rms mm | correlation at "
      "1 2 4 8 px to the right | downwards |\n");
  print (name + ", recorded", real);
  print (name + ", simulated", model);
  EXPECT_NEAR (model.step_m / real.step_m, 1., 0.25);
  EXPECT_NEAR (model.local_rms_m / real.local_rms_m, 1., 0.25);
  EXPECT_NEAR (model.global_rms_m / real.global_rms_m, 1., 0.25);
  for (std::size_t i = 0; i < PlaneNoise::lags.size(); ++i) {
    EXPECT_NEAR (model.correlation_right[i], real.correlation_right[i], 0.15);
    EXPECT_NEAR (model.correlation_down[i], real.correlation_down[i], 0.15);
  }
}

template <typename PointT>
Depth
readDepth (const std::string& file,
           const std::function<bool (const PointT&, int u, int v)>& is_wanted)
{
  pcl::PointCloud<PointT> cloud;
  const std::string path = synthetic::dataFolder() + "/" + file;
  if (pcl::io::loadPCDFile (path, cloud) != 0)
    throw std::runtime_error ("cannot read " + path);
  Depth depth;
  for (int v = 0; v < static_cast<int> (cloud.height); ++v)
    for (int u = 0; u < static_cast<int> (cloud.width); ++u) {
      const PointT& point = cloud (u, v);
      depth.push_back (is_wanted (point, u, v) ? point.z : missing);
    }
  return depth;
}

/** The part of a depth image where a plane through all of it lies in a range. */
Depth
withinRange (Depth depth, double nearest, double farthest)
{
  const int width = Camera().width;
  const auto plane = measurePlaneNoise (depth, width).plane;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const auto u = static_cast<double> (i % width);
    const auto v = static_cast<double> (i / width);
    const double plane_depth = 1. / (plane[0] * u + plane[1] * v + plane[2]);
    if (!(plane_depth > nearest && plane_depth < farthest))
      depth[i] = missing;
  }
  return depth;
}

} // namespace

TEST (KinectModel, WhatItCannotMeasureIsMissing)
{
  const auto share = [] (const Depth& depth) {
    const auto measured = std::count_if (
        depth.begin(), depth.end(), [] (float z) { return std::isfinite (z); });
    return static_cast<double> (measured) / static_cast<double> (depth.size());
  };
  const auto at = [] (float depth) {
    RenderedPixel pixel;
    pixel.surface = 0;
    pixel.point = {0.f, 0.f, depth};
    pixel.normal = -Eigen::Vector3f::UnitZ();
    pixel.color.setConstant (0.7f);
    return pixel;
  };
  const auto measure = [&] (const RenderedPixel& pixel) {
    const Camera camera;
    Random random (1);
    return share (measureWithKinect (
        std::vector<RenderedPixel> (camera.width * camera.height, pixel),
        camera,
        random,
        random));
  };
  EXPECT_EQ (measure (RenderedPixel()), 0.);
  EXPECT_EQ (measure (at (0.45f)), 0.);
  EXPECT_EQ (measure (at (0.6f)), 1.);
  EXPECT_EQ (measure (at (7.f)), 1.);
  EXPECT_EQ (measure (at (9.f)), 0.);
  RenderedPixel hidden = at (2.f);
  hidden.in_shadow = true;
  EXPECT_EQ (measure (hidden), 0.);
  RenderedPixel dark = at (2.f);
  dark.color.setConstant (0.03f);
  EXPECT_EQ (measure (dark), 0.);
  RenderedPixel grazing = at (2.f);
  grazing.normal = Eigen::Vector3f (0.f, std::sin (1.5f), -std::cos (1.5f));
  EXPECT_EQ (measure (grazing), 0.);
}

/** A board at 1 m in front of a wall at 2 m: the projector, 5 cm to the right of the colour
 * camera, leaves a shadow to the left of the board, the infrared camera, 2.5 cm to the
 * left, one to its right. */
TEST (KinectModel, ShadowsAreAsWideAsTheBaseline)
{
  const Camera camera;
  Scene scene;
  const auto board = [&] (float half, float depth) {
    scene.addPolygon ({{-half, -half, depth},
                       {half, -half, depth},
                       {half, half, depth},
                       {-half, half, depth}},
                      {Eigen::Vector3f::Constant (0.7f)});
  };
  board (0.2f, 1.f);
  board (5.f, 2.f);
  const auto image = render (scene, camera, kinectEyes());
  int left = 0;
  int right = 0;
  for (int u = 0; u < camera.width; ++u)
    if (image[240 * camera.width + u].in_shadow)
      ++(u < camera.width / 2 ? left : right);
  EXPECT_NEAR (left, camera.fx * 0.05f * (1.f / 1.f - 1.f / 2.f), 1.f);
  EXPECT_NEAR (right, camera.fx * 0.025f * (1.f / 1.f - 1.f / 2.f), 1.f);
}

TEST (KinectModel, TheTableAt0m9)
{
  SKIP_WITHOUT_RECORDINGS();
  std::vector<Depth> recordings;
  for (const char* number : {"0", "10", "20", "30", "40"}) {
    constexpr std::uint32_t table = 1;
    const Depth depth = readDepth<pcl::PointXYZL> (
        "mosd_learn/learn" + std::string (number) + ".pcd",
        [] (const auto& point, int, int) { return point.label == table; });
    recordings.push_back (withinRange (depth, 0.8, 1.0));
  }
  compare ("table (mosd_learn)", recordings);
}

TEST (KinectModel, TheWallAt5m)
{
  SKIP_WITHOUT_RECORDINGS();
  compare (
      "wall (kinect/office1)",
      {readDepth<pcl::PointXYZ> ("kinect/office1.pcd", [] (const auto&, int u, int v) {
        return u >= 65 && u < 225 && v >= 20 && v < 180;
      })});
}

TEST (KinectModel, TheFloorAt0m7)
{
  SKIP_WITHOUT_RECORDINGS();
  compare ("floor (kinect/milk_cartoon_all_small_clorox)",
           {readDepth<pcl::PointXYZ> ("kinect/milk_cartoon_all_small_clorox.pcd",
                                      [] (const auto&, int u, int v) {
                                        return u >= 220 && u < 380 && v >= 240 &&
                                               v < 330;
                                      })});
}

TEST (ActiveStereoModel, TheFloorAt1m)
{
  SKIP_WITHOUT_RECORDINGS();
  const Camera camera{640, 480, 383.8f, 383.8f, 321.7f, 236.8f};
  InputOptions input;
  input.input = synthetic::dataFolder() + "/robot_floor/depth";
  input.intrinsics = Intrinsics{camera.fx, camera.fy, camera.cx, camera.cy};
  input.units_per_metre = 1000.f;
  const FrameSource source (input);
  std::vector<Depth> recordings;
  for (std::size_t i = 14; i < source.size(); ++i) {
    const auto cloud = source.read (i).cloud;
    Depth depth;
    for (std::uint32_t v = 0; v < cloud->height; ++v)
      for (std::uint32_t u = 0; u < cloud->width; ++u)
        depth.push_back (u >= 300 && u < 500 && v >= 260 && v < 460 ? (*cloud) (u, v).z
                                                                    : missing);
    recordings.push_back (depth);
  }
  compare ("floor (robot_floor)", recordings, camera, measureWithActiveStereo);
}

TEST (ActiveStereoModel, WhatTheSecondImagerDoesNotSeeIsMissing)
{
  const Camera camera;
  std::vector<RenderedPixel> image (static_cast<std::size_t> (camera.width) *
                                    static_cast<std::size_t> (camera.height));
  for (std::size_t i = 0; i < image.size(); ++i) {
    image[i].surface = 0;
    image[i].point = {0.f, 0.f, 1.f};
    image[i].normal = {0.f, 0.f, -1.f};
  }
  image[1].in_shadow = true;
  image[2].surface = RenderedPixel::no_surface;
  image[3].normal = {1.f, 0.f, -0.1f};
  image[4].point.z() = 0.2f;
  image[5].point.z() = 9.f;
  Random random (1);
  const Depth depth = measureWithActiveStereo (image, camera, random);
  EXPECT_NEAR (depth[0], 1.f, 0.015f);
  for (std::size_t i = 1; i <= 5; ++i)
    EXPECT_FALSE (std::isfinite (depth[i])) << i;
}
