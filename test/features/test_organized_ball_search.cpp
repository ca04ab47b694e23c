// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "organized_ball_search.h"
#include "synthetic_clouds.h"

#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/io/pcd_io.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>

using namespace pcl::rgbd_planes;
using synthetic::Cloud;

namespace {

float
linearRadius (float z)
{
  return 0.01f + 0.01f * z;
}

/** A pinhole image of steps in depth with random noise, NaN and (0, 0, 0) holes. */
Cloud::Ptr
makeSteps (std::uint32_t width, std::uint32_t height)
{
  std::mt19937 random (7);
  std::uniform_real_distribution<float> uniform (0.f, 1.f);
  Cloud::Ptr cloud (new Cloud (width, height));
  for (std::uint32_t v = 0; v < height; ++v)
    for (std::uint32_t u = 0; u < width; ++u) {
      const float x =
          (static_cast<float> (u) - 0.5f * static_cast<float> (width)) / 131.f;
      const float y =
          (static_cast<float> (v) - 0.5f * static_cast<float> (height)) / 131.f;
      const float z =
          0.5f + static_cast<float> ((u / 13 + v / 9) % 4) + 0.02f * uniform (random);
      const float hole = uniform (random);
      cloud->at (u, v) =
          hole < 0.1f ? pcl::PointXYZ (synthetic::nan, synthetic::nan, synthetic::nan)
          : hole < 0.15f ? pcl::PointXYZ (0.f, 0.f, 0.f)
                         : pcl::PointXYZ (x * z, y * z, z);
    }
  return cloud;
}

/** Compares the neighbours of every \a stride-th point with those from FLANN. */
void
expectSameAsFlann (const Cloud::ConstPtr& cloud,
                   const std::function<float (float)>& radius,
                   std::size_t stride = 1)
{
  OrganizedBallSearch search;
  search.setPoints (viewPoints (*cloud));
  const auto measured = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if (isMeasured ((*cloud)[i].data))
      measured->push_back (static_cast<int> (i));
  ASSERT_FALSE (measured->empty());
  pcl::KdTreeFLANN<pcl::PointXYZ> tree (false);
  tree.setInputCloud (cloud, measured);

  std::vector<int> found;
  pcl::Indices expected;
  std::vector<float> distances;
  std::size_t differences = 0;
  for (std::size_t i = 0; i < measured->size(); i += stride) {
    const pcl::PointXYZ& p = (*cloud)[(*measured)[i]];
    search.search (p.data, radius (p.z), found);
    tree.radiusSearch (p, radius (p.z), expected, distances);
    std::sort (found.begin(), found.end());
    std::sort (expected.begin(), expected.end());
    differences += found != expected;
  }
  EXPECT_EQ (differences, 0u) << "of " << measured->size() / stride << " places";
}

void
expectSameAsFlannOnRecording (const std::string& name)
{
  Cloud cloud;
  ASSERT_EQ (pcl::io::loadPCDFile (synthetic::dataFolder() + "/" + name, cloud), 0);
  for (const unsigned step : {1u, 2u, 4u})
    expectSameAsFlann (synthetic::subsample (cloud, step), linearRadius);
}

} // namespace

TEST (OrganizedBallSearch, SameAsFlannOnTableTop)
{
  SKIP_WITHOUT_RECORDINGS();
  expectSameAsFlannOnRecording ("mosd_learn/learn33.pcd");
}

TEST (OrganizedBallSearch, SameAsFlannOnOffice)
{
  SKIP_WITHOUT_RECORDINGS();
  expectSameAsFlannOnRecording ("kinect/office1.pcd");
}

TEST (OrganizedBallSearch, SameAsFlannWithoutCameraModel)
{
  SKIP_WITHOUT_RECORDINGS();
  expectSameAsFlannOnRecording ("synpeb/test_500.pcd");
}

TEST (OrganizedBallSearch, SameAsFlannWithHoles)
{
  expectSameAsFlann (makeSteps (160, 120), linearRadius);
}

TEST (OrganizedBallSearch, SameAsFlannWithBallsAroundTheCamera)
{
  expectSameAsFlann (makeSteps (80, 60), [] (float z) { return 1.2f * z; });
  expectSameAsFlann (
      makeSteps (80, 60), [] (float) { return 10.f; }, 50);
}

TEST (OrganizedBallSearch, SameAsFlannOnOddSizes)
{
  for (const auto& [width, height] :
       {std::pair{1u, 2u}, {3u, 2u}, {2u, 57u}, {61u, 33u}})
    expectSameAsFlann (makeSteps (width, height), [] (float) { return 0.1f; });
}

TEST (OrganizedBallSearch, SameAsFlannOnTheBoundary)
{
  // A lattice with spacings that floats cannot represent, and radii that end on its
  // points.
  Cloud::Ptr lattice (new Cloud (40, 30));
  for (std::uint32_t v = 0; v < 30; ++v)
    for (std::uint32_t u = 0; u < 40; ++u)
      lattice->at (u, v) = {
          0.1f * static_cast<float> (u), 0.1f * static_cast<float> (v), 1.f};
  for (const float radius : {0.1f, 0.2f, 0.3f, 0.5f, 0.1f * std::sqrt (2.f)})
    expectSameAsFlann (lattice, [radius] (float) { return radius; });
}

TEST (OrganizedBallSearch, AnyPlaceMayBeTheCentre)
{
  Cloud cloud (2, 2, pcl::PointXYZ (0.f, 0.f, 1.f));
  OrganizedBallSearch search;
  search.setPoints (viewPoints (cloud));
  std::vector<int> found{42};
  const float near[]{0.f, 0.05f, 1.f}, far[]{0.f, 0.f, 5.f};
  search.search (near, 0.1f, found);
  EXPECT_EQ (found.size(), 4u);
  search.search (far, 0.1f, found);
  EXPECT_TRUE (found.empty());
}

TEST (OrganizedBallSearch, NothingMeasured)
{
  Cloud cloud (8, 8, pcl::PointXYZ (synthetic::nan, 0.f, 1.f));
  OrganizedBallSearch search;
  std::vector<int> found{42};
  const float centre[]{0.f, 0.f, 1.f};
  search.search (centre, 1.f, found);
  EXPECT_TRUE (found.empty());
  search.setPoints (viewPoints (cloud));
  search.search (centre, 1.f, found);
  EXPECT_TRUE (found.empty());
}
