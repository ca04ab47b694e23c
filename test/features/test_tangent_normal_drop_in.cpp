// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "normal_clouds.h"

#include <pcl/features/integral_image_normal.h>
#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/features/two_run_normal.h>
#include <pcl/search/organized.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace normal_clouds;

namespace {

struct Result {
  Normals::Ptr normals = pcl::make_shared<Normals>();
  std::vector<pcl::ModelCoefficients> planes;
};

/** A pipeline of PCL as its users write it, with all setters of the estimator; compiled
 * for PCL's class and for ours. */
template <typename NormalEstimation>
Result
runPipeline (const Cloud::ConstPtr& cloud)
{
  Result result;
  typename NormalEstimation::Ptr ne (new NormalEstimation);
  ne->setNormalEstimationMethod (ne->AVERAGE_3D_GRADIENT);
  ne->setRectSize (10, 10);
  ne->setNormalSmoothingSize (10.0f);
  ne->setMaxDepthChangeFactor (0.02f);
  ne->setDepthDependentSmoothing (true);
  ne->setBorderPolicy (NormalEstimation::BORDER_POLICY_MIRROR);
  ne->setViewPoint (0.0f, 0.0f, 0.0f);
  ne->useSensorOriginAsViewPoint();
  float x, y, z;
  ne->getViewPoint (x, y, z);
  EXPECT_EQ (Eigen::Vector3f (x, y, z), Eigen::Vector3f::Zero());
  ne->setInputCloud (cloud);
  typename pcl::Feature<pcl::PointXYZ, pcl::Normal>::Ptr feature = ne;
  typename NormalEstimation::PointCloudOut& normals = *result.normals;
  feature->compute (normals);

  pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label> mps;
  std::vector<pcl::PointIndices> inliers;
  mps.setMinInliers (500);
  mps.setAngularThreshold (0.05);
  mps.setDistanceThreshold (0.02);
  mps.setInputNormals (result.normals);
  mps.setInputCloud (cloud);
  mps.segment (result.planes, inliers);
  return result;
}

using Theirs = pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal>;
using Ours = pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal>;

/** A corner of a room with a board in front of it, and noise. */
const std::vector<synthetic::Surface>&
surfaces ()
{
  static const std::vector<synthetic::Surface> room{
      synthetic::tiltedPlane (2.5f, 0.f, 40.f),
      synthetic::tiltedPlane (2.5f, 0.f, -50.f),
      {{0.f, -1.f, 0.f}, 0.8f},
      {{0.f, 0.f, -1.f}, 1.2f, [] (int u, int v) {
         return u > 220 && u < 380 && v > 150 && v < 260;
       }}};
  return room;
}

/** The mean angle to the true normals, in degrees, and the number of valid normals. */
std::pair<double, std::size_t>
compareWithTruth (const synthetic::Scene& scene, const Normals& normals)
{
  double sum = 0.;
  std::size_t valid = 0;
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (scene.surface[i] >= 0 && pcl::isNormalFinite (normals[i])) {
      const auto& truth = surfaces()[static_cast<std::size_t> (scene.surface[i])];
      sum += synthetic::angleDegrees (normals[i].getNormalVector3fMap(), truth.normal);
      ++valid;
    }
  return {sum / static_cast<double> (valid), valid};
}

/** How many of the surfaces are among the planes: within 2 degrees and 2 cm. */
std::size_t
surfacesFound (const std::vector<pcl::ModelCoefficients>& planes)
{
  const auto found = [&] (const synthetic::Surface& surface) {
    return std::any_of (planes.begin(), planes.end(), [&] (const auto& plane) {
      Eigen::Vector4f p = Eigen::Vector4f::Map (plane.values.data());
      if (p.head<3>().dot (surface.normal) < 0.f)
        p = -p;
      return synthetic::angleDegrees (p.head<3>(), surface.normal) < 2.f &&
             std::abs (p[3] - surface.d) < 0.02f;
    });
  };
  return static_cast<std::size_t> (
      std::count_if (surfaces().begin(), surfaces().end(), found));
}

} // namespace

TEST (TangentNormalDropIn, SamePipelineWithTheTypeNameSwapped)
{
  const auto scene = synthetic::render (
      surfaces(), 640, 480, [] (float z) { return 0.0005f + 0.001f * z * z; });
  const auto measured = static_cast<std::size_t> (
      std::count_if (scene.surface.begin(), scene.surface.end(), [] (int surface) {
        return surface >= 0;
      }));
  const Result theirs = runPipeline<Theirs> (scene.cloud);
  const Result ours = runPipeline<Ours> (scene.cloud);
  ASSERT_EQ (theirs.normals->size(), scene.cloud->size());
  ASSERT_EQ (ours.normals->size(), scene.cloud->size());
  const auto their_normals = compareWithTruth (scene, *theirs.normals);
  const auto our_normals = compareWithTruth (scene, *ours.normals);
  RecordProperty ("pcl_mean_degrees", std::to_string (their_normals.first));
  RecordProperty ("our_mean_degrees", std::to_string (our_normals.first));
  EXPECT_LT (our_normals.first, their_normals.first);
  EXPECT_EQ (our_normals.second, measured);
  EXPECT_LT (their_normals.second, measured);
  EXPECT_EQ (surfacesFound (ours.planes), surfaces().size());
  EXPECT_GE (surfacesFound (ours.planes), surfacesFound (theirs.planes));
}

/** As users of NormalEstimationOMP write it, with the search and the helpers of its header. */
template <typename NormalEstimation>
Normals
estimateWithThreads (const Cloud::ConstPtr& cloud)
{
  NormalEstimation ne (2);
  ne.setNumberOfThreads (2);
  ne.setSearchMethod (
      pcl::make_shared<pcl::search::OrganizedNeighbor<pcl::PointXYZ>>());
  ne.setRadiusSearch (0.05);
  ne.setInputCloud (cloud);
  Normals normals;
  ne.compute (normals);
  float nx = 0.f, ny = 0.f, nz = 1.f;
  pcl::flipNormalTowardsViewpoint (cloud->front(), 0.f, 0.f, 0.f, nx, ny, nz);
  EXPECT_EQ (nz, -1.f);
  return normals;
}

TEST (TangentNormalDropIn, ThePipelineOfNormalEstimationOMPWithTheTypeNameSwapped)
{
  const auto scene = synthetic::render (
      surfaces(), 160, 120, [] (float z) { return 0.0005f + 0.001f * z * z; });
  using OMP = pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal>;
  const auto theirs = compareWithTruth (scene, estimateWithThreads<OMP> (scene.cloud));
  const auto ours = compareWithTruth (scene, estimateWithThreads<Ours> (scene.cloud));
  EXPECT_LT (ours.first, theirs.first);
  EXPECT_GE (ours.second, theirs.second);
}

template <typename PointInT, typename PointOutT>
void
expectBothLinked ()
{
  pcl::IntegralImageTangentNormalEstimation<PointInT, PointOutT> tangents;
  pcl::TwoRunNormalEstimation<PointInT, PointOutT> two_runs;
  pcl::PointCloud<PointOutT> normals (1, 1);
  tangents.compute (normals);
  EXPECT_TRUE (normals.empty());
  two_runs.compute (normals);
  float x, y, z;
  tangents.getViewPoint (x, y, z);
  EXPECT_EQ (Eigen::Vector3f (x, y, z), Eigen::Vector3f::Zero());
}

template <typename... PointsInT>
void
expectLinked ()
{
  (expectBothLinked<PointsInT, pcl::Normal>(), ...);
  (expectBothLinked<PointsInT, pcl::PointNormal>(), ...);
  (expectBothLinked<PointsInT, pcl::PointXYZRGBNormal>(), ...);
  (expectBothLinked<PointsInT, pcl::PointXYZINormal>(), ...);
  (expectBothLinked<PointsInT, pcl::PointSurfel>(), ...);
}

/** The library has the estimators for all of PCL's types, as PCL itself would. */
TEST (TangentNormalDropIn, LinksWithThePointTypesOfPcl)
{
  ::testing::internal::CaptureStderr(); // there are no clouds
  expectLinked<pcl::PointXYZ,
               pcl::PointXYZI,
               pcl::PointXYZL,
               pcl::PointXYZRGB,
               pcl::PointXYZRGBA,
               pcl::PointWithViewpoint,
               pcl::PointNormal,
               pcl::PointXYZRGBNormal>();
  ::testing::internal::GetCapturedStderr();
}

/** All of its enumerators, with their values. */
TEST (TangentNormalDropIn, EnumeratorsAreThoseOfPcl)
{
  EXPECT_EQ (int{Ours::COVARIANCE_MATRIX}, int{Theirs::COVARIANCE_MATRIX});
  EXPECT_EQ (int{Ours::AVERAGE_3D_GRADIENT}, int{Theirs::AVERAGE_3D_GRADIENT});
  EXPECT_EQ (int{Ours::AVERAGE_DEPTH_CHANGE}, int{Theirs::AVERAGE_DEPTH_CHANGE});
  EXPECT_EQ (int{Ours::SIMPLE_3D_GRADIENT}, int{Theirs::SIMPLE_3D_GRADIENT});
  EXPECT_EQ (int{Ours::BORDER_POLICY_IGNORE}, int{Theirs::BORDER_POLICY_IGNORE});
  EXPECT_EQ (int{Ours::BORDER_POLICY_MIRROR}, int{Theirs::BORDER_POLICY_MIRROR});
}
