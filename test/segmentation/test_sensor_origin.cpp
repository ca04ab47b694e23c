// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/common/io.h>
#include <pcl/common/transforms.h>
#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/filters/project_onto_planes.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>
#include <pcl/segmentation/obstacle_detection.h>
#include <pcl/segmentation/supported_object_extraction.h>
#include <pcl/simulation/simulate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;

namespace {

/** A frame, and all that is made of it. */
struct Results {
  Cloud::Ptr cloud;
  Normals::Ptr normals = pcl::make_shared<Normals>();
  pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> segmentation;
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  pcl::PointCloud<pcl::Label>::Ptr labels =
      pcl::make_shared<pcl::PointCloud<pcl::Label>>();
  std::vector<pcl::SupportedObject> objects;
  std::vector<pcl::rgbd_planes::Obstacle> obstacles;
  std::vector<pcl::rgbd_planes::ObstacleClass> classes;
  Eigen::Vector4f floor;
  Cloud projected;

  Results (Cloud::Ptr frame, const Eigen::Affine3f& to_base) : cloud (std::move (frame))
  {
    pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    estimation.setInputCloud (cloud);
    estimation.compute (*normals);
    segmentation.setInputCloud (cloud);
    segmentation.setInputNormals (normals);
    segmentation.segment (models, inliers, *labels);
    pcl::SupportedObjectExtraction<pcl::PointXYZ, pcl::Normal> extraction;
    extraction.setCameraToBase (to_base);
    extraction.setInputCloud (cloud);
    extraction.extract (models, inliers, objects);
    pcl::ObstacleDetection<pcl::PointXYZ, pcl::Normal> detection;
    detection.setCameraToBase (to_base);
    detection.setInputCloud (cloud);
    detection.setInputNormals (normals);
    detection.setInputPlanes (models, labels);
    detection.detect (obstacles);
    floor = detection.getFloor();
    classes = detection.getClasses();
    pcl::ProjectOntoPlanes<pcl::PointXYZ> projection;
    projection.setInputCloud (cloud);
    projection.setInputPlanes (models, inliers);
    projection.filter (projected);
  }

  Eigen::Vector4f
  plane (std::size_t k) const
  {
    return Eigen::Map<const Eigen::Vector4f> (models[k].values.data());
  }
};

/** The same frame as the camera sees it, and with the camera at \a place. */
class SensorOrigin : public testing::Test {
protected:
  SensorOrigin()
  {
    const auto frame = pcl::rgbd_planes::simulate (
        "table_cluttered", 1, pcl::rgbd_planes::Sensor::kinect);
    const auto cloud = pcl::make_shared<Cloud>(), shifted = pcl::make_shared<Cloud>();
    pcl::copyPointCloud (*frame.cloud, *cloud);
    pcl::transformPointCloud (
        *cloud, *shifted, Eigen::Affine3f (Eigen::Translation3f (place)));
    shifted->sensor_origin_.head<3>() = place;
    shifted_to_base = frame.camera_to_base;
    shifted_to_base.translate (-place);
    at_origin = std::make_unique<Results> (cloud, frame.camera_to_base);
    elsewhere = std::make_unique<Results> (shifted, shifted_to_base);
  }

  // Nothing is rounded but the coordinates.
  const Eigen::Vector3f place{0.5f, -2.f, 1.f};
  Eigen::Affine3f shifted_to_base;
  std::unique_ptr<Results> at_origin, elsewhere;
};

} // namespace

/** Points (0, 0, 0) of a cloud that was moved with them, but for what is rounded. */
TEST_F (SensorOrigin, PointsAtTheSensorAreMissing)
{
  const auto moved = pcl::make_shared<Cloud> (*elsewhere->cloud);
  for (auto& p : *moved)
    if (std::isnan (p.x)) {
      p.getVector3fMap() = place;
      p.x = std::nextafter (p.x, 1.f);
    }
  const Results results (moved, shifted_to_base);
  std::size_t missing = 0;
  for (std::size_t i = 0; i < moved->size(); ++i)
    if (std::isnan ((*elsewhere->cloud)[i].x)) {
      ++missing;
      ASSERT_EQ (results.classes[i], pcl::rgbd_planes::ObstacleClass::unmeasured);
    }
  EXPECT_GT (missing, 1000u);
  EXPECT_EQ (results.models.size(), elsewhere->models.size());
  EXPECT_EQ (results.objects.size(), elsewhere->objects.size());
}

TEST_F (SensorOrigin, PlanesAreTheSame)
{
  ASSERT_GT (at_origin->models.size(), 5u);
  ASSERT_EQ (elsewhere->models.size(), at_origin->models.size());
  std::size_t differ = 0;
  for (std::size_t i = 0; i < at_origin->labels->size(); ++i)
    differ += (*at_origin->labels)[i].label != (*elsewhere->labels)[i].label;
  EXPECT_LT (differ, at_origin->labels->size() / 1000);
  for (std::size_t k = 0; k < at_origin->models.size(); ++k) {
    Eigen::Vector4f expected = at_origin->plane (k);
    expected[3] -= expected.head<3>().dot (place);
    EXPECT_TRUE (elsewhere->plane (k).isApprox (expected, 1e-3f)) << k;
    EXPECT_NEAR (
        elsewhere->segmentation.getRms()[k], at_origin->segmentation.getRms()[k], 1e-4);
  }
}

TEST_F (SensorOrigin, MustBeFinite)
{
  ASSERT_FALSE (at_origin->models.empty());
  at_origin->cloud->sensor_origin_.x() = std::numeric_limits<float>::infinity();
  testing::internal::CaptureStderr();
  at_origin->segmentation.segment (at_origin->models, at_origin->inliers);
  EXPECT_NE (testing::internal::GetCapturedStderr().find ("set it to where the camera"),
             std::string::npos);
  EXPECT_TRUE (at_origin->models.empty());
}

TEST_F (SensorOrigin, CovariancesAreThoseOfTheShiftedPlanes)
{
  for (std::size_t k = 0; k < at_origin->models.size(); ++k) {
    // Of the distance from the plane of any point.
    const Eigen::Vector3d p (0.3, 0.2, 1.5), q = p + place.cast<double>();
    const auto variance = [k] (const Results& results, const Eigen::Vector3d& point) {
      const Eigen::Vector4d x = point.homogeneous();
      return x.dot (results.segmentation.getParameterCovariances()[k] * x);
    };
    EXPECT_NEAR (variance (*elsewhere, q) / variance (*at_origin, p), 1., 0.05) << k;
  }
}

TEST_F (SensorOrigin, RegionsLieInTheCloud)
{
  std::vector<pcl::PlanarRegion<pcl::PointXYZ>,
              Eigen::aligned_allocator<pcl::PlanarRegion<pcl::PointXYZ>>>
      regions;
  elsewhere->segmentation.segment (regions);
  ASSERT_EQ (regions.size(), at_origin->models.size());
  for (std::size_t k = 0; k < regions.size(); ++k) {
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    for (const auto i : elsewhere->inliers[k].indices)
      mean += (*elsewhere->cloud)[i].getVector3fMap() /
              static_cast<float> (elsewhere->inliers[k].indices.size());
    EXPECT_LT ((regions[k].getCentroid() - mean).norm(), 1e-3f);
  }
}

TEST_F (SensorOrigin, ObjectsAreTheSame)
{
  ASSERT_GT (at_origin->objects.size(), 20u);
  ASSERT_EQ (elsewhere->objects.size(), at_origin->objects.size());
  for (std::size_t k = 0; k < at_origin->objects.size(); ++k) {
    const auto& a = at_origin->objects[k];
    const auto& b = elsewhere->objects[k];
    EXPECT_LT ((b.centroid - place - a.centroid).norm(), 5e-3f) << k;
    EXPECT_LT ((b.box_center - place - a.box_center).norm(), 2e-2f) << k;
  }
}

TEST_F (SensorOrigin, ObstaclesAreTheSame)
{
  Eigen::Vector4f expected = at_origin->floor;
  ASSERT_NE (expected[3], 0.f);
  expected[3] -= expected.head<3>().dot (place);
  EXPECT_TRUE (elsewhere->floor.isApprox (expected, 1e-3f));
  ASSERT_FALSE (at_origin->obstacles.empty());
  ASSERT_EQ (elsewhere->obstacles.size(), at_origin->obstacles.size());
  for (std::size_t k = 0; k < at_origin->obstacles.size(); ++k)
    EXPECT_NEAR (
        elsewhere->obstacles[k].distance, at_origin->obstacles[k].distance, 5e-3f);
}

TEST_F (SensorOrigin, PointsAreProjectedAlongTheRaysOfTheSensor)
{
  std::size_t moved = 0;
  for (std::size_t i = 0; i < at_origin->cloud->size(); ++i) {
    const Eigen::Vector3f p = (*elsewhere->cloud)[i].getVector3fMap() - place;
    const Eigen::Vector3f q = elsewhere->projected[i].getVector3fMap() - place;
    if (!p.allFinite() || (p - q).norm() < 1e-3f)
      continue;
    ++moved;
    // Of the few on flat rays, which move along normals, rays cross as well.
    if (p.cross (q).norm() > 1e-4f * p.squaredNorm()) {
      const auto k = (*elsewhere->labels)[i].label;
      const Eigen::Vector3f n = elsewhere->plane (k).head<3>();
      ASSERT_LT (n.cross (q - p).norm(), 1e-4f) << i;
    }
  }
  EXPECT_GT (moved, 10000u);
}
