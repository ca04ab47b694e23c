// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "normal_clouds.h"

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/features/two_run_normal.h>

#include <gtest/gtest.h>

using namespace normal_clouds;

namespace {

/** For a whole cloud, and for indices in any order. */
template <typename Estimation, typename PointOutT>
void
expectCoordinates ()
{
  const Cloud::Ptr cloud = makeHoles();
  Estimation estimation;
  pcl::PointCloud<PointOutT> output;
  estimation.setInputCloud (cloud);
  estimation.compute (output);
  estimation.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{9, 8, 7}));
  pcl::PointCloud<PointOutT> some;
  estimation.compute (some);
  ASSERT_EQ (output.size(), cloud->size());
  ASSERT_EQ (some.size(), 3u);
  const auto same = [] (const auto& a, const auto& b) {
    return std::memcmp (a.data, b.data, 3 * sizeof (float)) == 0;
  };
  for (std::size_t i = 0; i < cloud->size(); ++i)
    ASSERT_TRUE (same (output[i], (*cloud)[i])) << i;
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_TRUE (same (some[i], (*cloud)[9 - i])) << i;
  EXPECT_TRUE (pcl::isNormalFinite (output[8]));
}

template <typename PointOutT>
class NormalCoordinates : public ::testing::Test {};

using PointsOut =
    ::testing::Types<pcl::PointNormal, pcl::PointXYZRGBNormal, pcl::PointXYZINormal>;
TYPED_TEST_SUITE (NormalCoordinates, PointsOut);

} // namespace

TYPED_TEST (NormalCoordinates, AreCopied)
{
  expectCoordinates<pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, TypeParam>,
                    TypeParam>();
  expectCoordinates<pcl::TwoRunNormalEstimation<pcl::PointXYZ, TypeParam>, TypeParam>();
}
