// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "warped_corner.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>

using namespace warped_corner;

namespace {

/** Tilts planes by a degree. */
double
linearWarp (double u, double v)
{
  return 6e-6 * (u - 320.) - 8e-6 * (v - 240.);
}

/** A corner without warp and the error that a panel on a wall makes, nearly at right angles to
 * floor and other wall; it has \a size x \a size cells. */
double
errorOfPanel (int size)
{
  Corner corner (320, noWarp, Corner::twoWalls (0.f));
  const Eigen::Vector4f skew = Corner::twoWalls (3.f)[2];
  const auto isOnPanel = [&] (int i) {
    return i % 320 >= 240 && i % 320 < 240 + 4 * size && i / 320 >= 40 &&
           i / 320 < 40 + 4 * size;
  };
  corner.planes.push_back (skew);
  corner.inliers.emplace_back();
  auto &wall = corner.inliers[2].indices, &panel = corner.inliers.back().indices;
  std::copy_if (wall.begin(), wall.end(), std::back_inserter (panel), isOnPanel);
  EXPECT_EQ (static_cast<int> (panel.size()), 16 * size * size);
  wall.erase (std::remove_if (wall.begin(), wall.end(), isOnPanel), wall.end());
  for (const int i : panel) {
    auto p = (*corner.cloud)[static_cast<std::size_t> (i)].getVector3fMap();
    p *= -skew[3] / skew.head<3>().dot (p);
    corner.truth[static_cast<std::size_t> (i)].getVector3fMap() = p;
  }
  return corner.depthError (correct (corner));
}

} // namespace

TEST (DepthWarpCorrection, PlanesTellTheWarpThatTheyShare)
{
  for (const std::uint32_t width : {640u, 320u, 160u}) {
    const Corner corner (width, waves);
    const double before = corner.depthError (*corner.cloud);
    EXPECT_GT (before, 0.01);
    EXPECT_LT (corner.depthError (correct (corner)), before / 4.) << width;
  }
}

TEST (DepthWarpCorrection, WithoutWarpPointsStay)
{
  const Corner corner (320, noWarp);
  EXPECT_LT (corner.depthError (correct (corner)), 1e-4);
}

TEST (DepthWarpCorrection, RightAnglesTellWhatTiltsAllPlanesAlike)
{
  for (const std::uint32_t width : {640u, 160u}) {
    const Corner corner (width, linearWarp, Corner::twoWalls (0.f));
    const double before = corner.depthError (*corner.cloud);
    EXPECT_GT (before, 0.01);
    // The camera comes from the walls.
    const auto errorAfter = [&] (Correction& correction) {
      for (int frame = 0; frame < 30; ++frame) {
        Planes planes = Corner::twoWalls (0.f);
        planes[1][3] += 0.05f * static_cast<float> (frame);
        planes[2][3] += 0.05f * static_cast<float> (frame);
        const Corner seen (width, linearWarp, planes);
        EXPECT_TRUE (correction.addFrame (seen.cloud, seen.models(), seen.inliers));
      }
      return corner.depthError (correctWith (correction, corner.cloud));
    };
    Correction with, without;
    EXPECT_TRUE (with.getRightAngles());
    without.setRightAngles (false);
    EXPECT_FALSE (without.getRightAngles());
    EXPECT_LT (errorAfter (with), before / 2.) << width;
    EXPECT_GT (errorAfter (without), 0.75 * before) << width;
  }
}

TEST (DepthWarpCorrection, OtherAnglesStay)
{
  for (const float skew : {5.f, -5.f, 20.f}) {
    const Corner corner (320, noWarp, Corner::twoWalls (skew));
    EXPECT_LT (corner.depthError (correct (corner)), 1e-4) << skew;
  }
}

TEST (DepthWarpCorrection, SmallPlanesHardlyTellAngles)
{
  EXPECT_LT (errorOfPanel (12), 1e-4);
  EXPECT_LT (errorOfPanel (13), 2e-3);
  EXPECT_GT (errorOfPanel (13), 1e-4);
}

TEST (DepthWarpCorrection, PlanesNeedNotBeGood)
{
  Corner corner (320, noWarp);
  for (auto& plane : corner.planes) {
    plane[3] *= 1.01f; // 4 cm at 4 m
    plane.head<3>() =
        Eigen::AngleAxisf (0.02f, Eigen::Vector3f::UnitY()) * plane.head<3>();
  }
  EXPECT_LT (corner.depthError (correct (corner)), 0.003);
}

TEST (DepthWarpCorrection, NormalsMayPointAnywhere)
{
  Corner corner (160, waves);
  const Cloud expected = correct (corner);
  corner.planes[1] = -corner.planes[1];
  corner.planes[2] *= 2.f;
  const Cloud actual = correct (corner);
  for (std::size_t i = 0; i < actual.size(); ++i)
    EXPECT_NEAR (actual[i].z, expected[i].z, 1e-5f);
}

TEST (DepthWarpCorrection, PointsKeepTheirPixels)
{
  const Corner corner (160, waves);
  const Cloud output = correct (corner);
  EXPECT_EQ (output.width, 160u);
  EXPECT_EQ (output.height, 120u);
  for (std::size_t i = 0; i < output.size(); ++i) {
    EXPECT_NEAR (
        output[i].x / output[i].z, corner.truth[i].x / corner.truth[i].z, 1e-5);
    EXPECT_NEAR (
        output[i].y / output[i].z, corner.truth[i].y / corner.truth[i].z, 1e-5);
  }
}

TEST (DepthWarpCorrection, ACameraMayBeOnItsSide)
{
  const Corner corner (320, waves);
  const std::uint32_t width = corner.cloud->height, height = corner.cloud->width;
  const auto transposed = [&] (int index) {
    return index % static_cast<int> (height) * static_cast<int> (width) +
           index / static_cast<int> (height);
  };
  auto cloud = pcl::make_shared<Cloud> (width, height);
  for (int i = 0; i < static_cast<int> (cloud->size()); ++i) {
    const auto& p = (*corner.cloud)[static_cast<std::size_t> (i)];
    (*cloud)[static_cast<std::size_t> (transposed (i))].getVector3fMap() << p.y, p.x,
        p.z;
  }
  Models models = corner.models();
  for (auto& model : models)
    std::swap (model.values[0], model.values[1]);
  Inliers inliers = corner.inliers;
  for (auto& of_plane : inliers)
    for (int& index : of_plane.indices)
      index = transposed (index);
  Correction correction;
  ASSERT_TRUE (correction.addFrame (cloud, models, inliers));
  const Cloud upright = correct (corner), turned = correctWith (correction, cloud);
  for (int i = 0; i < static_cast<int> (cloud->size()); ++i)
    EXPECT_NEAR (turned[static_cast<std::size_t> (transposed (i))].z,
                 upright[static_cast<std::size_t> (i)].z,
                 1e-3f);
}

TEST (DepthWarpCorrection, IndicesThatAreGivenTwiceCountOnce)
{
  const Corner corner (160, waves);
  Correction correction;
  ASSERT_TRUE (correction.addFrame (corner.cloud, corner.models(), corner.inliers));
  const Cloud once = correctWith (correction, corner.cloud);
  Cloud twice;
  auto indices = pcl::make_shared<pcl::Indices>();
  for (int i = 0; i < static_cast<int> (corner.cloud->size()); ++i)
    indices->insert (indices->end(), 2, i);
  correction.setIndices (indices);
  correction.filter (twice);
  for (std::size_t i = 0; i < once.size(); ++i)
    EXPECT_EQ (once[i].getVector3fMap(), twice[i].getVector3fMap());
}

TEST (DepthWarpCorrection, FramesAddWhatTheyTell)
{
  // Each of two frames has the planes of one half of the image.
  const Corner corner (320, waves);
  Inliers halves[2] = {Inliers (4), Inliers (4)};
  for (std::size_t k = 0; k < 4; ++k)
    for (const int i : corner.inliers[k].indices)
      halves[i % 320 < 160 ? 0 : 1][k].indices.push_back (i);
  double alone[2];
  Correction both;
  for (std::size_t h = 0; h < 2; ++h) {
    Correction one;
    ASSERT_TRUE (one.addFrame (corner.cloud, corner.models(), halves[h]));
    alone[h] = corner.depthError (correctWith (one, corner.cloud));
    ASSERT_TRUE (both.addFrame (corner.cloud, corner.models(), halves[h]));
  }
  EXPECT_EQ (both.getNumberOfFrames(), 2u);
  EXPECT_LT (corner.depthError (correctWith (both, corner.cloud)),
             0.5 * std::min (alone[0], alone[1]));
}

/** What is seen once more tells nothing: the same errors would seem to be certain. */
TEST (DepthWarpCorrection, FramesOfACameraThatStandsAreOneView)
{
  const Corner corner (160, waves), other (160, noWarp);
  Correction once, often;
  ASSERT_TRUE (once.addFrame (corner.cloud, corner.models(), corner.inliers));
  for (int k = 0; k < 20; ++k)
    ASSERT_TRUE (often.addFrame (corner.cloud, corner.models(), corner.inliers));
  EXPECT_EQ (often.getNumberOfFrames(), 20u);
  expectSameBytes (correctWith (often, corner.cloud), correctWith (once, corner.cloud));
  ASSERT_TRUE (often.addFrame (other.cloud, other.models(), other.inliers));
  EXPECT_NE (corner.depthError (correctWith (often, corner.cloud)),
             corner.depthError (correctWith (once, corner.cloud)));
}

TEST (DepthWarpCorrection, TheWarpMovesToAnotherObject)
{
  const Corner corner (160, waves), other (320, waves);
  Correction learned, given;
  EXPECT_TRUE (learned.getWarp().empty());
  ASSERT_TRUE (learned.addFrame (corner.cloud, corner.models(), corner.inliers));
  const auto warp = learned.getWarp();
  ASSERT_EQ (warp.width, 160u);
  ASSERT_EQ (warp.height, 120u);
  ASSERT_TRUE (given.setWarp (warp));
  EXPECT_EQ (given.getNumberOfFrames(), 0u);
  const Cloud corrected = correct (corner);
  expectSameBytes (correctWith (given, corner.cloud), corrected);
  EXPECT_TRUE (correctWith (given, other.cloud).empty()) << "another size";
  const auto lower = pcl::make_shared<Cloud> (160, 100);
  EXPECT_TRUE (correctWith (given, lower).empty()) << "another height";

  // Frames take its place, if they tell something.
  ASSERT_TRUE (given.addFrame (corner.cloud, {}, {}));
  expectSameBytes (correctWith (given, corner.cloud), corrected);
  const Corner straight (160, noWarp);
  ASSERT_TRUE (given.addFrame (corner.cloud, corner.models(), corner.inliers));
  expectSameBytes (correctWith (given, corner.cloud), corrected);
  ASSERT_TRUE (given.addFrame (straight.cloud, straight.models(), straight.inliers));
  EXPECT_EQ (given.getNumberOfFrames(), 2u) << "that tell something";
  ASSERT_TRUE (given.setWarp (warp));
  expectSameBytes (correctWith (given, corner.cloud), corrected);
  EXPECT_EQ (given.getNumberOfFrames(), 0u);
  given.clearFrames();
  EXPECT_TRUE (given.getWarp().empty());
  EXPECT_TRUE (correctWith (given, corner.cloud).empty());
}

TEST (DepthWarpCorrection, WhatIsNoWarpIsRefused)
{
  Correction correction;
  pcl::PointCloud<pcl::Intensity> warp;
  EXPECT_FALSE (correction.setWarp (warp));
  warp.resize (19200);
  EXPECT_FALSE (correction.setWarp (warp)) << "a row";
  warp.width = 160;
  warp.height = 120;
  warp[77].intensity = not_a_number;
  EXPECT_FALSE (correction.setWarp (warp));
  EXPECT_TRUE (correction.getWarp().empty());
  warp[77].intensity = 0.1f;
  EXPECT_TRUE (correction.setWarp (warp));
  const Corner corner (160, noWarp);
  const Cloud output = correctWith (correction, corner.cloud);
  const float z = (*corner.cloud)[77].z;
  EXPECT_NEAR (1.f / output[77].z, 1.f / z - 0.1f, 1e-5f);
  EXPECT_EQ (output[78].z, (*corner.cloud)[78].z);
}
