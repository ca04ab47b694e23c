// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "two_run_clouds.h"

#include <pcl/console/print.h>

#include <gtest/gtest.h>

using synthetic::render;
using synthetic::tiltedPlane;
using namespace two_run;

namespace {

class QuietErrors : public ::testing::Test {
protected:
  void
  SetUp () override
  {
    pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  }
  void
  TearDown () override
  {
    pcl::console::setVerbosityLevel (pcl::console::L_INFO);
  }
};

using TwoRunNormalErrors = QuietErrors;

} // namespace

TEST (TwoRunNormal, SameBitsForAnyNumberOfThreads)
{
  Estimation estimation;
  estimation.setInputCloud (makeHoles());
  Normals one, other;
  estimation.setNumberOfThreads (1);
  estimation.compute (one);
  for (const unsigned int threads : {0u, 2u, 5u}) {
    estimation.setNumberOfThreads (threads);
    estimation.compute (other);
    EXPECT_TRUE (sameBits (one, other)) << threads;
  }
}

TEST (TwoRunNormal, NormalsFaceTheViewpoint)
{
  const Cloud::Ptr cloud = render ({tiltedPlane (1.f, 0.f, 0.f)}, 160, 120).cloud;
  Estimation estimation;
  estimation.setInputCloud (cloud);
  Normals normals;
  estimation.compute (normals);
  EXPECT_LT (normals[0].normal_z, 0.f);
  estimation.setViewPoint (0.f, 0.f, 5.f);
  estimation.compute (normals);
  EXPECT_GT (normals[0].normal_z, 0.f);
  cloud->sensor_origin_ = {0.f, 0.f, 0.2f, 0.f};
  estimation.useSensorOriginAsViewPoint();
  estimation.compute (normals);
  EXPECT_LT (normals[0].normal_z, 0.f);
  float x, y, z;
  estimation.getViewPoint (x, y, z);
  EXPECT_EQ (Eigen::Vector3f (x, y, z), Eigen::Vector3f (0.f, 0.f, 0.2f));
}

TEST (TwoRunNormal, Indices)
{
  const Cloud::Ptr cloud = makeHoles();
  const Normals all = compute (cloud);
  Estimation estimation;
  estimation.setInputCloud (cloud);
  pcl::IndicesPtr indices (new pcl::Indices);
  for (std::size_t i = cloud->size(); i-- > 0;)
    indices->push_back (static_cast<int> (i));
  for (const std::size_t size : {cloud->size(), std::size_t{100}, std::size_t{0}}) {
    indices->resize (size);
    estimation.setIndices (indices);
    Normals some;
    estimation.compute (some);
    ASSERT_EQ (some.size(), size);
    EXPECT_EQ (some.width, size);
    EXPECT_EQ (some.height, 1u);
    for (std::size_t i = 0; i < size; ++i)
      ASSERT_EQ (std::memcmp (&some[i], &all[(*indices)[i]], sizeof (pcl::Normal)), 0);
  }
}

TEST (TwoRunNormal, SearchSurface)
{
  // Few points of a noisy plane, neighbours from the whole of it.
  const Cloud::Ptr surface = makeHoles();
  const Normals all = compute (surface);
  Cloud::Ptr few (new Cloud);
  for (std::size_t i = 0; i < surface->size(); i += 50)
    few->push_back ((*surface)[i]);
  Estimation estimation;
  estimation.setInputCloud (few);
  estimation.setSearchSurface (surface);
  Normals normals;
  estimation.compute (normals);
  ASSERT_EQ (normals.size(), few->size());
  for (std::size_t i = 0; i < normals.size(); ++i)
    EXPECT_EQ (std::memcmp (&normals[i], &all[i * 50], sizeof (pcl::Normal)), 0) << i;
}

TEST (TwoRunNormal, CoordinatesAndHeaderAreCopied)
{
  const Cloud::Ptr cloud = makeHoles();
  cloud->header.frame_id = "camera";
  pcl::TwoRunNormalEstimation<pcl::PointXYZ, pcl::PointNormal> estimation;
  estimation.setInputCloud (cloud);
  pcl::PointCloud<pcl::PointNormal> normals;
  estimation.compute (normals);
  EXPECT_EQ (normals.header.frame_id, "camera");
  EXPECT_EQ (normals[12].getVector3fMap(), (*cloud)[12].getVector3fMap());
}

TEST (TwoRunNormal, ReusableCopyableAndUsableAsFeature)
{
  Estimation estimation;
  Normals normals;
  for (const int width : {64, 2, 40}) {
    estimation.setInputCloud (
        render ({tiltedPlane (0.1f, 0.f, 0.f)}, width, width).cloud);
    Estimation copy (estimation);
    pcl::Feature<pcl::PointXYZ, pcl::Normal>& feature = copy;
    feature.compute (normals);
    EXPECT_EQ (normals.width, width);
    EXPECT_EQ (normals.height, width);
    Normals again;
    estimation.compute (again);
    EXPECT_TRUE (sameBits (normals, again));
  }
}

TEST_F (TwoRunNormalErrors, BadInputGivesEmptyOutput)
{
  const Cloud::Ptr plane = render ({tiltedPlane (1.f, 0.f, 0.f)}, 16, 12).cloud;
  const auto expectEmpty = [] (Estimation& estimation) {
    Normals normals (3, 1);
    estimation.compute (normals);
    EXPECT_TRUE (normals.empty());
    EXPECT_EQ (normals.width * normals.height, 0u);
  };
  Estimation estimation;
  expectEmpty (estimation);
  estimation.setInputCloud (Cloud::Ptr (new Cloud));
  expectEmpty (estimation);
  Cloud::Ptr torn (new Cloud (*plane));
  torn->points.pop_back();
  estimation.setInputCloud (torn);
  expectEmpty (estimation);

  estimation.setInputCloud (plane);
  for (const int index : {-1, 16 * 12}) {
    estimation.setIndices (pcl::IndicesPtr (new pcl::Indices{0, index}));
    expectEmpty (estimation);
  }
  Estimation on_surface;
  on_surface.setInputCloud (plane);
  on_surface.setSearchSurface (Cloud::Ptr (new Cloud));
  expectEmpty (on_surface);
  on_surface.setSearchSurface (plane);
  on_surface.setWindowSize (5);
  expectEmpty (on_surface);
  Estimation unorganized;
  unorganized.setInputCloud (Cloud::Ptr (new Cloud (9, 1)));
  unorganized.setWindowSize (5);
  expectEmpty (unorganized);
}

TEST_F (TwoRunNormalErrors, BadParametersAreRefused)
{
  Estimation estimation;
  estimation.setInputCloud (makeHoles());
  Normals before, after;
  estimation.compute (before);
  estimation.setRadius (-0.1f, 0.1f);
  estimation.setRadius (0.f, 0.f);
  estimation.setRadius (synthetic::nan, 0.1f);
  estimation.setRadius (0.1f, 0.1f, std::numeric_limits<float>::infinity());
  estimation.setRadius (std::function<float (float)>());
  for (const int size : {-1, 1, 4})
    estimation.setWindowSize (size);
  estimation.compute (after);
  EXPECT_TRUE (sameBits (before, after));
}
