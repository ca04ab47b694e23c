// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "table_scenes.h"

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>
#include <pcl/segmentation/obstacle_detection.h>
#include <pcl/segmentation/supported_object_extraction.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace table_scenes;
using Extraction = pcl::SupportedObjectExtraction<pcl::PointXYZ, pcl::Normal>;

namespace {

constexpr float scanner_height = 1.2f;

/** What a scanner sees that turns all around, with rows that are twice as far apart as columns:
 * the floor and boxes on it. */
struct Scan {
  Cloud::Ptr cloud = pcl::make_shared<Cloud> (1024, 128);
  /** The number of the box that each point is on, 0 for the floor, -1 for nothing. */
  std::vector<int> box;
  pcl::PointIndices floor;
};

Scan
scan (const std::vector<Box>& boxes, float sigma, float max_range = 10.f)
{
  const Eigen::Vector3f eye = scanner_height * Eigen::Vector3f::UnitZ();
  std::mt19937 generator (1);
  std::normal_distribution<float> gauss;
  Scan scan;
  scan.box.assign (scan.cloud->size(), -1);
  for (std::size_t i = 0; i < scan.box.size(); ++i) {
    const float azimuth = static_cast<float> (M_PI - 2. * M_PI * (i % 1024) / 1024.);
    const float elevation =
        static_cast<float> (M_PI / 4. - M_PI / 2. * (i / 1024) / 127.);
    const Eigen::Vector3f ray (std::cos (elevation) * std::cos (azimuth),
                               std::cos (elevation) * std::sin (azimuth),
                               std::sin (elevation));
    float range = ray.z() < 0.f ? -scanner_height / ray.z() : max_range;
    scan.box[i] = range < max_range ? 0 : -1;
    for (std::size_t k = 0; k < boxes.size(); ++k)
      if (const auto hit = meet (boxes[k], eye, ray);
          hit.second >= 0 && hit.first < range) {
        range = hit.first;
        scan.box[i] = static_cast<int> (k + 1);
      }
    if (scan.box[i] < 0)
      range = std::numeric_limits<float>::quiet_NaN();
    (*scan.cloud)[i].getVector3fMap() = (range + sigma * gauss (generator)) * ray;
    if (scan.box[i] == 0)
      scan.floor.indices.push_back (static_cast<pcl::index_t> (i));
  }
  return scan;
}

} // namespace

TEST (LaserScanner, FindsObjectsAllAround)
{
  std::vector<Box> boxes;
  for (int k = 0; k < 8; ++k) {
    const float direction = static_cast<float> ((k + 0.5) * M_PI / 4.);
    boxes.push_back ({{1.7f * std::cos (direction), 1.7f * std::sin (direction), 0.f},
                      {0.2f, 0.2f, 0.15f},
                      0.3f * k});
  }
  for (const float sigma : {0.f, 0.005f}) {
    const Scan seen = scan (boxes, sigma);
    pcl::ModelCoefficients floor;
    floor.values = {0.f, 0.f, 1.f, scanner_height};
    Eigen::Affine3f to_base = Eigen::Affine3f::Identity();
    to_base.translation().z() = scanner_height;
    Extraction extraction;
    extraction.setCameraToBase (to_base);
    extraction.setDepthNoise ({std::max (sigma, 0.001f), 0.f});
    extraction.setInputCloud (seen.cloud);
    std::vector<pcl::SupportedObject> objects;
    extraction.extract ({floor}, {seen.floor}, objects);
    EXPECT_EQ (objects.size(), boxes.size()) << sigma;
    for (const auto& object : objects) {
      const int box = seen.box[static_cast<std::size_t> (object.indices.indices[0])];
      ASSERT_GT (box, 0);
      const Eigen::Vector3f& place =
          boxes[static_cast<std::size_t> (box - 1)].bottom_center;
      EXPECT_LT ((object.box_center - place).head<2>().norm(), 0.05f);
      EXPECT_NEAR (object.box_size.z(), 0.15f, 0.02f);
      EXPECT_FALSE (object.truncated);
    }
  }
}

/** Where neighbouring points are 12 cm apart along rows, and 25 cm along columns. */
TEST (LaserScanner, FarThingsAreObstacles)
{
  const Scan seen = scan ({{{20.f, 0.f, 0.f}, {1.f, 6.f, 3.f}}}, 0.01f, 40.f);
  const auto normals =
      pcl::make_shared<pcl::PointCloud<pcl::Normal>> (seen.cloud->width, 128);
  const auto labels =
      pcl::make_shared<pcl::PointCloud<pcl::Label>> (seen.cloud->width, 128);
  for (std::size_t i = 0; i < seen.box.size(); ++i) {
    (*normals)[i] =
        seen.box[i] == 0 ? pcl::Normal (0.f, 0.f, 1.f) : pcl::Normal (-1.f, 0.f, 0.f);
    (*labels)[i].label = seen.box[i] == 0 ? 0u : 1u;
  }
  pcl::ModelCoefficients floor;
  floor.values = {0.f, 0.f, 1.f, scanner_height};
  Eigen::Affine3f to_base = Eigen::Affine3f::Identity();
  to_base.translation().z() = scanner_height;
  pcl::ObstacleDetection<pcl::PointXYZ, pcl::Normal> detection;
  detection.setCameraToBase (to_base);
  detection.setDepthNoise ({0.02f, 0.f});
  detection.setInputCloud (seen.cloud);
  detection.setInputNormals (normals);
  detection.setInputPlanes ({floor}, labels);
  std::vector<pcl::rgbd_planes::Obstacle> obstacles;
  detection.detect (obstacles);
  ASSERT_EQ (obstacles.size(), 1u);
  EXPECT_NEAR (obstacles[0].distance, 19.5f, 0.1f);
  const auto points = std::count (seen.box.begin(), seen.box.end(), 1);
  EXPECT_GT (points, 400);
  EXPECT_GT (static_cast<std::ptrdiff_t> (obstacles[0].indices.size()),
             points * 9 / 10);
}

/** Whose normals are wrong far away, at the foot of what stands there. */
TEST (LaserScanner, FindsTheFloorUnderFarThings)
{
  for (float distance = 10.f; distance <= 30.f; distance += 2.f) {
    std::vector<Box> boxes{{{distance + 6.f, 0.f, 0.f}, {0.5f, 60.f, 6.f}}};
    for (int k = -2; k <= 2; ++k)
      boxes.push_back ({{distance, 2.f * k, 0.f}, {0.4f, 0.5f, 1.7f}});
    // What is ahead, within 22 degrees of the horizon.
    const Scan all = scan (boxes, 0.01f, 60.f);
    const auto ahead = pcl::make_shared<Cloud> (512, 64);
    for (std::uint32_t v = 0; v < ahead->height; ++v)
      for (std::uint32_t u = 0; u < ahead->width; ++u)
        (*ahead) (u, v) = (*all.cloud) (u + 256, v + 32);
    const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
    pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    estimation.setDepthNoise ({0.02f, 0.f});
    estimation.setInputCloud (ahead);
    estimation.compute (*normals);
    pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> segmentation;
    segmentation.setDepthNoise ({0.02f, 0.f});
    segmentation.setInputCloud (ahead);
    segmentation.setInputNormals (normals);
    std::vector<pcl::ModelCoefficients> models;
    std::vector<pcl::PointIndices> inliers;
    segmentation.segment (models, inliers);
    const auto isFloor = [] (const pcl::ModelCoefficients& model) {
      return model.values[2] > 0.999f &&
             std::fabs (model.values[3] - scanner_height) < 0.02f;
    };
    EXPECT_TRUE (std::any_of (models.begin(), models.end(), isFloor)) << distance;
  }
}
