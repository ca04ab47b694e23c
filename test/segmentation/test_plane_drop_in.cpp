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

/** The outputs of the pipeline. */
struct Pipeline {
  Result segmented;
  std::vector<pcl::PlanarRegion<pcl::PointXYZ>,
              Eigen::aligned_allocator<pcl::PlanarRegion<pcl::PointXYZ>>>
      regions;
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers, label_indices, boundaries;
  pcl::PointCloud<pcl::Label>::Ptr labels =
      pcl::make_shared<pcl::PointCloud<pcl::Label>>();
};

/** All overloads, as users of PCL call them, compiled for its class and for ours. */
template <typename Segmentation>
Pipeline
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
  EXPECT_EQ (mps.getMaximumCurvature(), 0.01);
  const typename Segmentation::PointCloudNPtr normals = estimateNormals (cloud);
  mps.setInputNormals (normals);
  const typename Segmentation::PointCloudNConstPtr same = mps.getInputNormals();
  EXPECT_EQ (same, normals);
  pcl::PCLBase<pcl::PointXYZ>& base = mps;
  base.setInputCloud (cloud);
  mps.setProjectPoints (true);
  Pipeline result;
  segment (mps, result.segmented);
  Result refined = result.segmented;
  auto labels = pcl::make_shared<pcl::PointCloud<pcl::Label>> (refined.labels);
  mps.refine (refined.models, refined.inliers, labels, refined.label_indices);
  Result models_only; // PCL appends to what it is given
  mps.segment (models_only.models, models_only.inliers);
  EXPECT_EQ (models_only.models.size(), refined.models.size());
  mps.segment (result.regions);
  mps.segmentAndRefine (result.regions);
  mps.segmentAndRefine (result.regions,
                        result.models,
                        result.inliers,
                        result.labels,
                        result.label_indices,
                        result.boundaries);
  return result;
}

/** The number of elements that two ascending lists have in common. */
std::size_t
inBoth (const pcl::Indices& a, const pcl::Indices& b)
{
  pcl::Indices both;
  std::set_intersection (
      a.begin(), a.end(), b.begin(), b.end(), std::back_inserter (both));
  return both.size();
}

} // namespace

TEST (PlaneDropIn, SwappingTheTypeNameFindsTheSamePlanes)
{
  const Scene scene = render (corner());
  const Pipeline theirs = runPipeline<Theirs> (scene.cloud);
  const Pipeline ours = runPipeline<Ours> (scene.cloud);
  ASSERT_EQ (theirs.regions.size(), 3u);
  ASSERT_EQ (ours.regions.size(), 3u);
  ASSERT_EQ (ours.segmented.models.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    auto inliers = theirs.inliers[k].indices;
    std::sort (inliers.begin(), inliers.end());
    std::size_t best = 0;
    for (std::size_t j = 1; j < 3; ++j)
      if (inBoth (inliers, ours.inliers[j].indices) >
          inBoth (inliers, ours.inliers[best].indices))
        best = j;
    EXPECT_GE (inBoth (inliers, ours.inliers[best].indices), 0.95 * inliers.size());
    const auto& region = ours.regions[best];
    EXPECT_TRUE (
        region.getCentroid().isApprox (theirs.regions[k].getCentroid(), 0.02f));
    const float angle = angleDegrees (region.getCoefficients().head<3>(),
                                      theirs.regions[k].getCoefficients().head<3>());
    EXPECT_LE (std::min (angle, 180.f - angle), 0.2f) << "either sign is theirs";
    EXPECT_EQ (region.getContour().size(), ours.boundaries[best].indices.size());
    EXPECT_EQ (ours.models[best].values, ours.segmented.models[best].values)
        << "refined or not";
  }
}

/** OrganizedMultiPlaneSegmentation gave no contour to a plane whose last pixel is the
 * lower right one of the image, for it looks for another label next to it. */
TEST (PlaneDropIn, EveryPlaneHasAContour)
{
  const Scene scene = render ({tiltedPlane (1.f, 0.f, 20.f)});
  const Pipeline ours = runPipeline<Ours> (scene.cloud);
  ASSERT_EQ (ours.regions.size(), 1u);
  EXPECT_EQ (ours.boundaries[0].indices.size(), 2u * (640 + 480) - 4);
  EXPECT_EQ (ours.regions[0].getContour().size(), 2u * (640 + 480) - 4);
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

/** Neither indices nor measured points have to lie where the segmentation looks first. */
TEST (PlaneDropIn, EverySecondPixelIsEnough)
{
  const Scene scene = render (corner(), 320, 240, kinectSigma);
  const Normals::Ptr normals = estimateNormals (scene.cloud);
  for (const int du : {0, 1})
    for (const int dv : {0, 1}) {
      const auto indices = pcl::make_shared<pcl::Indices>();
      const auto holes =
          pcl::make_shared<Cloud> (320, 240, pcl::PointXYZ (0.f, 0.f, 0.f));
      for (int v = dv; v < 240; v += 2)
        for (int u = du; u < 320; u += 2) {
          indices->push_back (v * 320 + u);
          (*holes) (u, v) = (*scene.cloud) (u, v);
        }
      Ours listed, measured;
      listed.setInputCloud (scene.cloud);
      listed.setIndices (indices);
      measured.setInputCloud (holes);
      for (Ours* segmentation : {&listed, &measured}) {
        segmentation->setMinInliers (250);
        segmentation->setInputNormals (normals);
        Result result;
        segment (*segmentation, result);
        EXPECT_EQ (result.models.size(), 3u)
            << (segmentation == &listed ? "indices" : "points") << " from " << du
            << ", " << dv;
      }
    }
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
