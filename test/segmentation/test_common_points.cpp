// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "numbers_of_all_classes.h"

namespace {

template <typename PointT>
class CommonPoints : public testing::Test {};

using PointTypes = testing::Types<pcl::PointXYZ,
                                  pcl::PointXYZI,
                                  pcl::PointXYZRGB,
                                  pcl::PointXYZRGBA,
                                  pcl::PointNormal,
                                  pcl::PointXYZRGBNormal>;
TYPED_TEST_SUITE (CommonPoints, PointTypes);

} // namespace

TYPED_TEST (CommonPoints, GiveTheSameInAllClasses)
{
  expectSameAsPointXYZ<TypeParam, pcl::Normal, pcl::Label>();
  expectSameAsPointXYZ<TypeParam, pcl::PointNormal, pcl::Label>();
  expectSameAsPointXYZ<TypeParam, pcl::PointXYZRGBNormal, pcl::Label>();
}
