// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace plane_clouds;

namespace {

/** The planes of a wall that fills the image, a third of whose normals are its own.
 * \param[in] noise this many times that of a Kinect */
Result
findWall (float range, float noise)
{
  const std::vector<Surface> wall{tiltedPlane (range, 0.f, 0.f)};
  const Scene scene = render (
      wall, 320, 240, [=] (float z) { return noise * (0.001f + 0.002f * z * z); });
  const Normals::Ptr normals = trueNormals (scene, wall);
  std::mt19937 random (1);
  for (auto& normal : *normals)
    if (random() % 3 != 0) {
      const float angle = 0.001f * static_cast<float> (random() % 6283);
      normal.getNormalVector3fMap() << 0.8f * std::cos (angle), 0.8f * std::sin (angle),
          -0.6f;
    }
  Ours segmentation;
  segmentation.setInputCloud (scene.cloud);
  segmentation.setInputNormals (normals);
  Result result;
  segment (segmentation, result);
  return result;
}

} // namespace

TEST (PlaneNormals, AWallIsFlatWhereItsPointsAreThoughNormalsScatter)
{
  const Result result = findWall (0.8f, 0.f);
  ASSERT_EQ (result.models.size(), 1u);
  EXPECT_GT (result.inliers[0].indices.size(), 320u * 240u * 4 / 5);
}

TEST (PlaneNormals, WhatIsWiderThanClothesIsAWallThoughNormalsScatter)
{
  EXPECT_TRUE (findWall (0.5f, 1.f).models.empty());
  const Result result = findWall (1.6f, 1.f); // 1.4 m high
  ASSERT_EQ (result.models.size(), 1u);
  EXPECT_GT (result.inliers[0].indices.size(), 320u * 240u * 4 / 5);
}

TEST (PlaneNormals, ThoseThatAreAlmostOfUnitLengthCount)
{
  const Scene scene = render (corner(), 320, 240);
  for (const float length : {0.96f, 1.04f}) {
    const Normals::Ptr normals = estimateNormals (scene.cloud);
    for (auto& normal : *normals)
      normal.getNormalVector3fMap() *= length;
    Ours segmentation;
    segmentation.setMinInliers (250);
    segmentation.setInputCloud (scene.cloud);
    segmentation.setInputNormals (normals);
    Result result;
    segment (segmentation, result);
    EXPECT_EQ (result.models.size(), 3u) << length;
  }
}

/** As those that were computed for some pixels only. */
TEST (PlaneNormals, ThoseOfSomePointsAreEnough)
{
  const std::vector<Surface> wall{tiltedPlane (1.5f, 0.f, 0.f)};
  const Scene scene = render (wall, 320, 240); // every third pixel is looked at
  for (const unsigned column : {0u, 1u, 2u}) {
    const Normals::Ptr normals = trueNormals (scene, wall);
    for (unsigned i = 0; i < normals->size(); ++i)
      if (i % 320 % 3 != column)
        (*normals)[i] = pcl::Normal (synthetic::nan, synthetic::nan, synthetic::nan);
    Ours segmentation;
    segmentation.setInputCloud (scene.cloud);
    segmentation.setInputNormals (normals);
    Result result;
    segment (segmentation, result);
    ASSERT_EQ (result.models.size(), 1u) << column;
    EXPECT_EQ (result.inliers[0].indices.size(), 320u * 240u);
  }
}

TEST (PlaneNormals, AnotherLengthOfAllIsTold)
{
  const Scene scene = render (corner(), 320, 240);
  unsigned min_inliers = 250;
  const auto warningFor = [&] (const Normals::Ptr& normals) {
    Ours segmentation;
    segmentation.setMinInliers (min_inliers);
    segmentation.setInputCloud (scene.cloud);
    segmentation.setInputNormals (normals);
    Result result;
    testing::internal::CaptureStderr();
    segment (segmentation, result);
    return testing::internal::GetCapturedStderr();
  };
  for (const float length : {0.f, 0.01f, 0.9f, 1.f, 1.1f, 100.f}) {
    const Normals::Ptr normals = estimateNormals (scene.cloud);
    for (auto& normal : *normals)
      normal.getNormalVector3fMap() *= length;
    const std::string warning = warningFor (normals);
    EXPECT_EQ (std::count (warning.begin(), warning.end(), '\n'), length != 1.f);
    EXPECT_EQ (warning.find ("no normal has a length of 1") != std::string::npos,
               length != 1.f)
        << length << ": " << warning;
  }
  // It is not for their length that there are no planes.
  min_inliers = 1000000;
  EXPECT_EQ (warningFor (estimateNormals (scene.cloud)), "");
  constexpr float missing = synthetic::nan;
  EXPECT_NE (warningFor (pcl::make_shared<Normals> (
                             320, 240, pcl::Normal (missing, missing, missing)))
                 .find ("no normal has a length of 1"),
             std::string::npos);
  const Normals::Ptr one = estimateNormals (scene.cloud);
  for (std::size_t i = 2; i < one->size(); ++i)
    (*one)[i].getNormalVector3fMap() *= 100.f;
  EXPECT_EQ (warningFor (one), "");
}
