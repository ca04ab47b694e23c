// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "warped_corner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

using namespace warped_corner;

TEST (DepthWarpInputs, WhatIsNoPlaneTellsNothing)
{
  Corner corner (320, waves);
  const auto moveTo =
      [&] (std::size_t u0, std::size_t v0, std::size_t u1, std::size_t v1) {
        corner.inliers.emplace_back();
        for (auto& inliers : corner.inliers)
          inliers.indices.erase (
              std::remove_if (inliers.indices.begin(),
                              inliers.indices.end(),
                              [&] (int i) {
                                const auto u = static_cast<std::size_t> (i % 320),
                                           v = static_cast<std::size_t> (i / 320);
                                return u >= u0 && u < u1 && v >= v0 && v < v1;
                              }),
              inliers.indices.end());
        for (std::size_t v = v0; v < v1; ++v)
          for (std::size_t u = u0; u < u1; ++u)
            corner.inliers.back().indices.push_back (static_cast<int> (v * 320 + u));
      };
  moveTo (0, 0, 16, 16);     // 4 x 4 cells
  moveTo (100, 20, 140, 60); // a plane through the camera
  moveTo (200, 20, 240, 60); // nonsense
  const Planes good = corner.planes;
  corner.planes.push_back ({0.f, 0.f, -1.f, 2.f});
  corner.planes.push_back ({0.f, 0.f, -1.f, 0.f});
  corner.planes.push_back ({not_a_number, 0.f, -1.f, 2.f});
  const Cloud with = correct (corner);
  corner.planes = good;
  corner.inliers.resize (4);
  expectSameBytes (with, correct (corner));
}

TEST (DepthWarpInputs, CellsWithFewPointsDoNotCount)
{
  // Every second cell of 4 x 4 pixels has one point left, a wrong one.
  const Corner corner (320, noWarp);
  for (std::uint32_t v = 0; v < 240; ++v)
    for (std::uint32_t u = 0; u < 320; ++u)
      if ((u / 4 + v / 4) % 2) {
        auto p = (*corner.cloud) (u, v).getVector3fMap();
        if (u % 4 || v % 4)
          p.setConstant (not_a_number);
        else
          p *= 1.1f;
      }
  const Cloud output = correct (corner);
  for (std::size_t i = 0; i < output.size(); ++i)
    if ((i % 320 / 4 + i / 320 / 4) % 2 == 0) {
      EXPECT_NEAR (output[i].z, corner.truth[i].z, 1e-3f);
    }
}

TEST (DepthWarpInputs, PointsAtTheCameraTellNothing)
{
  const Corner corner (160, waves);
  for (std::uint32_t v = 0; v < 20; ++v)
    for (std::uint32_t u = 0; u < 20; ++u) {
      auto p = (*corner.cloud) (u, v).getVector3fMap();
      p *= 1e-39f / p.z();
    }
  const Cloud near = correct (corner);
  for (std::uint32_t v = 0; v < 20; ++v)
    for (std::uint32_t u = 0; u < 20; ++u)
      (*corner.cloud) (u, v).getVector3fMap().setConstant (not_a_number);
  const Cloud missing = correct (corner);
  for (std::size_t i = 20 * 160; i < near.size(); ++i)
    EXPECT_EQ (near[i].z, missing[i].z) << i;
  EXPECT_LT (std::abs (near.back().z - corner.truth.back().z), 0.02f);
}

TEST (DepthWarpInputs, PointsBeyondTheRangeOfTheSensorTellNothing)
{
  const Corner corner (160, waves);
  Correction correction;
  correction.setDepthNoise ({0.001f, 0.002f, 1.f});
  EXPECT_EQ (correction.getDepthNoise().max_range, 1.f);
  correction.setDepthNoise ({0.001f, 0.002f, 0.f});
  EXPECT_EQ (correction.getDepthNoise().max_range, 1.f);
  ASSERT_TRUE (correction.addFrame (corner.cloud, corner.models(), corner.inliers));
  expectSameBytes (correctWith (correction, corner.cloud), *corner.cloud);
}

TEST (DepthWarpInputs, PointsFarBesideTheCameraTellNothing)
{
  const Corner corner (160, waves);
  corner.cloud->front().getVector3fMap() << 1e38f, 0.f, 0.01f;
  Correction correction;
  ASSERT_TRUE (correction.addFrame (corner.cloud, corner.models(), corner.inliers));
  for (const auto& pixel : correction.getWarp())
    ASSERT_TRUE (std::isfinite (pixel.intensity));
}

TEST (DepthWarpInputs, FramesWithoutPlanesTellNothing)
{
  const Corner corner (160, waves);
  Correction correction;
  EXPECT_TRUE (correction.addFrame (corner.cloud, {}, {}));
  expectSameBytes (correctWith (correction, corner.cloud), *corner.cloud);
}

TEST (DepthWarpInputs, WhatHasNoDepthStays)
{
  const Corner corner (160, waves);
  Correction correction;
  ASSERT_TRUE (correction.addFrame (corner.cloud, corner.models(), corner.inliers));
  const float inf = std::numeric_limits<float>::infinity();
  const auto cloud = pcl::make_shared<Cloud> (*corner.cloud);
  const Eigen::Vector3f strange[] = {{not_a_number, not_a_number, not_a_number},
                                     {0.f, 0.f, 0.f},
                                     {0.1f, 0.1f, inf},
                                     {not_a_number, 0.1f, 2.f},
                                     {0.1f, -inf, 2.f},
                                     {0.1f, 0.2f, -3.f},
                                     {3.f, 2.f, 1e30f}};
  for (std::size_t i = 0; i < std::size (strange); ++i)
    (*cloud)[i].getVector3fMap() = strange[i];
  for (std::size_t i = 1000; i < cloud->size(); i += 100) // both too near and too far
    (*cloud)[i].z = 1e8f;
  const Cloud output = correctWith (correction, cloud);
  for (std::size_t i = 1000; i < cloud->size(); i += 100)
    EXPECT_EQ (output[i].z, 1e8f) << i;
  for (std::size_t i = 0; i < std::size (strange); ++i)
    for (Eigen::Index k = 0; k < 3; ++k)
      EXPECT_TRUE (std::isnan (strange[i][k])
                       ? std::isnan (output[i].getVector3fMap()[k])
                       : output[i].getVector3fMap()[k] == strange[i][k])
          << i;
  EXPECT_NE (output[100].z, (*cloud)[100].z);
}

TEST (DepthWarpInputs, OnlyIndicesMoveAndOtherFieldsStay)
{
  const Corner corner (160, waves);
  pcl::DepthWarpCorrection<pcl::PointXYZRGB> correction;
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>> (160, 120);
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    (*cloud)[i].getVector3fMap() = (*corner.cloud)[i].getVector3fMap();
    (*cloud)[i].rgba = static_cast<std::uint32_t> (i);
  }
  cloud->header.frame_id = "camera";
  ASSERT_TRUE (correction.addFrame (cloud, corner.models(), corner.inliers));
  const Cloud all = correct (corner);
  correction.setInputCloud (cloud);
  const auto some = pcl::make_shared<pcl::Indices> (pcl::Indices{200, 5000, 19000});
  correction.setIndices (some);
  pcl::PointCloud<pcl::PointXYZRGB> output;
  correction.filter (output);
  EXPECT_EQ (output.header.frame_id, "camera");
  ASSERT_EQ (output.size(), cloud->size());
  for (std::size_t i = 0; i < output.size(); ++i) {
    const bool moves =
        std::count (some->begin(), some->end(), static_cast<int> (i)) > 0;
    EXPECT_EQ (output[i].z, moves ? all[i].z : (*cloud)[i].z) << i;
    EXPECT_EQ (output[i].rgba, i);
  }
  correction.filter (*cloud); // in place
  for (std::size_t i = 0; i < output.size(); ++i)
    EXPECT_EQ ((*cloud)[i].z, output[i].z);
}

TEST (DepthWarpInputs, AnotherCamera)
{
  Correction correction;
  for (const std::uint32_t width : {320u, 161u, 8u, 320u}) {
    const Corner corner (width, waves);
    ASSERT_TRUE (correction.addFrame (corner.cloud, corner.models(), corner.inliers));
    EXPECT_EQ (correction.getNumberOfFrames(), 1u);
    expectSameBytes (correctWith (correction, corner.cloud), correct (corner));
    correction.clearFrames();
    EXPECT_EQ (correction.getNumberOfFrames(), 0u);
  }
}

TEST (DepthWarpInputs, WrongUseIsAnErrorAndLeavesNothing)
{
  const Corner corner (160, waves), other (320, waves);
  const Models models = corner.models();
  Correction correction;
  EXPECT_TRUE (correctWith (correction, corner.cloud).empty()) << "no frames";

  EXPECT_FALSE (correction.addFrame (corner.cloud, models, Inliers (3)));
  EXPECT_FALSE (correction.addFrame (corner.cloud, models, other.inliers));
  Inliers negative (4);
  negative[2].indices = {-1};
  EXPECT_FALSE (correction.addFrame (corner.cloud, models, negative));
  const auto row = pcl::make_shared<Cloud>();
  row->resize (19200);
  EXPECT_FALSE (correction.addFrame (row, models, corner.inliers));
  EXPECT_FALSE (correction.addFrame (pcl::make_shared<Cloud>(), models, Inliers (4)));
  EXPECT_FALSE (correction.addFrame (nullptr, models, corner.inliers));
  EXPECT_EQ (correction.getNumberOfFrames(), 0u);

  EXPECT_TRUE (correction.addFrame (corner.cloud, models, corner.inliers));
  EXPECT_FALSE (correction.addFrame (other.cloud, models, other.inliers));
  EXPECT_EQ (correction.getNumberOfFrames(), 1u);
  EXPECT_TRUE (correctWith (correction, other.cloud).empty()) << "another size";
  EXPECT_TRUE (correctWith (correction, row).empty());
  correction.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{19200}));
  EXPECT_TRUE (correctWith (correction, corner.cloud).empty()) << "an index outside";
}

TEST (DepthWarpInputs, PlanesOfAnotherCloudAreRefused)
{
  Corner corner (160, waves);
  Correction correction;
  for (auto& plane : corner.planes) // as CameraToBase turns them
    plane.head<3>() = Eigen::Vector3f (plane.z(), -plane.x(), -plane.y());
  EXPECT_FALSE (correction.addFrame (corner.cloud, corner.models(), corner.inliers));
  EXPECT_EQ (correction.getNumberOfFrames(), 0u);
  EXPECT_TRUE (correctWith (correction, corner.cloud).empty()) << "no frames";
}

TEST (DepthWarpInputs, CloudsOfAnotherFrameAreRefused)
{
  const Corner corner (160, waves);
  Correction correction;
  ASSERT_TRUE (correction.addFrame (corner.cloud, corner.models(), corner.inliers));
  corner.cloud->sensor_origin_.z() = 1.f;
  EXPECT_FALSE (correction.addFrame (corner.cloud, corner.models(), corner.inliers));
  EXPECT_EQ (correction.getNumberOfFrames(), 1u);
  EXPECT_TRUE (correctWith (correction, corner.cloud).empty());
}
