// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/filters/obstacle_filter.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

using pcl::rgbd_planes::ObstacleClass;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/** A row of one point of each class, 0 to 5, and a second one of obstacles without a
 * position, but for the last, 11. */
class ObstacleFilterTest : public testing::Test {
protected:
  ObstacleFilterTest() : cloud_ (new Cloud (6, 2)), classes_ (new Classes (6, 2))
  {
    for (std::uint32_t i = 0; i < 12; ++i) {
      (*classes_)[i].label =
          i < 6 ? i : static_cast<std::uint32_t> (ObstacleClass::obstacle);
      (*cloud_)[i].getVector3fMap() << static_cast<float> (i), 0.f, 1.f;
      if (i >= 6 && i < 11)
        (*cloud_)[i].z = not_a_number;
    }
    (*cloud_)[0].z = not_a_number; // unmeasured
    filter_.setInputCloud (cloud_);
    filter_.setClasses (classes_);
  }

  pcl::Indices
  kept ()
  {
    pcl::Indices indices;
    filter_.filter (indices);
    return indices;
  }

  using Classes = pcl::PointCloud<pcl::Label>;
  Cloud::Ptr cloud_;
  Classes::Ptr classes_;
  pcl::ObstacleFilter<pcl::PointXYZ> filter_;
};

} // namespace

TEST_F (ObstacleFilterTest, KeepsObstaclesAndDropOffs)
{
  for (int call = 0; call < 2; ++call) {
    EXPECT_EQ (kept(), (pcl::Indices{2, 3, 11}));
    EXPECT_EQ (*filter_.getRemovedIndices(),
               (pcl::Indices{0, 1, 4, 5, 6, 7, 8, 9, 10}));
  }
}

TEST_F (ObstacleFilterTest, NegativeKeepsAllOthersThatAreFinite)
{
  filter_.setNegative (true);
  EXPECT_EQ (kept(), (pcl::Indices{1, 4, 5}));
  EXPECT_EQ (*filter_.getRemovedIndices(), (pcl::Indices{0, 2, 3, 6, 7, 8, 9, 10, 11}));
}

TEST_F (ObstacleFilterTest, NegativeDropsWhatIsNotMeasured)
{
  filter_.setNegative (true);
  const pcl::Indices before = kept();
  (*cloud_)[1].getVector3fMap().setZero();
  (*cloud_)[4].x = std::numeric_limits<float>::infinity();
  EXPECT_EQ (before, (pcl::Indices{1, 4, 5}));
  EXPECT_EQ (kept(), (pcl::Indices{5}));
}

TEST_F (ObstacleFilterTest, PointsBeyondTheRangeOfTheSensorAreNeverKept)
{
  (*cloud_)[0].z = 20.f; // measured, but not for the detection
  for (const bool negative : {false, true}) {
    filter_.setNegative (negative);
    EXPECT_NE (kept().front(), 0);
    EXPECT_EQ (filter_.getRemovedIndices()->front(), 0);
  }
}

TEST_F (ObstacleFilterTest, WithoutClassesOnlyWhatIndicesGiveIsRemoved)
{
  filter_.setClasses (nullptr);
  filter_.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{7, 1}));
  EXPECT_TRUE (kept().empty());
  EXPECT_EQ (*filter_.getRemovedIndices(), (pcl::Indices{7, 1}));
}

TEST_F (ObstacleFilterTest, WithIndicesOnlyThesePointsAreLookedAtInTheirOrder)
{
  filter_.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{11, 3, 1, 7}));
  EXPECT_EQ (kept(), (pcl::Indices{11, 3}));
  EXPECT_EQ (*filter_.getRemovedIndices(), (pcl::Indices{1, 7}));
}

TEST_F (ObstacleFilterTest, IndicesAreFilteredAlsoInPlace)
{
  const auto indices = pcl::make_shared<pcl::Indices> (pcl::Indices{4, 2, 11, 3, 1, 7});
  filter_.setIndices (indices);
  filter_.filter (*indices);
  EXPECT_EQ (*indices, (pcl::Indices{2, 11, 3}));
  EXPECT_EQ (*filter_.getRemovedIndices(), (pcl::Indices{4, 1, 7}));
}

TEST_F (ObstacleFilterTest, LabelsThatAreNoClassAreNeverKept)
{
  // Those of points on no plane, and of an obstacle but for the higher bits.
  for (const std::uint32_t label : {0xffffffffu, 258u, 6u}) {
    (*classes_)[1].label = label;
    filter_.setNegative (false);
    EXPECT_EQ (kept(), (pcl::Indices{2, 3, 11})) << label;
    filter_.setNegative (true);
    EXPECT_EQ (kept(), (pcl::Indices{4, 5})) << label;
  }
}

TEST_F (ObstacleFilterTest, CloudsAreFilteredAlsoInPlace)
{
  Cloud output;
  filter_.filter (output);
  ASSERT_EQ (output.size(), 3u);
  EXPECT_EQ (output[2].x, 11.f);
  filter_.filter (*cloud_);
  ASSERT_EQ (cloud_->size(), 3u);
  EXPECT_EQ ((*cloud_)[0].x, 2.f);
}

TEST_F (ObstacleFilterTest, TheOrganizationCanBeKept)
{
  filter_.setKeepOrganized (true);
  filter_.setNegative (true);
  Cloud output;
  filter_.filter (output);
  EXPECT_EQ (output.width, 6u);
  EXPECT_EQ (output.height, 2u);
  EXPECT_FALSE (output.is_dense);
  EXPECT_EQ (output[1].x, 1.f);
  EXPECT_TRUE (std::isnan (output[2].x));
  filter_.setUserFilterValue (-7.f);
  filter_.filter (output);
  EXPECT_EQ (output[2].x, -7.f);
  EXPECT_EQ (output[6].z, -7.f) << "points without a position are removed as well";
}

TEST_F (ObstacleFilterTest, WhatIsNotAskedForIsNotKeptInTheOrganizationEither)
{
  filter_.setKeepOrganized (true);
  filter_.setNegative (true);
  for (const pcl::Indices& asked : {pcl::Indices{2, 4, 7}, pcl::Indices{}}) {
    filter_.setIndices (pcl::make_shared<pcl::Indices> (asked));
    Cloud output;
    filter_.filter (output);
    ASSERT_EQ (output.size(), 12u);
    EXPECT_FALSE (output.is_dense);
    for (std::size_t i = 0; i < 12; ++i)
      EXPECT_EQ (std::isnan (output[i].x), asked.empty() || i != 4) << i;
    for (const pcl::index_t removed : *filter_.getRemovedIndices())
      EXPECT_TRUE (removed == 2 || removed == 7) << removed;
  }
}

TEST_F (ObstacleFilterTest, RemovedIndicesNeedNotBeCollected)
{
  pcl::ObstacleFilter<pcl::PointXYZ> filter (false);
  filter.setInputCloud (cloud_);
  filter.setClasses (classes_);
  pcl::Indices indices;
  filter.filter (indices);
  EXPECT_EQ (indices.size(), 3u);
  EXPECT_TRUE (filter.getRemovedIndices()->empty());
}

TEST_F (ObstacleFilterTest, BadInputKeepsNothing)
{
  filter_.setClasses (nullptr);
  EXPECT_TRUE (kept().empty());
  filter_.setClasses (pcl::make_shared<Classes> (5, 2));
  EXPECT_TRUE (kept().empty());
  auto other_shape = pcl::make_shared<Classes> (*classes_);
  other_shape->width = 4;
  other_shape->height = 3;
  filter_.setClasses (other_shape);
  EXPECT_TRUE (kept().empty());
  filter_.setClasses (classes_);
  EXPECT_EQ (kept().size(), 3u);
  filter_.setIndices (
      pcl::make_shared<pcl::Indices> (pcl::Indices{2, -1, 12, 100000000}));
  testing::internal::CaptureStderr();
  EXPECT_TRUE (kept().empty());
  const std::string error = testing::internal::GetCapturedStderr();
  EXPECT_NE (error.find ("give indices from 0"), std::string::npos) << error;
  EXPECT_EQ (error.find ("setClasses"), std::string::npos) << error;

  // Nor does a cloud that stays organized keep a point.
  filter_.setKeepOrganized (true);
  Cloud output;
  for (const bool negative : {false, true}) {
    filter_.setNegative (negative);
    filter_.filter (output);
    EXPECT_EQ (output.size(), cloud_->size());
    for (const auto& point : output)
      EXPECT_TRUE (std::isnan (point.z));
  }
}

TEST_F (ObstacleFilterTest, AsManyIndicesAsPointsAreNotAllPoints)
{
  filter_.setIndices (pcl::make_shared<pcl::Indices> (12, 3));
  Cloud output;
  filter_.filter (output);
  ASSERT_EQ (output.size(), 12u);
  for (const auto& point : output)
    EXPECT_EQ (point.x, 3.f);
}
