// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "normal_clouds.h"

#include <pcl/common/io.h>
#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/features/two_run_normal.h>
#include <pcl/search/kdtree.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <thread>

using synthetic::angleDegrees;
using synthetic::render;
using synthetic::tiltedPlane;
using namespace normal_clouds;

namespace {

struct Tangents {
  template <typename PointInT, typename PointOutT>
  using Estimation = pcl::IntegralImageTangentNormalEstimation<PointInT, PointOutT>;
};

struct TwoRuns {
  template <typename PointInT, typename PointOutT>
  using Estimation = pcl::TwoRunNormalEstimation<PointInT, PointOutT>;
};

/** What the two estimators have in common, each of which is tested. */
template <typename Method>
class NormalEstimation : public ::testing::Test {
protected:
  using Estimation = typename Method::template Estimation<pcl::PointXYZ, pcl::Normal>;
  using Feature = pcl::Feature<pcl::PointXYZ, pcl::Normal>;

  static Normals
  byDefault (const Cloud::ConstPtr& cloud)
  {
    return estimate<Estimation> (cloud);
  }

  /** Expects 0 x 0 and one line of error that contains \a cure. */
  template <typename PointInT, typename PointOutT>
  static void
  expectRefused (pcl::Feature<PointInT, PointOutT>& feature,
                 pcl::PointCloud<PointOutT>& output,
                 const std::string& cure)
  {
    ::testing::internal::CaptureStderr();
    feature.compute (output);
    const std::string error = ::testing::internal::GetCapturedStderr();
    EXPECT_TRUE (output.empty() && output.width == 0 && output.height == 0) << cure;
    EXPECT_EQ (std::count (error.begin(), error.end(), '\n'), 1) << error;
    EXPECT_NE (error.find (cure), std::string::npos) << error;
  }

  static void
  expectRefused (const Cloud::ConstPtr& cloud,
                 const pcl::IndicesPtr& indices,
                 const std::string& cure)
  {
    Estimation estimation;
    Feature* feature = &estimation;
    feature->setInputCloud (cloud);
    if (indices)
      feature->setIndices (indices);
    Normals normals (3, 2);
    expectRefused (*feature, normals, cure);
  }
};

using Methods = ::testing::Types<Tangents, TwoRuns>;
TYPED_TEST_SUITE (NormalEstimation, Methods);

} // namespace

TYPED_TEST (NormalEstimation, BadCloudsGiveOneErrorAndAnEmptyOutput)
{
  this->expectRefused (nullptr, nullptr, "call setInputCloud");
  this->expectRefused (pcl::make_shared<Cloud>(), nullptr, "The input");
  const auto torn = pcl::make_shared<Cloud> (10, 10);
  torn->points.resize (50);
  this->expectRefused (torn, nullptr, "The input");
  const Cloud::Ptr lost = render ({tiltedPlane (1.f, 0.f, 0.f)}, 8, 8).cloud;
  lost->sensor_origin_.y() = std::numeric_limits<float>::quiet_NaN();
  this->expectRefused (lost, nullptr, "set it to where the camera");
}

TYPED_TEST (NormalEstimation, IndexOutsideOfTheCloudGivesOneErrorAndAnEmptyOutput)
{
  const Cloud::Ptr cloud = render ({tiltedPlane (1.f, 0.f, 0.f)}, 8, 8).cloud;
  for (const int index : {-1, 64})
    this->expectRefused (cloud,
                         pcl::make_shared<pcl::Indices> (pcl::Indices{0, index}),
                         "give indices from 0 to less than 64");
}

TYPED_TEST (NormalEstimation, HeaderAndPoseOfTheSensorAreCopied)
{
  const Cloud::Ptr cloud = makeHoles();
  cloud->header.frame_id = "camera";
  cloud->header.stamp = 12345;
  cloud->header.seq = 7;
  cloud->sensor_origin_ = {0.1f, 0.2f, 0.3f, 0.f};
  cloud->sensor_orientation_ = Eigen::Quaternionf (0.6f, 0.f, 0.8f, 0.f);
  const Normals normals = this->byDefault (cloud);
  EXPECT_EQ (normals.header.frame_id, "camera");
  EXPECT_EQ (normals.header.stamp, 12345u);
  EXPECT_EQ (normals.header.seq, 7u);
  EXPECT_EQ (normals.sensor_origin_, cloud->sensor_origin_);
  EXPECT_EQ (normals.sensor_orientation_.coeffs(), cloud->sensor_orientation_.coeffs());
}

TYPED_TEST (NormalEstimation, IndicesGiveOneNormalEachInTheirOrder)
{
  const Cloud::Ptr cloud = makeHoles();
  const Normals all = this->byDefault (cloud);
  EXPECT_EQ (all.width, cloud->width);
  EXPECT_EQ (all.height, cloud->height);

  pcl::Indices reversed (all.size());
  for (std::size_t i = 0; i < reversed.size(); ++i)
    reversed[i] = static_cast<pcl::index_t> (all.size() - 1 - i);
  for (const pcl::Indices& indices :
       {pcl::Indices{8, 3, 3, 1199}, reversed, pcl::Indices{}}) {
    typename TestFixture::Estimation estimation;
    estimation.setIndices (pcl::make_shared<pcl::Indices> (indices));
    const Normals some = estimate (estimation, cloud);
    ASSERT_EQ (some.size(), indices.size());
    EXPECT_EQ (some.width, indices.size());
    EXPECT_EQ (some.height, 1u);
    for (std::size_t i = 0; i < indices.size(); ++i)
      ASSERT_TRUE (sameBits (some[i], all[indices[i]])) << i;
  }
}

TYPED_TEST (NormalEstimation, InputMayBeTheOutputButNotWithIndices)
{
  using Point = pcl::PointXYZRGBNormal;
  const Cloud::Ptr holes = makeHoles();
  const auto cloud = pcl::make_shared<pcl::PointCloud<Point>>();
  pcl::copyPointCloud (*holes, *cloud);
  (*cloud)[8].r = 77;
  typename TypeParam::template Estimation<Point, Point> estimation;
  estimation.setInputCloud (cloud);
  estimation.compute (*cloud);
  Normals normals;
  pcl::copyPointCloud (*cloud, normals);
  EXPECT_TRUE (sameBits (normals, this->byDefault (holes)));
  EXPECT_EQ (cloud->width, holes->width);
  EXPECT_EQ ((*cloud)[8].r, 77);

  for (const std::size_t number :
       {holes->size() / 3, holes->size(), holes->size() * 2}) {
    pcl::copyPointCloud (*holes, *cloud);
    estimation.setIndices (pcl::make_shared<pcl::Indices> (number, 8));
    this->expectRefused (estimation, *cloud, "into another cloud");
  }
}

TYPED_TEST (NormalEstimation, NullIndicesMeanTheWholeCloud)
{
  typename TestFixture::Estimation estimation;
  estimation.setIndices (pcl::IndicesPtr());
  const Normals normals =
      estimate (estimation, render ({tiltedPlane (1.f, 0.f, 0.f)}, 16, 12).cloud);
  EXPECT_EQ (normals.width, 16u);
  EXPECT_EQ (normals.height, 12u);
}

TYPED_TEST (NormalEstimation, NormalsAreOfUnitLengthOrMissing)
{
  const Cloud::Ptr cloud = makeHoles();
  const Normals normals = this->byDefault (cloud);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const auto& n = normals[i];
    if (isHole ((*cloud)[i]))
      ASSERT_TRUE (std::isnan (n.normal_x) && std::isnan (n.normal_y) &&
                   std::isnan (n.normal_z) && std::isnan (n.curvature))
          << i;
    else {
      ASSERT_NEAR (n.getNormalVector3fMap().norm(), 1.f, 1e-5f) << i;
      ASSERT_GE (n.curvature, 0.f) << i;
      ASSERT_LE (n.curvature, 1.f / 3.f) << i;
    }
  }
}

TYPED_TEST (NormalEstimation, IsDenseTellsWhetherAllNormalsAreValid)
{
  const Cloud::Ptr holes = makeHoles();
  const Cloud::Ptr whole = render (twoWalls(), 160, 120).cloud;
  for (const bool claim : {true, false}) {
    holes->is_dense = whole->is_dense = claim;
    typename TestFixture::Estimation estimation;
    EXPECT_FALSE (estimate (estimation, holes).is_dense);
    EXPECT_TRUE (estimate (estimation, whole).is_dense);
    // Points 7 and 3 are holes, 8 is none.
    estimation.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{8, 7}));
    EXPECT_FALSE (estimate (estimation, holes).is_dense);
    estimation.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{8, 8}));
    EXPECT_TRUE (estimate (estimation, holes).is_dense);
  }
}

TYPED_TEST (NormalEstimation, NormalsFaceTheViewpoint)
{
  const Cloud::Ptr cloud = render ({tiltedPlane (1.f, 0.f, 0.f)}, 160, 120).cloud;
  typename TestFixture::Estimation estimation;
  const auto expectViewpoint = [&estimation] (float x, float y, float z) {
    Eigen::Vector3f used;
    estimation.getViewPoint (used.x(), used.y(), used.z());
    EXPECT_EQ (used, Eigen::Vector3f (x, y, z));
  };
  const auto expectNormal = [&] (float z) {
    for (const auto& normal : estimate (estimation, cloud))
      ASSERT_NEAR (normal.normal_z, z, 1e-3f);
  };
  expectViewpoint (0.f, 0.f, 0.f);
  expectNormal (-1.f);
  cloud->sensor_origin_ = {0.5f, 0.f, 3.f, 0.f};
  expectViewpoint (0.5f, 0.f, 3.f);
  expectNormal (1.f);
  estimation.setViewPoint (0.f, 0.f, 0.2f);
  expectViewpoint (0.f, 0.f, 0.2f);
  expectNormal (-1.f);
  estimation.setViewPoint (0.f, std::numeric_limits<float>::quiet_NaN(), 0.f);
  estimation.setViewPoint (0.f, 0.f, std::numeric_limits<float>::infinity());
  expectViewpoint (0.f, 0.f, 0.2f);
  estimation.useSensorOriginAsViewPoint();
  expectViewpoint (0.5f, 0.f, 3.f);
  expectNormal (1.f);
}

TYPED_TEST (NormalEstimation, TheViewpointOnlyTurnsNormals)
{
  const Cloud::Ptr cloud = render (twoWalls(), 160, 120).cloud;
  const Normals by_default = this->byDefault (cloud);
  constexpr float far = std::numeric_limits<float>::max();
  for (const Eigen::Vector3f& viewpoint : {Eigen::Vector3f (0.f, -100.f, 0.f),
                                           Eigen::Vector3f (1.f, 0.f, 1.f),
                                           Eigen::Vector3f (0.f, 0.f, far)}) {
    typename TestFixture::Estimation estimation;
    estimation.setViewPoint (viewpoint.x(), viewpoint.y(), viewpoint.z());
    const Normals normals = estimate (estimation, cloud);
    ASSERT_EQ (normals.size(), by_default.size());
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const Eigen::Vector3f n = by_default[i].getNormalVector3fMap();
      const float towards = n.dot (viewpoint - (*cloud)[i].getVector3fMap());
      const Eigen::Vector3f expected = towards < 0.f ? Eigen::Vector3f (-n) : n;
      ASSERT_EQ (normals[i].getNormalVector3fMap(), expected) << i;
    }
  }
}

TYPED_TEST (NormalEstimation, ObjectsAreReusableForOtherSizes)
{
  typename TestFixture::Estimation used;
  for (const int width : {64, 2, 160, 33}) {
    const Cloud::Ptr cloud =
        render ({tiltedPlane (0.1f, 0.f, 20.f)}, width, width * 3 / 4 + 1).cloud;
    const Normals normals = estimate (used, cloud);
    EXPECT_EQ (normals.width, cloud->width);
    EXPECT_TRUE (sameBits (normals, this->byDefault (cloud))) << width;
  }
}

TYPED_TEST (NormalEstimation, CopiesOutliveTheOriginalAndWorkAtTheSameTime)
{
  const Cloud::Ptr large = render (twoWalls(), 160, 120).cloud;
  const Cloud::Ptr small = render ({tiltedPlane (2.f, 0.f, 30.f)}, 33, 17).cloud;
  auto original = std::make_unique<typename TestFixture::Estimation>();
  original->setViewPoint (0.f, 0.1f, 0.f);
  const Normals expected_large = estimate (*original, large);
  const Normals expected_small = estimate (*original, small);

  typename TestFixture::Estimation copy (*original), assigned;
  estimate (assigned, large);
  assigned = *original;
  // All three have the indices that PCL makes up for a whole cloud.
  estimate (copy, large);
  estimate (assigned, small);
  EXPECT_EQ (copy.getIndices()->size(), large->size());
  original.reset();
  Normals from_copy, from_assigned;
  std::thread other ([&] {
    for (int i = 0; i < 5; ++i)
      from_copy = estimate (copy, large);
  });
  for (int i = 0; i < 5; ++i)
    from_assigned = estimate (assigned, small);
  other.join();
  EXPECT_TRUE (sameBits (from_copy, expected_large));
  EXPECT_TRUE (sameBits (from_assigned, expected_small));
}

/** pcl::search::OrganizedNeighbor, that Feature would use, refuses such clouds. */
TYPED_TEST (NormalEstimation, CloudsNeedNotBeProjective)
{
  const auto parallel = pcl::make_shared<Cloud> (60, 40);
  for (std::uint32_t v = 0; v < parallel->height; ++v)
    for (std::uint32_t u = 0; u < parallel->width; ++u)
      (*parallel) (u, v).getVector3fMap() << 0.005f * u, 0.005f * v, 1.f + 0.001f * u;
  const Eigen::Vector3f truth (0.2f, 0.f, -1.f);
  typename TestFixture::Estimation estimation;
  typename TestFixture::Feature* feature = &estimation;
  feature->setInputCloud (parallel);
  Normals normals;
  feature->compute (normals);
  ASSERT_EQ (normals.size(), parallel->size());
  for (const auto& normal : normals)
    ASSERT_LE (angleDegrees (normal.getNormalVector3fMap(), truth), 0.1f);
}

TYPED_TEST (NormalEstimation, SearchSettingsOfFeatureAreHarmless)
{
  const Cloud::Ptr cloud = makeHoles();
  typename TestFixture::Estimation estimation;
  estimation.setKSearch (10);
  estimation.setRadiusSearch (0.03); // Feature refuses both together
  estimation.setSearchMethod (pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  EXPECT_TRUE (sameBits (estimate (estimation, cloud), this->byDefault (cloud)));
}

TYPED_TEST (NormalEstimation, SameBitsForAnyNumberOfThreads)
{
  const Cloud::Ptr cloud = makeHoles();
  typename TestFixture::Estimation estimation;
  estimation.setNumberOfThreads (1);
  const Normals one = estimate (estimation, cloud);
  for (const unsigned int threads : {0u, 2u, 3u, 5u, 1u << 30, -1u}) {
    estimation.setNumberOfThreads (threads);
    EXPECT_TRUE (sameBits (estimate (estimation, cloud), one)) << threads;
  }
  estimation.setNumberOfThreads();
  EXPECT_TRUE (sameBits (estimate (estimation, cloud), one)) << "automatic";
}
