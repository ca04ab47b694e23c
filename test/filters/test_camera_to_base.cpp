// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "synthetic_clouds.h"

#include <pcl/common/io.h>
#include <pcl/common/point_tests.h>
#include <pcl/filters/camera_to_base.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::PointNormal>;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

void
expectNear (const Eigen::Vector3f& actual, const Eigen::Vector3f& expected)
{
  EXPECT_LT ((actual - expected).norm(), 1e-5f)
      << actual.transpose() << " instead of " << expected.transpose();
}

Eigen::Affine3f
someTransform ()
{
  return Eigen::Translation3f (0.1f, -0.2f, 1.3f) *
         Eigen::AngleAxisf (0.7f, Eigen::Vector3f (1.f, 2.f, -1.f).normalized());
}

Normals::Ptr
someNormals ()
{
  auto cloud = pcl::make_shared<Normals> (3, 2);
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    auto& p = (*cloud)[i];
    p.getVector3fMap() << 0.1f * static_cast<float> (i), 0.2f, 1.f;
    p.getNormalVector3fMap() << 0.6f, 0.f, -0.8f;
    p.curvature = static_cast<float> (i);
  }
  return cloud;
}

} // namespace

TEST (CameraToBase, WithoutATransformAxesAreExchangedAndYIsShifted)
{
  auto cloud = pcl::make_shared<Cloud>();
  cloud->push_back ({1.f, 2.f, 3.f}); // right, down, forward
  pcl::CameraToBase<pcl::PointXYZ> filter;
  filter.setInputCloud (cloud);
  Cloud output;
  filter.filter (output);
  expectNear (output[0].getVector3fMap(), {3.f, -1.f + 0.02f, -2.f});
}

TEST (CameraToBase, NormalsInACloudOfTheirOwnTurn)
{
  auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::copyPointCloud (*someNormals(), *normals);
  (*normals)[1].getNormalVector3fMap().setConstant (not_a_number);
  pcl::CameraToBase<pcl::Normal> filter;
  filter.setTransform (someTransform());
  filter.setInputCloud (normals);
  pcl::PointCloud<pcl::Normal> output;
  filter.filter (output);
  ASSERT_EQ (output.size(), 6u);
  EXPECT_EQ (output.width, 3u);
  EXPECT_EQ (output.header.frame_id, "base_link");
  for (std::size_t i = 0; i < output.size(); ++i) {
    EXPECT_EQ (output[i].curvature, static_cast<float> (i));
    if (i != 1)
      expectNear (output[i].getNormalVector3fMap(),
                  someTransform().rotation() * (*normals)[i].getNormalVector3fMap());
  }
  EXPECT_TRUE (std::isnan (output[1].normal_x));
}

TEST (CameraToBase, PointsAndNormalsMoveByTheTransform)
{
  const auto cloud = someNormals();
  const Eigen::Affine3f transform = someTransform();
  pcl::CameraToBase<pcl::PointNormal> filter;
  filter.setTransform (transform);
  filter.setInputCloud (cloud);
  Normals output;
  filter.filter (output);
  EXPECT_EQ (output.width, 3u);
  EXPECT_EQ (output.height, 2u);
  EXPECT_TRUE (output.is_dense);
  for (std::size_t i = 0; i < output.size(); ++i) {
    const Eigen::Vector3f p = (*cloud)[i].getVector3fMap();
    const Eigen::Vector3f n = (*cloud)[i].getNormalVector3fMap();
    expectNear (output[i].getVector3fMap(), transform * p);
    expectNear (output[i].getNormalVector3fMap(), transform.rotation() * n);
    EXPECT_EQ (output[i].curvature, static_cast<float> (i));
  }
}

TEST (CameraToBase, ColoursStay)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGBA>> (2, 1);
  (*cloud)[1].rgba = 0x80123456;
  (*cloud)[1].z = 2.f;
  pcl::CameraToBase<pcl::PointXYZRGBA> filter;
  filter.setInputCloud (cloud);
  pcl::PointCloud<pcl::PointXYZRGBA> output;
  filter.filter (output);
  EXPECT_EQ (output[1].rgba, 0x80123456u);
  EXPECT_FLOAT_EQ (output[1].x, 2.f);
}

TEST (CameraToBase, MissingPointsAreNanAfterwards)
{
  auto cloud = pcl::make_shared<Cloud>();
  for (const pcl::PointXYZ& p :
       {pcl::PointXYZ (not_a_number, not_a_number, not_a_number),
        pcl::PointXYZ (0.f, 0.f, 0.f),
        pcl::PointXYZ (1.f, inf, 1.f),
        pcl::PointXYZ (0.f, 0.f, 1.f)})
    cloud->push_back (p);
  pcl::CameraToBase<pcl::PointXYZ> filter;
  filter.setTransform (someTransform());
  filter.setInputCloud (cloud);
  Cloud output;
  filter.filter (output);
  ASSERT_EQ (output.size(), 4u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_TRUE (std::isnan (output[i].x) && std::isnan (output[i].z)) << i;
  EXPECT_TRUE (pcl::isFinite (output[3]));
  EXPECT_FALSE (output.is_dense);
}

TEST (CameraToBase, InputMayBeTheOutput)
{
  const auto cloud = someNormals();
  cloud->header.frame_id = "camera";
  cloud->header.stamp = 42;
  pcl::CameraToBase<pcl::PointNormal> filter;
  filter.setTransform (someTransform());
  EXPECT_EQ (filter.getBaseFrame(), "base_link");
  filter.setBaseFrame ("robot");
  EXPECT_EQ (filter.getBaseFrame(), "robot");
  filter.setInputCloud (cloud);
  Normals other;
  filter.filter (other);
  filter.filter (*cloud);
  ASSERT_EQ (cloud->size(), other.size());
  for (std::size_t i = 0; i < other.size(); ++i)
    expectNear ((*cloud)[i].getVector3fMap(), other[i].getVector3fMap());
  for (const auto* result : {&other, cloud.get()}) {
    EXPECT_EQ (result->header.frame_id, "robot");
    EXPECT_EQ (result->header.stamp, 42u);
    EXPECT_EQ (result->width, 3u);
    expectNear (result->sensor_origin_.head<3>(), someTransform().translation());
    EXPECT_TRUE (result->sensor_orientation_.toRotationMatrix().isApprox (
        someTransform().rotation(), 1e-5f));
  }
}

TEST (CameraToBase, TheSensorMovesWithThePoints)
{
  // By way of the head of a robot; with indices, too.
  const Eigen::Affine3f to_head = someTransform();
  const Eigen::Affine3f to_base =
      Eigen::Translation3f (0.2f, 0.f, 1.f) *
      Eigen::AngleAxisf (0.4f, Eigen::Vector3f (-1.f, 0.5f, 3.f).normalized());
  const Eigen::Affine3f expected = to_base * to_head;
  const auto in_head = pcl::make_shared<Normals>();
  pcl::CameraToBase<pcl::PointNormal> filter;
  filter.setTransform (to_head);
  filter.setInputCloud (someNormals());
  filter.filter (*in_head);
  filter.setTransform (to_base);
  filter.setInputCloud (in_head);
  Normals output;
  for (const bool has_indices : {false, true}) {
    if (has_indices)
      filter.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{4, 1}));
    filter.filter (output);
    expectNear (output.sensor_origin_.head<3>(), expected.translation());
    EXPECT_EQ (output.sensor_origin_[3], 1.f);
    EXPECT_TRUE (output.sensor_orientation_.toRotationMatrix().isApprox (
        expected.rotation(), 1e-5f));
  }
}

TEST (CameraToBase, WithIndicesOnlyThesePointsAreGiven)
{
  const auto cloud = someNormals();
  pcl::CameraToBase<pcl::PointNormal> filter;
  filter.setInputCloud (cloud);
  filter.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{4, 1}));
  Normals output;
  filter.filter (output);
  ASSERT_EQ (output.size(), 2u);
  EXPECT_EQ (output.height, 1u);
  EXPECT_EQ (output[0].curvature, 4.f);
  EXPECT_EQ (output[1].curvature, 1.f);
  for (const bool is_dense : {false, true}) {
    cloud->is_dense = is_dense;
    filter.filter (output);
    EXPECT_EQ (output.is_dense, is_dense);
  }

  // As many as there are points.
  filter.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{4, 1, 1, 5, 0, 3}));
  ASSERT_EQ (cloud->size(), 6u);
  filter.filter (output);
  ASSERT_EQ (output.size(), 6u);
  EXPECT_EQ (output.height, 1u);
  EXPECT_EQ (output[0].curvature, 4.f);
  EXPECT_EQ (output[2].curvature, 1.f);

  filter.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{6}));
  filter.filter (output);
  EXPECT_TRUE (output.empty());

  filter.setIndices (pcl::IndicesPtr()); // the whole cloud again
  filter.filter (output);
  EXPECT_EQ (output.width, cloud->width);
  EXPECT_EQ (output.height, cloud->height);
}

TEST (CameraToBase, NoCloudOrAnEmptyOneGivesAnEmptyOne)
{
  pcl::CameraToBase<pcl::PointXYZ> filter;
  Cloud output (2, 2);
  filter.filter (output);
  EXPECT_TRUE (output.empty());
  filter.setInputCloud (pcl::make_shared<Cloud>());
  output.resize (4);
  filter.filter (output);
  EXPECT_TRUE (output.empty());
}

TEST (CameraToBase, OnlyRigidTransformsAreTaken)
{
  pcl::CameraToBase<pcl::PointXYZ> filter;
  filter.setTransform (someTransform());
  Eigen::Affine3f scaled = someTransform(), mirrored = someTransform(),
                  undefined = someTransform();
  scaled.linear() *= 1.002f;
  mirrored.linear().col (0) *= -1.f;
  undefined.translation().x() = not_a_number;
  for (const auto& transform : {scaled, mirrored, undefined}) {
    filter.setTransform (transform);
    EXPECT_EQ (filter.getTransform().matrix(), someTransform().matrix());
  }
}

/** The plane z = 0 of the base frame in the camera frame. */
Eigen::Vector4f
floorSeenFrom (const Eigen::Affine3f& camera_to_base)
{
  return camera_to_base.matrix().row (2);
}

TEST (CameraToBase, AFloorTellsHeightAndTilt)
{
  for (const float height : {0.2f, 1.5f})
    for (const float pitch : {-0.5f, 0.f, 0.8f, 1.5f})
      for (const float roll : {-0.3f, 0.f, 0.1f})
        for (const float scale : {1.f, -1.f, 3.f, 1e-22f, 1e30f}) {
          const Eigen::Affine3f truth = synthetic::cameraPose (height, pitch, roll);
          const Eigen::Vector4f floor = scale * floorSeenFrom (truth);
          pcl::ModelCoefficients model;
          model.values.assign (floor.data(), floor.data() + 4);
          pcl::CameraToBase<pcl::PointXYZ> filter;
          ASSERT_TRUE (filter.estimateFromFloor (model));
          EXPECT_TRUE (filter.getTransform().isApprox (truth, 1e-4f))
              << height << ' ' << pitch << ' ' << roll << ' ' << scale;
        }
}

TEST (CameraToBase, LookingStraightDownTheTopOfTheImageIsForward)
{
  const auto transform =
      pcl::rgbd_planes::cameraToBaseFromFloor ({0.f, 0.f, -1.f, 2.f});
  ASSERT_TRUE (transform);
  EXPECT_TRUE (pcl::rgbd_planes::isRigid (*transform));
  expectNear (*transform * Eigen::Vector3f (0.f, -1.f, 2.f), {1.f, 0.f, 0.f});
  expectNear (*transform * Eigen::Vector3f (1.f, 0.f, 1.f), {0.f, -1.f, 1.f});
}

TEST (CameraToBase, WhatIsNoPlaneGivesNoEstimate)
{
  pcl::CameraToBase<pcl::PointXYZ> filter;
  filter.setTransform (someTransform());
  for (const std::vector<float>& values :
       {std::vector<float>{0.f, 0.f, 0.f, 1.f},
        std::vector<float>{0.f, not_a_number, 1.f, 1.f},
        std::vector<float>{0.f, 0.f, 1.f, inf},
        std::vector<float>{0.f, 0.f, 1.f},
        std::vector<float>{}}) {
    pcl::ModelCoefficients model;
    model.values = values;
    EXPECT_FALSE (filter.estimateFromFloor (model));
    EXPECT_TRUE (filter.getTransform().isApprox (someTransform()));
  }
}
