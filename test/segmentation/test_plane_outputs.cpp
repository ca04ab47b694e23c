// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace plane_clouds;

namespace {

/** What segmentAndRefine gives. */
struct Refined {
  Ours::Regions regions;
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers, label_indices, boundaries;
  Ours::PointCloudLPtr labels;
};

void
refine (Ours& segmentation, Refined& refined)
{
  segmentation.segmentAndRefine (refined.regions,
                                 refined.models,
                                 refined.inliers,
                                 refined.labels,
                                 refined.label_indices,
                                 refined.boundaries);
}

/** Planes of \a surfaces, with true normals. */
Refined
refine (const Scene& scene,
        const std::vector<Surface>& surfaces,
        Ours segmentation = {})
{
  segmentation.setInputCloud (scene.cloud);
  segmentation.setInputNormals (trueNormals (scene, surfaces));
  Refined refined;
  refine (segmentation, refined);
  return refined;
}

/** The border of columns u0 ... u1 - 1, rows v0 ... v1 - 1 of an image, clockwise from
 * its upper left corner. */
pcl::Indices
border (int width, int u0, int u1, int v0, int v1)
{
  pcl::Indices pixels;
  for (int u = u0; u < u1; ++u)
    pixels.push_back (v0 * width + u);
  for (int v = v0 + 1; v < v1; ++v)
    pixels.push_back (v * width + u1 - 1);
  for (int u = u1 - 2; u >= u0; --u)
    pixels.push_back ((v1 - 1) * width + u);
  for (int v = v1 - 2; v > v0; --v)
    pixels.push_back (v * width + u0);
  return pixels;
}

/** The connected parts of the labels of planes, by first pixels. */
std::vector<pcl::Indices>
floodFill (const pcl::PointCloud<pcl::Label>& labels)
{
  const int width = static_cast<int> (labels.width);
  std::vector<bool> seen (labels.size(), false);
  std::vector<pcl::Indices> parts;
  for (std::size_t start = 0; start < labels.size(); ++start) {
    if (seen[start] || labels[start].label == Ours::unlabelled)
      continue;
    pcl::Indices part{static_cast<pcl::index_t> (start)};
    seen[start] = true;
    for (std::size_t i = 0; i < part.size(); ++i)
      for (int dv = -1; dv <= 1; ++dv)
        for (int du = -1; du <= 1; ++du) {
          const int u = part[i] % width + du, v = part[i] / width + dv;
          if (u < 0 || u >= width || v < 0 || v >= static_cast<int> (labels.height))
            continue;
          const auto pixel = static_cast<std::size_t> (v * width + u);
          if (!seen[pixel] && labels[pixel].label == labels[start].label) {
            seen[pixel] = true;
            part.push_back (static_cast<pcl::index_t> (pixel));
          }
        }
    std::sort (part.begin(), part.end());
    parts.push_back (part);
  }
  return parts;
}

} // namespace

TEST (PlaneContours, OfARectangleIsItsBorderAndOfAWallTheEdgeOfTheImage)
{
  const std::vector<Surface> surfaces{tiltedPlane (2.f, 10.f, 20.f),
                                      board (100, 300, 80, 200)};
  const Scene scene = render (surfaces);
  const Refined refined = refine (scene, surfaces);
  ASSERT_EQ (refined.boundaries.size(), 2u);
  EXPECT_EQ (refined.boundaries[0].indices, border (640, 0, 640, 0, 480));
  EXPECT_EQ (refined.boundaries[1].indices, border (640, 100, 300, 80, 200));
  ASSERT_EQ (refined.regions.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& contour = refined.regions[k].getContour();
    ASSERT_EQ (contour.size(), refined.boundaries[k].indices.size());
    for (std::size_t i = 0; i < contour.size(); ++i)
      ASSERT_EQ (contour[i].getVector3fMap(),
                 (*scene.cloud)[refined.boundaries[k].indices[i]].getVector3fMap());
  }
}

TEST (PlaneContours, ReachEveryEdgeOfTheImage)
{
  const Surface wall = tiltedPlane (2.f, 0.f, 20.f);
  for (const auto& [u0, u1, v0, v1] :
       std::vector<std::array<int, 4>>{{0, 90, 0, 70},
                                       {250, 320, 0, 70},
                                       {0, 90, 170, 240},
                                       {250, 320, 170, 240},
                                       {0, 320, 100, 140},
                                       {90, 130, 0, 240}}) {
    const std::vector<Surface> surfaces{wall, board (u0, u1, v0, v1)};
    const Refined refined = refine (render (surfaces, 320, 240), surfaces);
    ASSERT_EQ (refined.boundaries.size(), 2u);
    EXPECT_EQ (refined.boundaries[1].indices, border (320, u0, u1, v0, v1));
  }
}

TEST (PlaneContours, BelongToTheLargestPart)
{
  const std::vector<Surface> surfaces{tiltedPlane (2.f, 0.f, 20.f),
                                      board (100, 120, 0, 240)};
  const Refined refined = refine (render (surfaces, 320, 240), surfaces);
  ASSERT_EQ (refined.boundaries.size(), 2u);
  EXPECT_EQ (refined.boundaries[0].indices, border (320, 120, 320, 0, 240));
  EXPECT_EQ (refined.regions[0].getCount(), 300u * 240u) << "of all parts";
}

TEST (PlaneContours, AreProjectedOnRequest)
{
  const Scene scene = render (corner(), 320, 240, kinectSigma);
  Ours segmentation;
  segmentation.setMinInliers (250);
  EXPECT_FALSE (segmentation.getProjectPoints());
  const Refined measured = refine (scene, corner(), segmentation);
  segmentation.setProjectPoints (true);
  EXPECT_TRUE (segmentation.getProjectPoints());
  const Refined projected = refine (scene, corner(), segmentation);
  ASSERT_EQ (projected.regions.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector4f plane = projected.regions[k].getCoefficients();
    float furthest = 0.f;
    ASSERT_EQ (projected.boundaries[k].indices, measured.boundaries[k].indices);
    for (std::size_t i = 0; i < projected.boundaries[k].indices.size(); ++i) {
      const Eigen::Vector3f p = measured.regions[k].getContour()[i].getVector3fMap();
      const Eigen::Vector3f q = projected.regions[k].getContour()[i].getVector3fMap();
      EXPECT_NEAR (plane.head<3>().dot (q) + plane[3], 0.f, 2e-6f);
      EXPECT_NEAR ((q - p).cross (plane.head<3>()).norm(), 0.f, 2e-6f);
      furthest = std::max (furthest, (q - p).norm());
    }
    EXPECT_GT (furthest, 0.003f);
  }
}

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

TEST (PlaneSegments, AreTheConnectedPartsOfThePlanes)
{
  std::vector<Surface> surfaces = corner();
  surfaces.push_back (board (100, 104, 0, 240));
  surfaces.push_back (board (30, 34, 0, 240));
  const Scene scene = render (surfaces, 320, 240, kinectSigma);
  Ours segmentation;
  std::vector<pcl::PointIndices> segments;
  std::vector<std::size_t> planes;
  segmentation.getSegments (segments, planes);
  EXPECT_TRUE (segments.empty()) << "nothing was segmented";
  for (const unsigned min_inliers : {5000u, 1000u, 250u, 1u}) {
    segmentation.setMinInliers (min_inliers);
    Result result;
    segment (segmentation, scene.cloud, result);
    segmentation.getSegments (segments, planes);
    auto expected = floodFill (result.labels);
    expected.erase (std::remove_if (expected.begin(),
                                    expected.end(),
                                    [=] (const pcl::Indices& part) {
                                      return part.size() < min_inliers;
                                    }),
                    expected.end());
    ASSERT_EQ (segments.size(), expected.size());
    ASSERT_EQ (planes.size(), expected.size());
    EXPECT_GT (segments.size(), result.models.size() - (min_inliers == 5000u));
    for (std::size_t s = 0; s < segments.size(); ++s) {
      EXPECT_EQ (segments[s].indices, expected[s]);
      EXPECT_EQ (planes[s], result.labels[expected[s][0]].label);
    }
  }
}

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
      const Eigen::Vector4d plane =
          Eigen::Vector4f (result.models[k].values.data()).cast<double>();
      double sum = 0.;
      for (const pcl::index_t i : result.inliers[k].indices) {
        const Eigen::Vector3d p = (*scene.cloud)[i].getVector3fMap().cast<double>();
        sum += std::pow (plane.head<3>().dot (p) + plane[3], 2);
      }
      const double rms =
          std::sqrt (sum / static_cast<double> (result.inliers[k].indices.size()));
      // Sums are in single precision, tile by tile.
      EXPECT_NEAR (segmentation.getRms()[k], rms, 1e-5 + 1e-4 * rms);
    }
  }
}
