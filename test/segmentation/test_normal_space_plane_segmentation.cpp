// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "room_corner.h"

#include <pcl/common/io.h>
#include <pcl/common/point_tests.h>
#include <pcl/features/integral_image_normal.h>
#include <pcl/io/pcd_io.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace plane_clouds;
using namespace room_corner;

TEST (NormalSpacePlanes, FindsTheThreePlanesOfARoomCorner)
{
  const Scene ideal = render (corner());
  expectPlanes (ideal, corner(), segment (ideal.cloud), 0.05f, 0.0005f, 0.01);
  const Scene noisy = render (corner(), 640, 480, kinectSigma);
  expectPlanes (noisy, corner(), segment (noisy.cloud), 0.3f, 0.005f, 0.03);
}

TEST (NormalSpacePlanes, WorksAtEveryResolution)
{
  for (const int divisor : {2, 4}) {
    const Scene scene = render (corner(), 640 / divisor, 480 / divisor, kinectSigma);
    const auto min_inliers = static_cast<unsigned> (1000 / (divisor * divisor));
    expectPlanes (
        scene, corner(), segment (scene.cloud, min_inliers), 0.5f, 0.01f, 0.05);
  }
}

TEST (NormalSpacePlanes, ParallelPlanesAreSplitInDistanceSpace)
{
  const auto box = [] (int u, int v) {
    return u > 200 && u < 420 && v > 150 && v < 330;
  };
  const Eigen::Vector3f up = tiltedPlane (1.f, 40.f, 0.f).normal;
  const std::vector<Surface> planes{{up, 0.75f}, {up, 0.70f, box}};
  for (const bool noise : {false, true}) {
    const Scene scene = render (
        planes, 640, 480, [noise] (float z) { return noise ? kinectSigma (z) : 0.f; });
    expectPlanes (scene, planes, segment (scene.cloud), 0.3f, 0.003f, 0.02);
  }
}

TEST (NormalSpacePlanes, UnconnectedPartsOfAPlaneAreOneCluster)
{
  // A wall behind a post 60 pixels wide: OrganizedMultiPlaneSegmentation finds two
  // walls.
  const auto post = [] (int u, int) { return u >= 300 && u < 360; };
  const std::vector<Surface> planes{tiltedPlane (2.f, 0.f, 20.f),
                                    {{0.f, 0.f, -1.f}, 1.f, post}};
  const Scene scene = render (planes);
  expectPlanes (scene, planes, segment (scene.cloud), 0.05f, 0.0005f, 0.01);
}

TEST (NormalSpacePlanes, HolesBelongToNoPlane)
{
  Scene scene = render (corner());
  std::mt19937 generator (2);
  for (std::size_t i = 0; i < scene.cloud->size(); ++i)
    if (generator() % 3 == 0)
      (*scene.cloud)[i].getVector3fMap().setConstant (i % 2 ? synthetic::nan : 0.f);
  const Result result = segment (scene.cloud);
  for (std::size_t i = 0; i < scene.cloud->size(); ++i)
    if ((*scene.cloud)[i].z == 0.f || std::isnan ((*scene.cloud)[i].z)) {
      ASSERT_EQ (result.labels[i].label, Segmentation::unlabelled);
      scene.surface[i] = -1;
    }
  expectPlanes (scene, corner(), result, 0.05f, 0.0005f, 0.01);
}

TEST (NormalSpacePlanes, NothingToFindIsNoError)
{
  auto empty = pcl::make_shared<Cloud> (64, 48, pcl::PointXYZ (0.f, 0.f, 0.f));
  EXPECT_TRUE (segment (empty).models.empty());
  const Scene scene = render (corner(), 64, 48);
  const Result result = segment (scene.cloud, 64 * 48 + 1);
  EXPECT_TRUE (result.models.empty());
  for (const auto& label : result.labels)
    ASSERT_EQ (label.label, Segmentation::unlabelled);
}

TEST (NormalSpacePlanes, TakesTheNormalsOfOtherClasses)
{
  const Scene scene = render (corner());
  auto normals = pcl::make_shared<Normals>();
  pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod (estimation.AVERAGE_3D_GRADIENT);
  estimation.setInputCloud (scene.cloud);
  estimation.compute (*normals); // without curvature
  Segmentation segmentation;
  segmentation.setInputCloud (scene.cloud);
  segmentation.setInputNormals (normals);
  Result result;
  segment (segmentation, result);
  expectPlanes (scene, corner(), result, 0.1f, 0.001f, 0.02);
}

/** The largest plane of a table-top recording is the table of its hand-made labels, with the ends
 * that the camera bends. */
TEST (NormalSpacePlanes, FindsTheTableOfRecordings)
{
  SKIP_WITHOUT_RECORDINGS();
  for (const std::string name : {"learn0", "learn5", "learn12", "learn20", "learn30"}) {
    pcl::PointCloud<pcl::PointXYZL> labelled;
    ASSERT_EQ (pcl::io::loadPCDFile (
                   synthetic::dataFolder() + "/mosd_learn/" + name + ".pcd", labelled),
               0);
    auto cloud = pcl::make_shared<Cloud>();
    pcl::copyPointCloud (labelled, *cloud);
    const Result result = segment (cloud);
    ASSERT_FALSE (result.models.empty()) << name;
    double both = 0., either = 0.;
    for (std::size_t i = 0; i < labelled.size(); ++i)
      if (pcl::isFinite (labelled[i])) {
        const bool is_table = labelled[i].label >= 1 && labelled[i].label <= 9;
        const bool is_found = result.labels[i].label == 0;
        both += is_table && is_found;
        either += is_table || is_found;
      }
    EXPECT_GE (both / either, 0.988) << name;
  }
}
