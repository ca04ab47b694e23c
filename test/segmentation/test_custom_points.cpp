// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// Point types that the libraries are not instantiated for.
#define PCL_NO_PRECOMPILE

#include "numbers_of_all_classes.h"
#include "vector_map.h"

#include <pcl/register_point_struct.h>

#include <limits>

struct EIGEN_ALIGN16 WarmPoint {
  PCL_ADD_POINT4D
  float temperature = 0.f;
};

POINT_CLOUD_REGISTER_POINT_STRUCT (
    WarmPoint,
    (float, x, x) (float, y, y) (float, z, z) (float, temperature, temperature))

/** Neither aligned nor padded, as a driver may store what it measures. */
struct PackedPoint {
  std::uint32_t time;
  float x, y, z;
  ADD_VECTOR_MAP
};

POINT_CLOUD_REGISTER_POINT_STRUCT (
    PackedPoint, (std::uint32_t, time, time) (float, x, x) (float, y, y) (float, z, z))

struct Surfel {
  float x, y, z;
  float radius;
  float normal_x, normal_y, normal_z;
  float curvature;
  ADD_VECTOR_MAP
};

POINT_CLOUD_REGISTER_POINT_STRUCT (
    Surfel,
    (float, x, x) (float, y, y) (float, z, z) (float, radius, radius) (
        float, normal_x, normal_x) (float, normal_y, normal_y) (
        float, normal_z, normal_z) (float, curvature, curvature))

struct Opinion {
  float probability;
  std::uint32_t label;
};

POINT_CLOUD_REGISTER_POINT_STRUCT (
    Opinion, (float, probability, probability) (std::uint32_t, label, label))

TEST (CustomPoints, GiveTheSameInAllClasses)
{
  expectSameAsPointXYZ<WarmPoint, Surfel, Opinion>();
  expectSameAsPointXYZ<PackedPoint, Surfel, pcl::Label>();
  expectSameAsPointXYZ<Surfel, Surfel, Opinion>();
}

TEST (CustomPoints, LabelsBesidePointsLeaveThosePointsAsTheyAre)
{
  const synthetic::FloorScene scene ({synthetic::floorAt (0.f)},
                                     synthetic::cameraPose (0.8f, 0.45f));
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZL>>();
  pcl::copyPointCloud (*scene.cloud, *cloud);
  (*cloud)[0].x = std::numeric_limits<float>::quiet_NaN();
  cloud->is_dense = false;

  pcl::NormalSpacePlaneSegmentation<pcl::PointXYZL, pcl::Normal, pcl::PointXYZL>
      segmentation;
  segmentation.setInputCloud (cloud);
  segmentation.setInputNormals (scene.normals);
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  segmentation.segment (models, inliers, *cloud);
  ASSERT_EQ (models.size(), 1u);
  EXPECT_EQ (cloud->back().label, 0u);
  EXPECT_FALSE (cloud->is_dense);

  pcl::ObstacleDetection<pcl::PointXYZL, pcl::Normal, pcl::PointXYZL> detection;
  detection.setCameraToBase (scene.camera_to_base);
  detection.setInputCloud (cloud);
  detection.setInputNormals (scene.normals);
  detection.setInputPlanes (models, cloud);
  std::vector<pcl::rgbd_planes::Obstacle> obstacles;
  detection.detect (obstacles, *cloud);
  EXPECT_EQ (cloud->back().label,
             static_cast<std::uint32_t> (pcl::rgbd_planes::ObstacleClass::floor));
  EXPECT_FALSE (cloud->is_dense);
}

TEST (CustomPoints, GoThroughDetectionAndAllFilters)
{
  std::vector<synthetic::Patch> patches{synthetic::floorAt (0.f)};
  synthetic::addBox ({1.2f, -0.1f, 0.f}, {1.5f, 0.2f, 0.3f}, patches);
  const synthetic::FloorScene scene (patches, synthetic::cameraPose (0.8f, 0.45f));
  auto cloud = pcl::make_shared<pcl::PointCloud<WarmPoint>>();
  pcl::copyPointCloud (*scene.cloud, *cloud);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    (*cloud)[i].temperature = static_cast<float> (i);

  pcl::ObstacleDetection<WarmPoint, pcl::Normal> detection;
  detection.setCameraToBase (scene.camera_to_base);
  detection.setInputCloud (cloud);
  detection.setInputNormals (scene.normals);
  detection.setInputPlanes (scene.planes, scene.labels);
  std::vector<pcl::rgbd_planes::Obstacle> obstacles;
  auto classes = pcl::make_shared<pcl::PointCloud<pcl::Label>>();
  detection.detect (obstacles, *classes);
  ASSERT_EQ (obstacles.size(), 1u);

  pcl::PointCloud<WarmPoint> output;
  pcl::ObstacleFilter<WarmPoint> filter;
  filter.setInputCloud (cloud);
  filter.setClasses (classes);
  filter.filter (output);
  ASSERT_EQ (output.size(), obstacles[0].indices.size());
  for (std::size_t i = 0; i < output.size(); ++i)
    EXPECT_EQ (output[i].temperature, static_cast<float> (obstacles[0].indices[i]));

  pcl::ProjectOntoPlanes<WarmPoint> projection;
  projection.setInputCloud (cloud);
  projection.setInputPlanes (scene.planes, scene.labels);
  projection.filter (output);
  EXPECT_EQ (output.back().temperature, cloud->back().temperature);
  EXPECT_LT ((output.back().getVector3fMap() - cloud->back().getVector3fMap()).norm(),
             1e-4f)
      << "already on its plane";

  pcl::DepthWarpCorrection<WarmPoint> correction;
  EXPECT_TRUE (correction.addFrame (cloud, {}, {}));
  correction.setInputCloud (cloud);
  correction.filter (output);
  EXPECT_EQ (output.back().temperature, cloud->back().temperature);

  pcl::CameraToBase<WarmPoint> to_base;
  to_base.setTransform (scene.camera_to_base);
  to_base.setInputCloud (cloud);
  to_base.filter (output);
  EXPECT_NEAR (output.back().z, 0.f, 1e-5f) << "on the floor";
  EXPECT_EQ (output.back().temperature, cloud->back().temperature);
}
