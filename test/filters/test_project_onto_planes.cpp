// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/filters/project_onto_planes.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Labels = pcl::PointCloud<pcl::Label>;
using Projection = pcl::ProjectOntoPlanes<pcl::PointXYZ>;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

pcl::ModelCoefficients
model (const Eigen::Vector4f& plane)
{
  pcl::ModelCoefficients result;
  result.values.assign (plane.data(), plane.data() + 4);
  return result;
}

pcl::PointIndices
indices (const pcl::Indices& list)
{
  pcl::PointIndices result;
  result.indices = list;
  return result;
}

const Eigen::Vector4f wall (0.f, 0.f, -1.f, 2.f);        // z = 2
const Eigen::Vector4f slope (0.f, -0.6f, -0.8f, 1.f);    // unit normal
const Eigen::Vector4f floor_plane (0.f, -1.f, 0.f, 1.f); // y = 1, below

Cloud::Ptr
points ()
{
  auto cloud = pcl::make_shared<Cloud>();
  cloud->push_back ({0.5f, -0.2f, 2.1f}); // near the wall
  cloud->push_back ({0.3f, 0.7f, 0.8f});  // near the slope
  cloud->push_back ({1.f, 1.f, 1.f});     // on nothing
  cloud->push_back ({-0.4f, 0.1f, 1.9f}); // near the wall
  return cloud;
}

void
expectNear (const pcl::PointXYZ& actual, const Eigen::Vector3f& expected)
{
  EXPECT_LT ((actual.getVector3fMap() - expected).norm(), 1e-5f)
      << actual << " instead of " << expected.transpose();
}

} // namespace

TEST (ProjectOntoPlanes, PointsMoveAlongTheirViewingRay)
{
  const auto cloud = points();
  Projection projection;
  projection.setInputCloud (cloud);
  projection.setInputPlanes ({model (wall), model (slope)},
                             {indices ({0, 3}), indices ({1})});
  Cloud output;
  projection.filter (output);
  ASSERT_EQ (output.size(), 4u);
  expectNear (output[0], {0.5f * 2.f / 2.1f, -0.2f * 2.f / 2.1f, 2.f});
  expectNear (output[3], {-0.4f * 2.f / 1.9f, 0.1f * 2.f / 1.9f, 2.f});
  expectNear (output[2], {1.f, 1.f, 1.f});
  const Eigen::Vector3f before = (*cloud)[1].getVector3fMap();
  const Eigen::Vector3f after = output[1].getVector3fMap();
  EXPECT_NEAR (slope.head<3>().dot (after) + slope[3], 0.f, 1e-6f);
  EXPECT_LT (before.cross (after).norm(), 1e-6f);
}

TEST (ProjectOntoPlanes, OrAlongTheNormal)
{
  Projection projection;
  projection.setDirection (Projection::Direction::normal);
  projection.setInputCloud (points());
  auto labels = pcl::make_shared<Labels> (4, 1);
  const std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  const std::uint32_t label_of[] = {0, 1, none, 0};
  for (std::size_t i = 0; i < 4; ++i)
    (*labels)[i].label = label_of[i];
  projection.setInputPlanes ({model (3.f * wall), model (-slope)}, labels);
  Cloud output;
  projection.filter (output);
  expectNear (output[0], {0.5f, -0.2f, 2.f});
  expectNear (output[2], {1.f, 1.f, 1.f});
  const Eigen::Vector3f p (0.3f, 0.7f, 0.8f);
  const float distance = slope.head<3>().dot (p) + slope[3];
  expectNear (output[1], p - distance * slope.head<3>());
}

TEST (ProjectOntoPlanes, WithoutARayPointsMoveAlongTheNormal)
{
  const auto cloud = pcl::make_shared<Cloud> (1, 1, pcl::PointXYZ (1.f, 1.f, 1.f));
  cloud->sensor_origin_.head<3>().setOnes();
  Projection projection;
  projection.setInputCloud (cloud);
  projection.setInputPlanes ({model ({-1.f, -1.f, -1.f, 6.f})}, {indices ({0})});
  Cloud output;
  projection.filter (output);
  expectNear (output[0], {2.f, 2.f, 2.f});
}

TEST (ProjectOntoPlanes, AtGrazingAnglesPointsMoveAlongTheNormal)
{
  // Over the floor 1 m below the camera, 3 cm off it; the ray meets it at y / z.
  for (const float z : {5.f, 20.f, 1000.f}) {
    auto cloud = pcl::make_shared<Cloud>();
    cloud->push_back ({0.f, 0.97f, z});
    Projection projection;
    projection.setInputCloud (cloud);
    projection.setInputPlanes ({model (floor_plane)}, {indices ({0})});
    Cloud output;
    projection.filter (output);
    if (z < 9.f)
      expectNear (output[0], {0.f, 1.f, z / 0.97f});
    else
      expectNear (output[0], {0.f, 1.f, z});
    projection.setMaxRayFactor (1.f);
    projection.filter (output);
    expectNear (output[0], {0.f, 1.f, z});
  }
}

TEST (ProjectOntoPlanes, PlanesThroughOrBehindTheCameraMoveNoPointFar)
{
  for (const Eigen::Vector4f& plane : {Eigen::Vector4f (0.f, 0.f, -1.f, 0.f),
                                       Eigen::Vector4f (0.f, 0.f, -1.f, -0.5f),
                                       Eigen::Vector4f (-1.f, 0.f, 0.f, 0.f)}) {
    auto cloud = pcl::make_shared<Cloud>();
    cloud->push_back ({0.01f, 0.02f, 0.1f});
    Projection projection;
    projection.setInputCloud (cloud);
    projection.setInputPlanes ({model (plane)}, {indices ({0})});
    Cloud output;
    projection.filter (output);
    const Eigen::Vector3f p = (*cloud)[0].getVector3fMap();
    const float distance = plane.head<3>().dot (p) + plane[3];
    expectNear (output[0], p - distance * plane.head<3>());
  }
}

TEST (ProjectOntoPlanes, OrganizationAndMissingPointsStay)
{
  auto cloud = pcl::make_shared<Cloud> (2, 3);
  cloud->header.frame_id = "camera";
  cloud->is_dense = false;
  (*cloud)[0].z = 2.1f;
  (*cloud)[1].x = not_a_number;
  (*cloud)[2].getVector3fMap() << 0.f, std::numeric_limits<float>::infinity(), 1.f;
  Projection projection;
  projection.setInputCloud (cloud);
  projection.setInputPlanes ({model (wall)}, {indices ({0, 1, 2, 3})});
  Cloud output;
  projection.filter (output);
  EXPECT_EQ (output.width, 2u);
  EXPECT_EQ (output.height, 3u);
  EXPECT_EQ (output.header.frame_id, "camera");
  EXPECT_FALSE (output.is_dense);
  expectNear (output[0], {0.f, 0.f, 2.f});
  EXPECT_TRUE (std::isnan (output[1].x));
  EXPECT_TRUE (std::isinf (output[2].y));
  expectNear (output[3], {0.f, 0.f, 0.f});

  projection.filter (*cloud);
  EXPECT_EQ (cloud->height, 3u);
  expectNear ((*cloud)[0], {0.f, 0.f, 2.f});
}

TEST (ProjectOntoPlanes, WithIndicesOnlyThesePointsMove)
{
  Projection projection;
  projection.setInputCloud (points());
  projection.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{3, 2}));
  projection.setInputPlanes ({model (wall)}, {indices ({0, 3})});
  Cloud output;
  projection.filter (output);
  ASSERT_EQ (output.size(), 4u);
  EXPECT_EQ (output[0].z, 2.1f);
  EXPECT_FLOAT_EQ (output[3].z, 2.f);
}

TEST (ProjectOntoPlanes, WhatIsNoPlaneMovesNothing)
{
  Projection projection;
  projection.setInputCloud (points());
  pcl::ModelCoefficients three;
  three.values = {0.f, 0.f, 1.f};
  projection.setInputPlanes ({model (Eigen::Vector4f (0.f, 0.f, 0.f, 1.f)),
                              three,
                              model (Eigen::Vector4f (0.f, 0.f, 1.f, not_a_number))},
                             {indices ({0}), indices ({1}), indices ({3})});
  Cloud output;
  projection.filter (output);
  ASSERT_EQ (output.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    expectNear (output[i], (*points())[i].getVector3fMap());
}

TEST (ProjectOntoPlanes, CoefficientsMayHaveAnyLength)
{
  for (const float length : {1e-30f, 1.f, 1e30f}) {
    Projection projection;
    projection.setInputCloud (points());
    projection.setInputPlanes ({model (length * Eigen::Vector4f (0.f, 0.f, 1.f, -2.f))},
                               {indices ({0, 3})});
    Cloud output;
    projection.filter (output);
    for (const std::size_t i : {0, 3})
      EXPECT_NEAR (output[i].z, 2.f, 1e-6f) << length;
  }
}

TEST (ProjectOntoPlanes, LabelsTakeThePlaceOfIndicesAndBack)
{
  Projection projection;
  const auto two = pcl::make_shared<Cloud> (2, 1);
  for (auto& point : *two)
    point.getVector3fMap() << 0.f, 0.f, 2.1f;
  const auto labels = pcl::make_shared<Labels> (2, 1);
  (*labels)[1].label = 1;
  projection.setInputPlanes ({model (wall)}, {indices ({3})}); // of another cloud
  projection.setInputPlanes ({model (wall)}, labels);
  projection.setInputCloud (two);
  Cloud output;
  projection.filter (output);
  ASSERT_EQ (output.size(), 2u);
  EXPECT_EQ (output[0].z, 2.f);
  EXPECT_EQ (output[1].z, 2.1f);
  projection.setInputPlanes ({model (wall)}, {indices ({1})});
  projection.filter (output);
  ASSERT_EQ (output.size(), 2u);
  EXPECT_EQ (output[0].z, 2.1f);
  EXPECT_EQ (output[1].z, 2.f);
}

TEST (ProjectOntoPlanes, BadInputGivesAnEmptyOutput)
{
  Projection projection;
  Cloud output;
  const auto expectRefused = [&] (const std::string& reason) {
    output.resize (7);
    testing::internal::CaptureStderr();
    projection.filter (output);
    const std::string error = testing::internal::GetCapturedStderr();
    EXPECT_TRUE (output.empty()) << reason;
    EXPECT_EQ (error.find ("[pcl::ProjectOntoPlanes] " + reason), 0u) << error;
    EXPECT_EQ (std::count (error.begin(), error.end(), '\n'), 1) << error;
  };
  projection.setInputCloud (points());
  projection.setInputPlanes ({model (wall)}, Labels::ConstPtr());
  expectRefused ("There are 1 planes and 0 lists of their points");
  projection.setInputPlanes ({model (wall)}, pcl::make_shared<Labels> (3, 1));
  expectRefused ("The input has 4 points and 3 labels");
  projection.setInputPlanes ({model (wall)}, {indices ({4})});
  expectRefused ("A point of a plane lies outside of the input cloud of 4 points");
  projection.setInputPlanes ({model (wall)}, {indices ({0})});
  projection.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{-1}));
  expectRefused ("An index lies outside of the input cloud: give indices from 0");
  projection.setIndices (pcl::IndicesPtr());
  const Cloud::Ptr lost = points();
  lost->sensor_origin_.y() = std::numeric_limits<float>::quiet_NaN();
  projection.setInputCloud (lost);
  expectRefused ("The sensor_origin_ of the input cloud is not finite");
  auto image = pcl::make_shared<Cloud> (2, 3), turned = pcl::make_shared<Cloud> (3, 2);
  auto labels = pcl::make_shared<Labels> (3, 2);
  projection.setInputPlanes ({model (wall)}, labels);
  projection.setInputCloud (image);
  expectRefused ("The input has 2 x 3 points and 3 x 2 labels");
  projection.setInputCloud (turned);
  projection.filter (output);
  EXPECT_EQ (output.size(), 6u);
}

TEST (ProjectOntoPlanes, GivesBackItsDirection)
{
  Projection projection;
  EXPECT_EQ (projection.getDirection(), Projection::Direction::viewing_ray);
  projection.setDirection (Projection::Direction::normal);
  EXPECT_EQ (projection.getDirection(), Projection::Direction::normal);
}

TEST (ProjectOntoPlanes, RayFactorsThatMakeNoSenseAreRefused)
{
  pcl::ProjectOntoPlanes<pcl::PointXYZ> projection;
  EXPECT_EQ (projection.getMaxRayFactor(), 10.f);
  projection.setMaxRayFactor (20.f);
  for (const float wrong : {-1.f, std::numeric_limits<float>::quiet_NaN()})
    projection.setMaxRayFactor (wrong);
  EXPECT_EQ (projection.getMaxRayFactor(), 20.f);
}
