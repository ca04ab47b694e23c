// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_clouds.h"

#include <pcl/common/io.h>
#include <pcl/segmentation/depth_noise_estimation.h>
#include <pcl/segmentation/supported_object_extraction.h>
#include <pcl/simulation/simulate.h>
#include <pcl/simulation/subsample.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

using namespace plane_clouds;
using pcl::rgbd_planes::DepthNoise;
using pcl::rgbd_planes::Sensor;
using pcl::rgbd_planes::simulate;
using pcl::rgbd_planes::SimulatedFrame;

namespace {

/** Segments the cloud of a frame, which it returns. */
Cloud::ConstPtr
segment (const SimulatedFrame& frame, const DepthNoise& noise, Result& result)
{
  auto cloud = pcl::make_shared<Cloud>();
  pcl::copyPointCloud (*frame.cloud, *cloud);
  Ours segmentation;
  segmentation.setDepthNoise (noise);
  plane_clouds::segment (segmentation, cloud, result);
  return cloud;
}

struct Counts {
  std::size_t asked_for = 0, found = 0, correct = 0;
};

/** Adds the true planes of at least 1000 measured points, those found, and how many of them
 * overlap by 80 %. */
void
count (const SimulatedFrame& frame, const DepthNoise& noise, Counts& counts)
{
  Result result;
  const Cloud::ConstPtr cloud = segment (frame, noise, result);

  std::map<std::uint32_t, std::size_t> true_points;
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if (pcl::isFinite ((*cloud)[i]))
      ++true_points[(*frame.truth)[i].label];
  true_points.erase (0);
  for (const auto& plane : true_points)
    counts.asked_for += plane.second >= 1000;
  counts.found += result.inliers.size();
  for (const auto& inliers : result.inliers) {
    std::map<std::uint32_t, std::size_t> common;
    for (const auto i : inliers.indices)
      ++common[(*frame.truth)[static_cast<std::size_t> (i)].label];
    counts.correct +=
        std::any_of (common.begin(), common.end(), [&] (const auto& both) {
          const auto truth = true_points.find (both.first);
          return truth != true_points.end() && truth->second >= 1000 &&
                 10 * both.second >=
                     8 * std::max (truth->second, inliers.indices.size());
        });
  }
}

} // namespace

TEST (ActiveStereo, PlanesAreNoPiecesOfThem)
{
  Counts counts, if_a_kinect_scattered_them;
  DepthNoise noise = DepthNoise::activeStereo();
  for (const char* scene : {"table_cluttered", "crockery"})
    for (unsigned seed = 1; seed <= 10; ++seed) {
      const SimulatedFrame frame = simulate (scene, seed, Sensor::active_stereo);
      count (frame, DepthNoise::activeStereo(), counts);
      noise.normal_scatter = 1.f;
      count (frame, noise, if_a_kinect_scattered_them);
    }
  EXPECT_GE (counts.correct * 100, counts.asked_for * 85)
      << counts.correct << " of " << counts.asked_for;
  EXPECT_GE (counts.correct * 100, counts.found * 85)
      << counts.correct << " of " << counts.found;
  EXPECT_GT (counts.correct, if_a_kinect_scattered_them.correct);
}

TEST (ActiveStereo, NoiseOfATableIsNoObject)
{
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const SimulatedFrame frame = simulate ("table_single", seed, Sensor::active_stereo);
    Result result;
    const Cloud::ConstPtr cloud = segment (frame, DepthNoise::activeStereo(), result);
    pcl::SupportedObjectExtraction<pcl::PointXYZ, pcl::Normal> extraction;
    extraction.setDepthNoise (DepthNoise::activeStereo());
    extraction.setCameraToBase (frame.camera_to_base);
    extraction.setInputCloud (cloud);
    std::vector<pcl::SupportedObject> objects;
    extraction.extract (result.models, result.inliers, objects);
    EXPECT_EQ (objects.size(), 1u) << seed;
  }
}

TEST (ActiveStereo, ItsNoiseIsThePreset)
{
  pcl::DepthNoiseEstimation estimation, at_qvga;
  for (unsigned seed = 1; seed <= 3; ++seed)
    for (const char* scene : {"table_cluttered", "room", "corridor"}) {
      const auto cloud = simulate (scene, seed, Sensor::active_stereo).cloud;
      estimation.addFrame (*cloud);
      at_qvga.addFrame (pcl::rgbd_planes::subsample (*cloud, 2));
    }
  const DepthNoise preset = DepthNoise::activeStereo();
  for (const auto* measured : {&estimation, &at_qvga}) {
    DepthNoise noise;
    ASSERT_TRUE (measured->estimate (noise));
    for (const float range : {1.f, 2.f, 3.f, 5.f})
      EXPECT_NEAR (noise.sigmaAtSquare (range * range) /
                       preset.sigmaAtSquare (range * range),
                   1.,
                   0.25)
          << range;
    EXPECT_NEAR (noise.normal_scatter / preset.normal_scatter, 1., 0.2);
  }
}
