// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "refined_planes.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace plane_clouds;
using namespace refined_planes;

TEST (PlaneRegions, AreTheSameFromEveryOverload)
{
  const Scene scene = render (corner(), 320, 240, kinectSigma);
  scene.cloud->header.frame_id = "camera";
  Ours segmentation;
  segmentation.setMinInliers (250);
  Result result;
  segment (segmentation, scene.cloud, result);
  Refined refined;
  refined.regions.resize (7);
  refined.boundaries.resize (7);
  refined.label_indices.resize (7);
  refine (segmentation, refined);
  ASSERT_EQ (result.models.size(), 3u);
  ASSERT_EQ (refined.models.size(), 3u);
  ASSERT_EQ (refined.regions.size(), 3u);
  ASSERT_EQ (refined.boundaries.size(), 3u);
  ASSERT_EQ (refined.label_indices.size(), 3u);
  ASSERT_TRUE (refined.labels);
  ASSERT_EQ (refined.labels->size(), scene.cloud->size());
  EXPECT_EQ (refined.labels->header.frame_id, "camera");
  for (std::size_t i = 0; i < scene.cloud->size(); ++i)
    ASSERT_EQ ((*refined.labels)[i].label, result.labels[i].label);

  Ours::Regions segmented, again;
  segmentation.segment (segmented);
  segmentation.segmentAndRefine (again);
  ASSERT_EQ (segmented.size(), 3u);
  ASSERT_EQ (again.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ (refined.models[k].values, result.models[k].values);
    EXPECT_EQ (refined.inliers[k].indices, result.inliers[k].indices);
    EXPECT_EQ (refined.label_indices[k].indices, result.inliers[k].indices);
    EXPECT_EQ (refined.boundaries[k].header.frame_id, "camera");
    for (const auto* region : {&refined.regions[k], &segmented[k], &again[k]}) {
      EXPECT_EQ (region->getCount(), result.inliers[k].indices.size());
      EXPECT_EQ (region->getCentroid(), result.centroids[k].head<3>());
      EXPECT_EQ (region->getCovariance(), result.covariances[k]);
      EXPECT_EQ (region->getCoefficients(),
                 Eigen::Vector4f (result.models[k].values.data()));
      EXPECT_EQ (region->getContour().size(), refined.boundaries[k].indices.size());
    }
  }
}

TEST (PlaneRegions, CurvatureIsThatOfTheirCovariance)
{
  const Scene scene = render (corner(), 320, 240, kinectSigma);
  Ours segmentation;
  segmentation.setMinInliers (250);
  segmentation.setInputCloud (scene.cloud);
  segmentation.setInputNormals (estimateNormals (scene.cloud));
  Ours::Regions regions (3);
  for (auto& region : regions)
    region.setCurvature (-7.f); // in the memory that is used again
  segmentation.segment (regions);
  ASSERT_EQ (regions.size(), 3u);
  for (const auto& region : regions) {
    const Eigen::Matrix3d covariance = region.getCovariance().cast<double>();
    const Eigen::Vector3d values = covariance.eigenvalues().real();
    const double expected = values.minCoeff() / covariance.trace();
    EXPECT_GT (expected, 1e-6) << "there is noise";
    EXPECT_NEAR (region.getCurvature(), expected, 1e-3 * expected);
  }
}

TEST (PlaneRegions, RefiningGivesWhatWasFound)
{
  const Scene scene = render (corner(), 320, 240, kinectSigma);
  Ours segmentation;
  segmentation.setMinInliers (250);
  Result found, refined;
  segment (segmentation, scene.cloud, found);
  Ours::PointCloudLPtr labels;
  refined.models.resize (1);
  segmentation.refine (refined.models, refined.inliers, labels, refined.label_indices);
  ASSERT_TRUE (labels);
  refined.labels = *labels;
  refined.centroids = found.centroids;
  refined.covariances = found.covariances;
  expectSame (found, refined);
}

/** It replaced the planes that a caller had by none, without a word. */
TEST (PlaneRegions, RefiningWhatIsNotSegmentedIsAnErrorAndChangesNothing)
{
  const Scene scene = render (corner(), 320, 240, kinectSigma);
  std::vector<pcl::ModelCoefficients> models (2);
  std::vector<pcl::PointIndices> inliers (2), label_indices (3);
  auto labels = pcl::make_shared<pcl::PointCloud<pcl::Label>> (4, 5);
  Ours segmentation;
  const auto errorOfRefining = [&] {
    testing::internal::CaptureStderr();
    segmentation.refine (models, inliers, labels, label_indices);
    return testing::internal::GetCapturedStderr();
  };
  const auto expectRefused = [&] {
    const std::string error = errorOfRefining();
    EXPECT_EQ (std::count (error.begin(), error.end(), '\n'), 1);
    EXPECT_NE (error.find ("call segment () first"), std::string::npos) << error;
    EXPECT_EQ (models.size(), 2u);
    EXPECT_EQ (inliers.size(), 2u);
    EXPECT_EQ (label_indices.size(), 3u);
    EXPECT_EQ (labels->size(), 20u);
  };
  expectRefused();
  segmentation.setInputCloud (scene.cloud);
  segmentation.setInputNormals (estimateNormals (scene.cloud));
  expectRefused();
  std::vector<pcl::ModelCoefficients> found;
  std::vector<pcl::PointIndices> points;
  segmentation.segment (found, points);
  segmentation.setInputCloud (pcl::make_shared<Cloud> (*scene.cloud));
  expectRefused();

  segmentation.segment (found, points);
  segmentation.setInputCloud (segmentation.getInputCloud());
  EXPECT_EQ (errorOfRefining(), "") << "the same cloud";
  EXPECT_EQ (models.size(), found.size());
  segmentation.setInputNormals (nullptr);
  segmentation.segment (found, points);
  EXPECT_EQ (errorOfRefining(), "") << "segment() has told";
  EXPECT_TRUE (models.empty());
}

/** It gave the planes of the frame before, with points beyond the end of the cloud. */
TEST (PlaneRegions, RefiningACloudThatIsFilledAnewIsAnError)
{
  for (const bool is_smaller : {false, true}) {
    const Scene scene = render (corner(), 320, 240, kinectSigma);
    Ours segmentation;
    Result found;
    segment (segmentation, scene.cloud, found);
    if (is_smaller)
      *scene.cloud = *render (corner(), 160, 120).cloud;
    else
      ++scene.cloud->header.stamp;
    segmentation.setInputCloud (scene.cloud);
    auto labels = pcl::make_shared<pcl::PointCloud<pcl::Label>>();
    testing::internal::CaptureStderr();
    segmentation.refine (found.models, found.inliers, labels, found.label_indices);
    EXPECT_NE (testing::internal::GetCapturedStderr().find ("call segment () first"),
               std::string::npos);
    EXPECT_TRUE (labels->empty());
  }
}

TEST (PlaneRegions, BadInputGivesNone)
{
  const Scene scene = render (corner(), 320, 240);
  Ours segmentation;
  segmentation.setMinInliers (250);
  Result result;
  segment (segmentation, scene.cloud, result);
  ASSERT_EQ (result.models.size(), 3u);
  segmentation.setInputNormals (nullptr);
  Refined refined;
  refined.regions.resize (2);
  refined.boundaries.resize (2);
  refine (segmentation, refined);
  EXPECT_TRUE (refined.regions.empty());
  EXPECT_TRUE (refined.models.empty());
  EXPECT_TRUE (refined.inliers.empty());
  EXPECT_TRUE (refined.label_indices.empty());
  EXPECT_TRUE (refined.boundaries.empty());
  ASSERT_TRUE (refined.labels);
  EXPECT_TRUE (refined.labels->empty());
  EXPECT_TRUE (segmentation.getRms().empty());
  EXPECT_TRUE (segmentation.getParameterCovariances().empty());
  std::vector<pcl::PointIndices> segments (1);
  std::vector<std::size_t> planes (1);
  segmentation.getSegments (segments, planes);
  EXPECT_TRUE (segments.empty());
  EXPECT_TRUE (planes.empty());
}

namespace {

/** From the points themselves. */
double
rmsOf (const pcl::ModelCoefficients& model,
       const pcl::PointIndices& inliers,
       const Cloud& cloud)
{
  const Eigen::Vector4d plane = Eigen::Vector4f (model.values.data()).cast<double>();
  double sum = 0.;
  for (const pcl::index_t i : inliers.indices) {
    const Eigen::Vector3d p = cloud[i].getVector3fMap().cast<double>();
    sum += std::pow (plane.head<3>().dot (p) + plane[3], 2);
  }
  return std::sqrt (sum / static_cast<double> (inliers.indices.size()));
}

} // namespace

TEST (PlaneRms, IsThatOfTheDistancesOfThePoints)
{
  for (const float noise : {0.f, 1.f}) {
    const Scene scene = render (
        corner(), 320, 240, [noise] (float z) { return noise * kinectSigma (z); });
    Ours segmentation;
    segmentation.setMinInliers (250);
    Result result;
    segment (segmentation, scene.cloud, result);
    ASSERT_EQ (segmentation.getRms().size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) {
      const double rms = rmsOf (result.models[k], result.inliers[k], *scene.cloud);
      // Sums are in single precision, tile by tile.
      EXPECT_NEAR (segmentation.getRms()[k], rms, 1e-5 + 1e-4 * rms);
    }
  }
}

TEST (PlaneRms, DoesNotDependOnWhatIsFarBehind)
{
  // So narrow that hardly any tile is without its surroundings.
  Surface board = tiltedPlane (1.f, 15.f, 20.f);
  board.covers = [] (int u, int v) { return u > 307 && u < 332 && v > 199 && v < 280; };
  const Scene scene = render ({board}, 640, 480, kinectSigma);
  for (int v = 0; v < 480; ++v)
    for (int u = 0; u < 640; ++u)
      if (!board.covers (u, v))
        (*scene.cloud) (u, v) = {30.f * (static_cast<float> (u) - 319.5f) / 525.f,
                                 30.f * (static_cast<float> (v) - 239.5f) / 525.f,
                                 30.f};
  Ours segmentation;
  Result result;
  segment (segmentation, scene.cloud, result);
  const auto at_board = std::find_if (
      result.models.begin(), result.models.end(), [&board] (const auto& model) {
        return std::fabs (model.values[3] - board.d) < 0.05f;
      });
  ASSERT_NE (at_board, result.models.end());
  const auto k = static_cast<std::size_t> (at_board - result.models.begin());
  const double rms = rmsOf (*at_board, result.inliers[k], *scene.cloud);
  EXPECT_NEAR (segmentation.getRms()[k], rms, 1e-5 + 1e-3 * rms);
}
