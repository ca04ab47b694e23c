// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/filters/camera_to_base.h>
#include <pcl/filters/depth_warp_correction.h>
#include <pcl/filters/obstacle_filter.h>
#include <pcl/filters/project_onto_planes.h>

#include <gtest/gtest.h>

namespace {

template <typename Filter>
class FilterCopies : public ::testing::Test {};

using Filters = ::testing::Types<pcl::CameraToBase<pcl::PointXYZ>,
                                 pcl::DepthWarpCorrection<pcl::PointXYZ>,
                                 pcl::ObstacleFilter<pcl::PointXYZ>,
                                 pcl::ProjectOntoPlanes<pcl::PointXYZ>>;
TYPED_TEST_SUITE (FilterCopies, Filters);

} // namespace

/** Two threads with a copy each lost points, for both changed the same indices. */
TYPED_TEST (FilterCopies, HaveIndicesOfTheirOwn)
{
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;
  const auto small = pcl::make_shared<Cloud> (4, 3);
  const auto large = pcl::make_shared<Cloud> (40, 30);
  Cloud output;
  const auto filter = [&] (TypeParam& to_run, const Cloud::ConstPtr& cloud) {
    to_run.setInputCloud (cloud);
    to_run.filter (output);
  };
  TypeParam original, assigned;
  filter (original, small);
  TypeParam copy (original);
  assigned = original;
  filter (copy, large);
  filter (assigned, large);
  EXPECT_EQ (original.getIndices()->size(), small->size());
  EXPECT_EQ (copy.getIndices()->size(), large->size());
  EXPECT_NE (copy.getIndices(), assigned.getIndices());
  EXPECT_NE (copy.getRemovedIndices(), original.getRemovedIndices());
  EXPECT_NE (assigned.getRemovedIndices(), original.getRemovedIndices());

  // Indices that were set are shared, as in PCL.
  original.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{1, 2}));
  copy = original;
  EXPECT_EQ (copy.getIndices(), original.getIndices());
}
