// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_clouds.h"

#include <pcl/common/io.h>
#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>
#include <pcl/simulation/simulate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace plane_clouds;
using synthetic::angleDegrees;

namespace {

using Theirs =
    pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label>;

/** Four columns and three rows of boards, each turned otherwise. */
std::vector<Surface>
boards ()
{
  std::vector<Surface> surfaces;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) {
      surfaces.push_back (tiltedPlane (1.f + 0.1f * static_cast<float> (row + column),
                                       -30.f + 30.f * static_cast<float> (row),
                                       -45.f + 30.f * static_cast<float> (column)));
      surfaces.back().covers = [=] (int u, int v) {
        return u / 160 == column && v / 160 == row && u % 160 > 8 && v % 160 > 8;
      };
    }
  return surfaces;
}

/** A pipeline of PCL as its users write it, compiled for its class and for ours. */
template <typename Segmentation>
Result
runPipeline (const Cloud::ConstPtr& cloud)
{
  Segmentation mps;
  mps.setMinInliers (5000u);
  mps.setAngularThreshold (0.05);
  mps.setDistanceThreshold (0.02);
  mps.setMaximumCurvature (0.01);
  EXPECT_EQ (mps.getMinInliers(), 5000u);
  EXPECT_EQ (mps.getAngularThreshold(), 0.05);
  EXPECT_EQ (mps.getDistanceThreshold(), 0.02);
  EXPECT_FLOAT_EQ (static_cast<float> (mps.getMaximumCurvature()), 0.01f);
  const typename Segmentation::PointCloudNPtr normals = estimateNormals (cloud);
  mps.setInputNormals (normals);
  const typename Segmentation::PointCloudNConstPtr same = mps.getInputNormals();
  EXPECT_EQ (same, normals);
  pcl::PCLBase<pcl::PointXYZ>& base = mps;
  base.setInputCloud (cloud);
  Result result;
  segment (mps, result);
  return result;
}

} // namespace

TEST (PlaneDropIn, SwappingTheTypeNameFindsTheSamePlanes)
{
  const Scene scene = render (corner());
  const Result theirs = runPipeline<Theirs> (scene.cloud);
  const Result ours = runPipeline<Ours> (scene.cloud);
  ASSERT_EQ (theirs.models.size(), 3u);
  ASSERT_EQ (ours.models.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t best = 0;
    pcl::Indices common;
    for (std::size_t j = 0; j < 3; ++j) {
      pcl::Indices both;
      std::set_intersection (theirs.inliers[k].indices.begin(),
                             theirs.inliers[k].indices.end(),
                             ours.inliers[j].indices.begin(),
                             ours.inliers[j].indices.end(),
                             std::back_inserter (both));
      if (both.size() > common.size()) {
        common = both;
        best = j;
      }
    }
    EXPECT_GE (common.size(), 0.95 * theirs.inliers[k].indices.size());
    const float angle = angleDegrees (theirs.normal (k), ours.normal (best));
    EXPECT_LE (std::min (angle, 180.f - angle), 0.2f) << "either sign is theirs";
    EXPECT_TRUE (ours.centroids[best].isApprox (theirs.centroids[k], 0.02f));
  }
}

/** OrganizedMultiPlaneSegmentation turned 146 of 150 normals away. */
TEST (PlaneDropIn, EveryNormalFacesTheSensor)
{
  const auto surfaces = boards();
  const Scene scene = render (surfaces, 640, 480, kinectSigma);
  Ours segmentation;
  Result result;
  for (int frame = 0; frame < 3; ++frame) {
    segment (segmentation, scene.cloud, result);
    ASSERT_EQ (result.models.size(), surfaces.size());
    for (std::size_t k = 0; k < result.models.size(); ++k) {
      const Eigen::Vector3f centroid = result.centroids[k].head<3>();
      EXPECT_LT (result.normal (k).dot (centroid), 0.f);
      EXPECT_GT (result.models[k].values[3], 0.f);
      EXPECT_NEAR (result.normal (k).norm(), 1.f, 1e-5f);
      EXPECT_NEAR (
          result.normal (k).dot (centroid) + result.models[k].values[3], 0.f, 1e-3f)
          << "the plane is that of its points";
    }
  }
}

/** OrganizedMultiPlaneSegmentation read past the end of used labels, and appended. */
TEST (PlaneDropIn, OutputsOfEarlierFramesAreNoInput)
{
  Ours used;
  used.setMinInliers (200);
  Result result;
  result.labels.resize (std::size_t{7});
  for (const int divisor : {4, 1, 2, 4}) {
    const Scene scene = render (corner(), 640 / divisor, 480 / divisor, kinectSigma);
    scene.cloud->header.stamp = static_cast<std::uint64_t> (divisor);
    scene.cloud->header.frame_id = "camera";
    segment (used, scene.cloud, result);
    Ours fresh;
    fresh.setMinInliers (200);
    Result expected;
    segment (fresh, scene.cloud, expected);
    ASSERT_EQ (expected.models.size(), 3u);
    expectSame (result, expected);
    EXPECT_EQ (result.labels.header.stamp, scene.cloud->header.stamp);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ (result.models[k].header.frame_id, "camera");
      EXPECT_EQ (result.inliers[k].header.stamp, scene.cloud->header.stamp);
    }
    for (auto& label : result.labels)
      label.label = 1u << 30; // what the caller did with it
  }
}

TEST (PlaneDropIn, IndicesCountInAnyOrderAndOnce)
{
  const Scene scene = render (corner(), 320, 240, kinectSigma);
  Ours segmentation;
  segmentation.setMinInliers (250);
  Result whole, listed;
  segment (segmentation, scene.cloud, whole);

  auto indices = pcl::make_shared<pcl::Indices> (scene.cloud->size());
  std::iota (indices->rbegin(), indices->rend(), 0);
  indices->insert (indices->end(), 500, 100);
  segmentation.setIndices (indices);
  segment (segmentation, listed);
  expectSame (whole, listed);

  indices->resize (scene.cloud->size() / 2); // the lower half
  segmentation.setIndices (indices);
  segment (segmentation, listed);
  EXPECT_FALSE (listed.models.empty());
  for (std::size_t i = 0; i < scene.cloud->size() / 2; ++i)
    ASSERT_EQ (listed.labels[i].label, Ours::unlabelled);
}

/** OrganizedMultiPlaneSegmentation found two planes. */
TEST (PlaneDropIn, APlaneBehindAStripIsOnePlane)
{
  const auto strip = [] (int u, int) { return u >= 310 && u < 330; };
  for (const bool noise : {false, true}) {
    const Scene scene =
        render ({tiltedPlane (2.f, 0.f, 20.f), {{0.f, 0.f, -1.f}, 1.f, strip}},
                640,
                480,
                [noise] (float z) { return noise ? kinectSigma (z) : 0.f; });
    Ours segmentation;
    Result result;
    segment (segmentation, scene.cloud, result);
    ASSERT_EQ (result.models.size(), 2u);
    std::size_t wall = 0, found = 0;
    for (std::size_t i = 0; i < scene.surface.size(); ++i)
      if (scene.surface[i] == 0) {
        ++wall;
        found += result.labels[i].label == 0;
      }
    EXPECT_GE (static_cast<double> (found), 0.97 * static_cast<double> (wall));
  }
}

/** With its defaults, OrganizedMultiPlaneSegmentation found next to nothing in rooms. */
TEST (PlaneDropIn, TheDefaultsFindWholeRooms)
{
  using namespace pcl::rgbd_planes;
  for (const std::string scene : {"room", "corridor"})
    for (const unsigned seed : {1u, 2u, 3u}) {
      const auto cloud = pcl::make_shared<Cloud>();
      pcl::copyPointCloud (*simulate (scene, seed, Sensor::kinect).cloud, *cloud);
      Ours segmentation;
      Result result;
      segment (segmentation, cloud, result);
      EXPECT_GE (coveredPercent (result, *cloud), 85.) << scene << ' ' << seed;
    }
}

TEST (PlaneDropIn, TheDefaultsFindAWholeRecordedRoom)
{
  SKIP_WITHOUT_RECORDINGS();
  auto cloud = pcl::make_shared<Cloud>();
  const std::string file = synthetic::dataFolder() + "/kinect/office1.pcd";
  ASSERT_EQ (pcl::io::loadPCDFile (file, *cloud), 0);
  Ours segmentation;
  Result result;
  segment (segmentation, cloud, result);
  EXPECT_GE (coveredPercent (result, *cloud), 85.);
}
