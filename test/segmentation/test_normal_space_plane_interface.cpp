// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "room_corner.h"

#include <pcl/common/centroid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <vector>

using namespace plane_clouds;
using namespace room_corner;

TEST (NormalSpacePlaneInterface, OutputsAgreeWithEachOther)
{
  Scene scene = render (corner(), 320, 240, kinectSigma);
  scene.cloud->header.frame_id = "camera";
  scene.cloud->header.stamp = 77;
  scene.cloud->sensor_orientation_ = {0.f, 1.f, 0.f, 0.f};
  const Result result = segment (scene.cloud, 250);
  ASSERT_EQ (result.models.size(), 3u);
  ASSERT_EQ (result.labels.width, 320u);
  ASSERT_EQ (result.labels.height, 240u);
  EXPECT_EQ (result.labels.header.frame_id, "camera");
  EXPECT_EQ (result.labels.sensor_orientation_.x(), 1.f);
  std::vector<std::size_t> counts (3, 0);
  for (const auto& label : result.labels)
    if (label.label != Segmentation::unlabelled)
      ++counts.at (label.label);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ (result.models[k].header.stamp, 77u);
    EXPECT_EQ (result.inliers[k].header.frame_id, "camera");
    EXPECT_EQ (result.inliers[k].indices, result.label_indices[k].indices);
    ASSERT_EQ (result.inliers[k].indices.size(), counts[k]);
    EXPECT_TRUE (std::is_sorted (result.inliers[k].indices.begin(),
                                 result.inliers[k].indices.end()));
    Eigen::Vector4f centroid;
    Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();
    pcl::computeMeanAndCovarianceMatrix (
        *scene.cloud, result.inliers[k].indices, covariance, centroid);
    EXPECT_TRUE (result.centroids[k].isApprox (centroid, 1e-3f));
    EXPECT_TRUE (result.covariances[k].isApprox (covariance, 1e-2f));
    EXPECT_NEAR (result.normal (k).norm(), 1.f, 1e-5f);
    // The normal faces the camera; OrganizedMultiPlaneSegmentation turns most away.
    EXPECT_GT (result.models[k].values[3], 0.f);
    EXPECT_LT (result.normal (k).dot (result.centroids[k].head<3>()), 0.f);
  }
  EXPECT_GE (counts[0], counts[1]);
  EXPECT_GE (counts[1], counts[2]);
}

TEST (NormalSpacePlaneInterface, OutputsOfTheFrameBeforeAreReplaced)
{
  const Scene large = render (corner(), 320, 240);
  const std::vector<Surface> wall{tiltedPlane (1.f, 0.f, 0.f)};
  const Scene small = render (wall, 160, 120);
  Segmentation segmentation;
  segmentation.setMinInliers (200);
  Result result;
  segment (segmentation, large.cloud, result);
  segment (segmentation, small.cloud, result);
  ASSERT_EQ (result.labels.size(), small.cloud->size());
  expectPlanes (small, wall, result, 0.05f, 0.0005f, 0.01);

  std::vector<pcl::ModelCoefficients> models (7);
  std::vector<pcl::PointIndices> inliers (7);
  segmentation.segment (models, inliers);
  EXPECT_EQ (models.size(), 1u);
  EXPECT_EQ (inliers.at (0).indices, result.inliers[0].indices);

  pcl::PointCloud<pcl::Label> labels (320, 240);
  segmentation.segment (models, inliers, labels);
  EXPECT_EQ (models.size(), 1u);
  EXPECT_EQ (inliers.at (0).indices, result.inliers[0].indices);
  ASSERT_EQ (labels.width, 160u);
  ASSERT_EQ (labels.height, 120u);
  for (std::size_t i = 0; i < labels.size(); ++i)
    ASSERT_EQ (labels[i].label, result.labels[i].label) << i;
}

TEST (NormalSpacePlaneInterface, IndicesLimitTheSearch)
{
  const Scene scene = render (corner(), 320, 240);
  Segmentation segmentation;
  segmentation.setMinInliers (250);
  auto indices = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < scene.surface.size(); ++i)
    if (scene.surface[i] == 1)
      indices->push_back (static_cast<pcl::index_t> (i));
  segmentation.setIndices (indices);
  Result result;
  segment (segmentation, scene.cloud, result);
  ASSERT_EQ (result.models.size(), 1u);
  EXPECT_LE (angleDegrees (result.normal (0), corner()[1].normal), 0.05f);
  for (std::size_t i = 0; i < scene.surface.size(); ++i)
    if (scene.surface[i] != 1) {
      ASSERT_EQ (result.labels[i].label, Segmentation::unlabelled);
    }

  segmentation.setIndices (pcl::IndicesPtr()); // the whole cloud again
  segment (segmentation, scene.cloud, result);
  EXPECT_EQ (result.models.size(), corner().size());
}

TEST (NormalSpacePlaneInterface, WithIndicesAllIsAsIfOtherPointsWereMissing)
{
  const Scene scene = render (corner(), 320, 240, kinectSigma);
  auto indices = pcl::make_shared<pcl::Indices>();
  auto all = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> (*scene.cloud);
  auto rest = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> (*scene.cloud);
  std::mt19937 random (1);
  std::normal_distribution<float> much_noise (1.f, 0.1f);
  for (std::size_t i = 0; i < rest->size(); ++i)
    if (i % 7 < 3 && i % 320 < 200)
      indices->push_back (static_cast<pcl::index_t> (i));
    else {
      (*all)[i].getVector3fMap() *= much_noise (random);
      (*rest)[i].x = std::nanf ("");
    }
  Result with_indices, without;
  for (Result* result : {&with_indices, &without}) {
    Segmentation segmentation;
    segmentation.setMinInliers (250);
    segmentation.setInputCloud (result == &without ? rest : all);
    segmentation.setInputNormals (estimateNormals (scene.cloud));
    if (result == &with_indices)
      segmentation.setIndices (indices);
    segment (segmentation, *result);
  }
  ASSERT_EQ (without.models.size(), 3u);
  expectSame (with_indices, without);
}

TEST (NormalSpacePlaneInterface, PlanesHaveAsManyPointsAsAskedFor)
{
  const Scene scene = render ({tiltedPlane (1.f, 0.f, 0.f)}, 160, 120);
  for (const unsigned more : {0u, 1u}) {
    Segmentation segmentation;
    segmentation.setMinInliers (160 * 120 + more);
    Result result;
    segment (segmentation, scene.cloud, result);
    EXPECT_EQ (result.models.size(), 1 - more);
  }
}

TEST (NormalSpacePlaneInterface, StageTimesAreThoseOfTheLastCall)
{
  const Scene scene = render (corner(), 320, 240, kinectSigma);
  Segmentation segmentation;
  Result result;
  std::chrono::duration<double> elapsed{};
  for (int frame = 0; frame < 5; ++frame) {
    const auto start = std::chrono::steady_clock::now();
    segment (segmentation, scene.cloud, result);
    elapsed = std::chrono::steady_clock::now() - start;
  }
  const auto& times = segmentation.getStageTimes();
  for (const double time : {times.normal_space, times.distance_space, times.refinement})
    EXPECT_GT (time, 0.);
  EXPECT_LT (times.normal_space + times.distance_space + times.refinement,
             elapsed.count());
}

TEST (NormalSpacePlaneInterface, BadInputGivesAnErrorAndEmptyOutputs)
{
  const Scene scene = render (corner(), 64, 48);
  const auto isRefused = [&] (Segmentation& segmentation) {
    Result result;
    result.models.resize (2);
    result.inliers.resize (2);
    result.centroids.resize (2);
    result.labels.resize (4u, 4u);
    segment (segmentation, result);
    return result.models.empty() && result.inliers.empty() &&
           result.centroids.empty() && result.labels.empty();
  };
  const Normals::Ptr normals = estimateNormals (scene.cloud);
  Segmentation segmentation;
  segmentation.setInputNormals (normals);
  EXPECT_TRUE (isRefused (segmentation)) << "no cloud";
  auto row = pcl::make_shared<Cloud> (*scene.cloud);
  row->width = 64 * 48;
  row->height = 1;
  segmentation.setInputCloud (row);
  EXPECT_TRUE (isRefused (segmentation)) << "unorganized";
  segmentation.setInputCloud (scene.cloud);
  segmentation.setInputNormals (nullptr);
  EXPECT_TRUE (isRefused (segmentation)) << "no normals";
  segmentation.setInputNormals (pcl::make_shared<Normals> (64, 47));
  EXPECT_TRUE (isRefused (segmentation)) << "too few normals";
  auto other_shape = pcl::make_shared<Normals> (*normals);
  std::swap (other_shape->width, other_shape->height);
  segmentation.setInputNormals (other_shape);
  testing::internal::CaptureStderr();
  EXPECT_TRUE (isRefused (segmentation)) << "columns for rows";
  EXPECT_NE (testing::internal::GetCapturedStderr().find (
                 "has 64 x 48 points and 48 x 64 normals"),
             std::string::npos);
  other_shape->width = 64 * 48;
  other_shape->height = 1;
  EXPECT_FALSE (isRefused (segmentation)) << "a list in the order of the points";
  segmentation.setInputNormals (normals);
  segmentation.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{64 * 48}));
  EXPECT_TRUE (isRefused (segmentation)) << "index outside";
}

TEST (NormalSpacePlaneInterface, OddNumbersSpoilNothing)
{
  const Scene scene = render (corner(), 320, 240);
  auto normals = estimateNormals (scene.cloud);
  for (std::size_t i = 0; i < scene.cloud->size(); i += 50) {
    const float huge = i % 100 ? 3e38f : 1e-42f;
    (*scene.cloud)[i].getVector3fMap() = Eigen::Vector3f (huge, -huge, huge);
    (*normals)[i + 1].getNormalVector3fMap() = Eigen::Vector3f (huge, huge, -huge);
  }
  for (const double angle : {1e-6, 0.15}) {
    Segmentation segmentation;
    segmentation.setMinInliers (250);
    segmentation.setAngularThreshold (angle);
    segmentation.setInputCloud (scene.cloud);
    segmentation.setInputNormals (normals);
    Result result;
    segmentation.segment (result.models, result.inliers);
    ASSERT_EQ (result.models.size(), 3u);
    for (const auto& surface : corner()) {
      float nearest = 90.f;
      for (std::size_t k = 0; k < 3; ++k)
        nearest = std::min (nearest, angleDegrees (result.normal (k), surface.normal));
      EXPECT_LE (nearest, 0.05f);
    }
  }
}

TEST (NormalSpacePlaneInterface, BadSettingsAreRefused)
{
  Segmentation segmentation;
  const double angle = segmentation.getAngularThreshold();
  const double distance = 0.02;
  segmentation.setDistanceThreshold (distance);
  for (const double bad : {0., -1., 2., std::nan ("")})
    segmentation.setAngularThreshold (bad);
  for (const double bad : {0., -1., std::nan ("")})
    segmentation.setDistanceThreshold (bad);
  EXPECT_EQ (segmentation.getAngularThreshold(), angle);
  EXPECT_EQ (segmentation.getDistanceThreshold(), distance);
}
