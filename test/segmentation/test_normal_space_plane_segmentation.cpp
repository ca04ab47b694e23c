// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "synthetic_clouds.h"

#include <pcl/common/centroid.h>
#include <pcl/common/io.h>
#include <pcl/common/point_tests.h>
#include <pcl/features/integral_image_normal.h>
#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>

#include <gtest/gtest.h>

#include <algorithm>

using synthetic::angleDegrees;
using synthetic::Cloud;
using synthetic::render;
using synthetic::Scene;
using synthetic::Surface;
using synthetic::tiltedPlane;
using Normals = pcl::PointCloud<pcl::Normal>;
using Segmentation = pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal>;

namespace {

struct Result {
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers, label_indices;
  Segmentation::Centroids centroids;
  Segmentation::Covariances covariances;
  pcl::PointCloud<pcl::Label> labels;

  Eigen::Vector3f
  normal (std::size_t k) const
  {
    return Eigen::Vector3f (models[k].values.data());
  }
};

Normals::Ptr
estimateNormals (const Cloud::ConstPtr& cloud)
{
  auto normals = pcl::make_shared<Normals>();
  pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud (cloud);
  estimation.compute (*normals);
  return normals;
}

/** Segments the input that \a segmentation was given. */
void
run (Segmentation& segmentation, Result& result)
{
  segmentation.segment (result.models,
                        result.inliers,
                        result.centroids,
                        result.covariances,
                        result.labels,
                        result.label_indices);
}

void
segment (Segmentation& segmentation, const Cloud::ConstPtr& cloud, Result& result)
{
  segmentation.setInputCloud (cloud);
  segmentation.setInputNormals (estimateNormals (cloud));
  run (segmentation, result);
}

Result
segment (const Cloud::ConstPtr& cloud, unsigned min_inliers = 1000)
{
  Segmentation segmentation;
  segmentation.setMinInliers (min_inliers);
  Result result;
  segment (segmentation, cloud, result);
  return result;
}

/** Every true plane is found once, and nothing else: normals within \a degrees,
 * distances within \a metres, and all but \a lost of the points of each surface with
 * its label. */
void
expectPlanes (const Scene& scene,
              const std::vector<Surface>& surfaces,
              const Result& result,
              float degrees,
              float metres,
              double lost)
{
  ASSERT_EQ (result.models.size(), surfaces.size());
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    std::size_t k = 0;
    while (k < result.models.size() &&
           (angleDegrees (result.normal (k), surfaces[s].normal) > degrees ||
            std::abs (result.models[k].values[3] - surfaces[s].d) > metres))
      ++k;
    ASSERT_LT (k, result.models.size()) << "surface " << s << " was not found";
    std::size_t points = 0, labelled = 0;
    for (std::size_t i = 0; i < scene.surface.size(); ++i)
      if (scene.surface[i] == static_cast<int> (s) &&
          pcl::isFinite ((*scene.cloud)[i])) {
        ++points;
        labelled += result.labels[i].label == k;
      }
    EXPECT_GE (static_cast<double> (labelled),
               (1. - lost) * static_cast<double> (points))
        << "surface " << s;
  }
}

float
kinectSigma (float z)
{
  return 0.001f + 0.002f * z * z;
}

const std::vector<Surface>&
roomCorner ()
{
  static const std::vector<Surface> corner{tiltedPlane (2.f, 0.f, 50.f),
                                           tiltedPlane (2.2f, 0.f, -40.f),
                                           {{0.f, -1.f, 0.f}, 0.7f}};
  return corner;
}

} // namespace

TEST (NormalSpacePlanes, FindsTheThreePlanesOfARoomCorner)
{
  const Scene ideal = render (roomCorner());
  expectPlanes (ideal, roomCorner(), segment (ideal.cloud), 0.05f, 0.0005f, 0.01);
  const Scene noisy = render (roomCorner(), 640, 480, kinectSigma);
  expectPlanes (noisy, roomCorner(), segment (noisy.cloud), 0.3f, 0.005f, 0.03);
}

TEST (NormalSpacePlanes, WorksAtEveryResolution)
{
  for (const int divisor : {2, 4}) {
    const Scene scene =
        render (roomCorner(), 640 / divisor, 480 / divisor, kinectSigma);
    const auto min_inliers = static_cast<unsigned> (1000 / (divisor * divisor));
    expectPlanes (
        scene, roomCorner(), segment (scene.cloud, min_inliers), 0.5f, 0.01f, 0.05);
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
  Scene scene = render (roomCorner());
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
  expectPlanes (scene, roomCorner(), result, 0.05f, 0.0005f, 0.01);
}

TEST (NormalSpacePlanes, OutputsAgreeWithEachOther)
{
  Scene scene = render (roomCorner(), 320, 240, kinectSigma);
  scene.cloud->header.frame_id = "camera";
  scene.cloud->header.stamp = 77;
  const Result result = segment (scene.cloud, 250);
  ASSERT_EQ (result.models.size(), 3u);
  ASSERT_EQ (result.labels.width, 320u);
  ASSERT_EQ (result.labels.height, 240u);
  EXPECT_EQ (result.labels.header.frame_id, "camera");
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

TEST (NormalSpacePlanes, OutputsOfTheFrameBeforeAreReplaced)
{
  const Scene corner = render (roomCorner(), 320, 240);
  const std::vector<Surface> wall{tiltedPlane (1.f, 0.f, 0.f)};
  const Scene small = render (wall, 160, 120);
  Segmentation segmentation;
  segmentation.setMinInliers (200);
  Result result;
  segment (segmentation, corner.cloud, result);
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

TEST (NormalSpacePlanes, IndicesLimitTheSearch)
{
  const Scene scene = render (roomCorner(), 320, 240);
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
  EXPECT_LE (angleDegrees (result.normal (0), roomCorner()[1].normal), 0.05f);
  for (std::size_t i = 0; i < scene.surface.size(); ++i)
    if (scene.surface[i] != 1) {
      ASSERT_EQ (result.labels[i].label, Segmentation::unlabelled);
    }

  segmentation.setIndices (pcl::IndicesPtr()); // the whole cloud again
  segment (segmentation, scene.cloud, result);
  EXPECT_EQ (result.models.size(), roomCorner().size());
}

TEST (NormalSpacePlanes, BadInputGivesAnErrorAndEmptyOutputs)
{
  const Scene scene = render (roomCorner(), 64, 48);
  const auto isRefused = [&] (Segmentation& segmentation) {
    Result result;
    result.models.resize (2);
    result.inliers.resize (2);
    result.centroids.resize (2);
    result.labels.resize (4u, 4u);
    run (segmentation, result);
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
  segmentation.setInputNormals (normals);
  segmentation.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{64 * 48}));
  EXPECT_TRUE (isRefused (segmentation)) << "index outside";
}

TEST (NormalSpacePlanes, NothingToFindIsNoError)
{
  auto empty = pcl::make_shared<Cloud> (64, 48, pcl::PointXYZ (0.f, 0.f, 0.f));
  EXPECT_TRUE (segment (empty).models.empty());
  const Scene scene = render (roomCorner(), 64, 48);
  const Result result = segment (scene.cloud, 64 * 48 + 1);
  EXPECT_TRUE (result.models.empty());
  for (const auto& label : result.labels)
    ASSERT_EQ (label.label, Segmentation::unlabelled);
}

TEST (NormalSpacePlanes, OddNumbersSpoilNothing)
{
  const Scene scene = render (roomCorner(), 320, 240);
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
    for (const auto& surface : roomCorner()) {
      float nearest = 90.f;
      for (std::size_t k = 0; k < 3; ++k)
        nearest = std::min (nearest, angleDegrees (result.normal (k), surface.normal));
      EXPECT_LE (nearest, 0.05f);
    }
  }
}

TEST (NormalSpacePlanes, TakesTheNormalsOfOtherClasses)
{
  const Scene scene = render (roomCorner());
  auto normals = pcl::make_shared<Normals>();
  pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod (estimation.AVERAGE_3D_GRADIENT);
  estimation.setInputCloud (scene.cloud);
  estimation.compute (*normals); // without curvature
  Segmentation segmentation;
  segmentation.setInputCloud (scene.cloud);
  segmentation.setInputNormals (normals);
  Result result;
  run (segmentation, result);
  expectPlanes (scene, roomCorner(), result, 0.1f, 0.001f, 0.02);
}

TEST (NormalSpacePlanes, BadSettingsAreRefused)
{
  Segmentation segmentation;
  const double angle = segmentation.getAngularThreshold();
  const double distance = segmentation.getDistanceThreshold();
  for (const double bad : {0., -1., 2., std::nan ("")})
    segmentation.setAngularThreshold (bad);
  for (const double bad : {0., -1., std::nan ("")})
    segmentation.setDistanceThreshold (bad);
  EXPECT_EQ (segmentation.getAngularThreshold(), angle);
  EXPECT_EQ (segmentation.getDistanceThreshold(), distance);
}

/** The largest plane of a table-top recording is the table of its hand-made labels. */
TEST (NormalSpacePlanes, FindsTheTableOfRecordings)
{
  SKIP_WITHOUT_RECORDINGS();
  for (const std::string name :
       {"learn0", "learn12", "learn20", "learn30", "learn40"}) {
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
    EXPECT_GE (both / either, 0.95) << name;
  }
}
