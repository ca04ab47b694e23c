// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "count_allocations.h"
#include "floor_scene.h"

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>
#include <pcl/segmentation/obstacle_detection.h>

#include <gtest/gtest.h>

#include <algorithm>

using pcl::rgbd_planes::Obstacle;
using pcl::rgbd_planes::ObstacleClass;
using synthetic::box;
using synthetic::cameraPose;
using synthetic::floorAt;
using synthetic::FloorScene;
using synthetic::Patch;
using Detection = pcl::ObstacleDetection<pcl::PointXYZ, pcl::Normal>;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint32_t no_plane = std::numeric_limits<std::uint32_t>::max();

struct Result {
  std::vector<Obstacle> obstacles;
  pcl::PointCloud<pcl::Label> classes;

  ObstacleClass
  operator[] (std::size_t i) const
  {
    return static_cast<ObstacleClass> (classes[i].label);
  }

  std::size_t
  count (ObstacleClass c) const
  {
    return static_cast<std::size_t> (
        std::count_if (classes.begin(), classes.end(), [c] (const pcl::Label& label) {
          return label.label == static_cast<std::uint32_t> (c);
        }));
  }
};

void
setInput (Detection& detection, const FloorScene& scene)
{
  detection.setCameraToBase (scene.camera_to_base);
  detection.setInputCloud (scene.cloud);
  detection.setInputNormals (scene.normals);
  detection.setInputPlanes (scene.planes, scene.labels);
}

Result
detect (const FloorScene& scene)
{
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  return result;
}

std::vector<Patch>
operator+ (std::vector<Patch> a, const std::vector<Patch>& b)
{
  a.insert (a.end(), b.begin(), b.end());
  return a;
}

const Eigen::Affine3f pose = cameraPose (0.8f, 0.45f);
const std::vector<Patch> only_floor{floorAt (0.f)};
const std::vector<Patch> a_box = box ({1.2f, -0.1f, 0.f}, {1.5f, 0.2f, 0.3f});
constexpr std::uint32_t box_front = 1; // of only_floor + a_box

/** The share of the points of these patches that are of a class. */
double
share (const FloorScene& scene,
       const Result& result,
       std::uint32_t first_patch,
       std::uint32_t last_patch,
       ObstacleClass c)
{
  std::size_t points = 0, of_class = 0;
  for (std::size_t i = 0; i < scene.labels->size(); ++i) {
    const std::uint32_t patch = (*scene.labels)[i].label;
    if (patch < first_patch || patch > last_patch)
      continue;
    ++points;
    of_class += result[i] == c;
  }
  EXPECT_GT (points, 0u);
  return static_cast<double> (of_class) / static_cast<double> (points);
}

float
kinectSigma (float z)
{
  return 0.001f + 0.002f * z * z;
}

} // namespace

TEST (ObstacleDetection, AnEmptyFloorIsSafe)
{
  const FloorScene scene (only_floor, pose);
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  EXPECT_TRUE (detection.isFloorFound());
  EXPECT_TRUE (result.obstacles.empty());
  EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.);
  EXPECT_EQ (result.classes.width, 160u);
  EXPECT_EQ (detection.getScan().ranges.size(), 361u);
  for (const float range : detection.getScan().ranges)
    EXPECT_TRUE (std::isinf (range));
}

TEST (ObstacleDetection, WhatSticksOutIsAnObstacle)
{
  for (const std::uint32_t width : {160u, 320u, 640u}) {
    const FloorScene scene (only_floor + a_box, pose, width);
    const Result result = detect (scene);
    ASSERT_EQ (result.obstacles.size(), 1u);
    const Obstacle& found = result.obstacles[0];
    EXPECT_EQ (found.kind, Obstacle::Kind::obstacle);
    EXPECT_TRUE (std::is_sorted (found.indices.begin(), found.indices.end()));
    for (const auto i : found.indices)
      EXPECT_EQ (result[static_cast<std::size_t> (i)], ObstacleClass::obstacle);
    EXPECT_EQ (found.indices.size(), result.count (ObstacleClass::obstacle));
    // All of the box but its lowest rows, nothing of the floor.
    EXPECT_GT (share (scene, result, 1, 6, ObstacleClass::obstacle), 0.9);
    EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.);
    EXPECT_NEAR (found.distance, 1.2f, 0.01f) << "the front, beside its centre";
    EXPECT_NEAR (found.direction, 0.f, 0.02f);
    EXPECT_NEAR (found.nearest.x(), 1.2f, 0.001f);
  }
}

TEST (ObstacleDetection, LowObstaclesInTheNoiseAreFound)
{
  // 1 cm high where depth has a standard deviation of 3.2 mm.
  const auto low_box = box ({0.7f, -0.08f, 0.f}, {0.82f, 0.08f, 0.01f});
  for (const std::uint32_t width : {160u, 320u, 640u}) {
    const FloorScene scene (only_floor + low_box, pose, width, kinectSigma);
    const Result result = detect (scene);
    EXPECT_GE (share (scene, result, 1, 6, ObstacleClass::obstacle), 0.5) << width;
    EXPECT_GE (share (scene, result, 0, 0, ObstacleClass::floor), 0.998) << width;
  }
}

TEST (ObstacleDetection, WhatDoesNotStickOutButIsTurnedIsAnObstacle)
{
  FloorScene scene (only_floor, pose, 320);
  const Eigen::Vector3f up (scene.planes[0].values.data());
  const Eigen::Vector3f turned =
      Eigen::AngleAxisf (0.9f, Eigen::Vector3f::UnitX()) * up;
  for (std::uint32_t v = 100; v < 140; ++v)
    for (std::uint32_t u = 100; u < 160; ++u) {
      (*scene.normals) (u, v).getNormalVector3fMap() = turned;
      (*scene.labels) (u, v).label = no_plane;
    }
  // Alone, such normals are noise.
  for (std::uint32_t v = 0; v < 60; v += 6)
    for (std::uint32_t u = 0; u < 60; u += 6)
      (*scene.normals) (u, v).getNormalVector3fMap() = turned;
  const Result result = detect (scene);
  ASSERT_EQ (result.obstacles.size(), 1u);
  EXPECT_EQ (result.count (ObstacleClass::speck), 0u);
  EXPECT_GT (result.obstacles[0].indices.size(), 0.85 * 40 * 60);
  EXPECT_EQ (result.count (ObstacleClass::obstacle),
             result.obstacles[0].indices.size());
  for (const auto i : result.obstacles[0].indices) {
    EXPECT_TRUE (i / 320 >= 100 && i / 320 < 140) << i;
    EXPECT_TRUE (i % 320 >= 100 && i % 320 < 160) << i;
  }
}

TEST (ObstacleDetection, ARampIsAnObstacleFromItsToeOn)
{
  // 8 degrees, from x = 1 m on.
  const Patch ramp{Eigen::Vector3f (-0.139f, 0.f, 0.99f).normalized(),
                   {1.f, 0.f, 0.f},
                   [] (const Eigen::Vector3f& p) {
                     return p.z() >= 0.f && p.x() < 1.6f && std::abs (p.y()) < 0.4f;
                   }};
  const FloorScene scene ({floorAt (0.f), ramp}, pose, 320);
  const Result result = detect (scene);
  ASSERT_EQ (result.obstacles.size(), 1u);
  EXPECT_GT (share (scene, result, 1, 1, ObstacleClass::obstacle), 0.95);
  EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.);
  EXPECT_LT (result.obstacles[0].distance, 1.03f);
}

TEST (ObstacleDetection, APieceOfTheFloorThatTheErrorOfDepthBentIsFloor)
{
  const Eigen::Affine3f high = cameraPose (1.4f, 0.45f);
  Patch floor = floorAt (0.f);
  floor.covers = [] (const Eigen::Vector3f& p) { return p.y() < 0.5f; };
  // Rises by 2 degrees, to more than 4.5 standard deviations of height; falls by 2.6.
  for (const float slope : {0.035f, -0.045f}) {
    const Patch piece{Eigen::Vector3f (0.f, -slope, 1.f).normalized(),
                      {0.f, 0.5f, 0.f},
                      [] (const Eigen::Vector3f& p) { return p.y() > 0.7f; }};
    const FloorScene scene ({floor, piece}, high, 320, kinectSigma);
    const Result result = detect (scene);
    EXPECT_GT (share (scene, result, 1, 1, ObstacleClass::floor), 0.998) << slope;
  }
}

TEST (ObstacleDetection, OnlyLargePiecesOfTheFloorMayBeBentMuch)
{
  const Eigen::Affine3f high = cameraPose (1.4f, 0.45f);
  Patch floor = floorAt (0.f);
  floor.covers = [] (const Eigen::Vector3f& p) { return std::abs (p.y()) < 0.5f; };
  for (const bool is_large : {true, false}) {
    // 1.1 to 2.4 standard deviations of depth high.
    Patch piece = floorAt (0.035f);
    piece.covers = [is_large] (const Eigen::Vector3f& p) {
      return p.y() > 0.7f && p.x() > 2.f && p.x() < 3.5f && (is_large || p.y() < 1.f);
    };
    const FloorScene scene ({floor, piece}, high, 320);
    const Result result = detect (scene);
    const double share_of_floor = share (scene, result, 1, 1, ObstacleClass::floor);
    if (is_large)
      EXPECT_EQ (share_of_floor, 1.);
    else
      EXPECT_LT (share_of_floor, 0.1);
  }
}

TEST (ObstacleDetection, APieceOfTheFloorThatTheErrorOfDepthTiltedIsFloorWhereItIsLow)
{
  constexpr float edge = 0.8f;
  Patch floor = floorAt (0.f);
  floor.covers = [] (const Eigen::Vector3f& p) { return p.y() < edge; };
  // 9 degrees; the lower one ends 2.4 standard deviations of depth above the floor.
  for (const float width : {0.16f, 0.5f}) {
    const Patch piece{Eigen::Vector3f (0.f, -0.16f, 1.f).normalized(),
                      {0.f, edge, 0.f},
                      [width] (const Eigen::Vector3f& p) {
                        return p.y() >= edge && p.y() < edge + width && p.x() < 2.5f;
                      }};
    const FloorScene scene (
        {floor, piece}, cameraPose (1.05f, 0.35f), 320, kinectSigma);
    const Result result = detect (scene);
    EXPECT_GT (share (scene, result, 0, 0, ObstacleClass::floor), 0.99) << width;
    const double share_of_floor = share (scene, result, 1, 1, ObstacleClass::floor);
    if (width < 0.2f)
      EXPECT_GT (share_of_floor, 0.95);
    else
      EXPECT_LT (share_of_floor, 0.15);
  }
}

TEST (ObstacleDetection, LowObstaclesOnThePlaneOfAPieceOfTheFloorAreFound)
{
  const Eigen::Affine3f high = cameraPose (1.2f, 0.6f);
  Patch floor = floorAt (0.f), piece = floor;
  floor.covers = [] (const Eigen::Vector3f& p) { return p.x() < 3.f; };
  piece.covers = [] (const Eigen::Vector3f& p) { return p.x() > 3.2f; };
  const Patch top{Eigen::Vector3f::UnitZ(),
                  {0.f, 0.f, 0.025f}, // 4 standard deviations of depth
                  [] (const Eigen::Vector3f& p) {
                    return p.x() > 0.9f && p.x() < 1.1f && std::abs (p.y()) < 0.1f;
                  }};
  FloorScene scene ({floor, piece, top}, high, 320, kinectSigma);
  const FloorScene apart = scene;
  scene.labels.reset (new pcl::PointCloud<pcl::Label> (*apart.labels));
  for (auto& label : *scene.labels)
    if (label.label == 2u)
      label.label = 1u;
  scene.planes.resize (2);
  const Result result = detect (scene);
  EXPECT_GT (share (apart, result, 2, 2, ObstacleClass::obstacle), 0.8);
  EXPECT_GT (share (apart, result, 0, 1, ObstacleClass::floor), 0.998);
}

TEST (ObstacleDetection, ASlopeAcrossTheHeightOfTheFloorIsNoFloor)
{
  // 17 degrees, as far above z = 0 as below.
  const Patch slope{Eigen::Vector3f (-0.3f, 0.f, 1.f).normalized(),
                    {1.5f, 0.f, 0.f},
                    [] (const Eigen::Vector3f& p) { return std::abs (p.z()) < 0.1f; }};
  const FloorScene scene ({slope}, pose);
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  EXPECT_FALSE (detection.isFloorFound());
  detection.setFloorTolerances (0.35f, 0.1f);
  detection.detect (result.obstacles, result.classes);
  EXPECT_TRUE (detection.isFloorFound());
}

TEST (ObstacleDetection, ObstaclesHaveDistanceAndDirection)
{
  // Left of the robot, then right of it: their corners are nearest.
  for (const float side : {1.f, -1.f}) {
    const auto thing = box ({1.2f, std::min (0.3f * side, 0.5f * side), 0.f},
                            {1.5f, std::max (0.3f * side, 0.5f * side), 0.3f});
    const Result result = detect (FloorScene (only_floor + thing, pose, 320));
    ASSERT_EQ (result.obstacles.size(), 1u);
    EXPECT_NEAR (result.obstacles[0].distance, std::hypot (1.2f, 0.3f), 0.01f);
    EXPECT_NEAR (result.obstacles[0].direction, side * std::atan2 (0.3f, 1.2f), 0.01f);
  }
}

TEST (ObstacleDetection, AGapOfOnePixelDoesNotCutAnObstacle)
{
  const Result whole = detect (FloorScene (only_floor + a_box, pose));
  for (const bool is_column : {true, false}) {
    FloorScene scene (only_floor + a_box, pose);
    const auto& found = whole.obstacles.at (0).indices;
    const auto middle = static_cast<std::uint32_t> (found[found.size() / 2]);
    const std::uint32_t u = 80, v = middle / 160;
    for (std::uint32_t k = 0; k < (is_column ? scene.cloud->height : 160u); ++k)
      (is_column ? (*scene.cloud) (u, k) : (*scene.cloud) (k, v))
          .getVector3fMap()
          .setConstant (not_a_number);
    const Result result = detect (scene);
    EXPECT_EQ (result.obstacles.size(), 1u) << is_column;
    EXPECT_EQ (result[v * 160 + u], ObstacleClass::unmeasured);
  }
}

TEST (ObstacleDetection, ATableIsAnObstacleThoughHorizontal)
{
  const auto table = box ({1.f, -0.6f, 0.28f}, {1.8f, 0.6f, 0.3f});
  const FloorScene scene (only_floor + table, pose);
  const Result result = detect (scene);
  EXPECT_EQ (share (scene, result, 1, 6, ObstacleClass::obstacle), 1.);
}

/** Less than 1 m away, after Holz et al. 2011, figure 4. It has no plane of its own. */
TEST (ObstacleDetection, ALighterOnATableIsAnObstacle)
{
  const auto lighter = box ({0.74f, -0.04f, 0.f}, {0.765f, 0.04f, 0.012f});
  // To the robot's floor, the table is an obstacle; to the table, the lighter is.
  for (const float table_height : {0.f, 0.7f}) {
    FloorScene scene (only_floor + lighter, cameraPose (0.5f, 0.6f), 640, kinectSigma);
    scene.camera_to_base.pretranslate (Eigen::Vector3f (0.f, 0.f, table_height));
    pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    estimation.setInputCloud (scene.cloud);
    estimation.compute (*scene.normals);
    pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> segmentation;
    segmentation.setInputCloud (scene.cloud);
    segmentation.setInputNormals (scene.normals);
    std::vector<pcl::PointIndices> inliers;
    const auto patches = pcl::make_shared<pcl::PointCloud<pcl::Label>> (*scene.labels);
    segmentation.segment (scene.planes, inliers, *scene.labels);
    const Result result = detect (scene);
    *scene.labels = *patches;
    EXPECT_GE (share (scene, result, 1, 6, ObstacleClass::obstacle), 0.5);
    EXPECT_GE (
        share (scene,
               result,
               0,
               0,
               table_height > 0.f ? ObstacleClass::obstacle : ObstacleClass::floor),
        0.998);
  }
}

TEST (ObstacleDetection, AStepDownIsADropOffAtItsEdge)
{
  Patch near = floorAt (0.f);
  near.covers = [] (const Eigen::Vector3f& p) { return p.x() < 1.5f; };
  const FloorScene scene ({near, floorAt (-0.2f)}, pose, 320);
  const Result result = detect (scene);
  ASSERT_EQ (result.obstacles.size(), 1u);
  EXPECT_EQ (result.obstacles[0].kind, Obstacle::Kind::drop_off);
  EXPECT_EQ (share (scene, result, 1, 1, ObstacleClass::drop_off), 1.);
  EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.);
  EXPECT_NEAR (result.obstacles[0].distance, 1.5f, 0.02f);
  EXPECT_NEAR (result.obstacles[0].nearest.z(), 0.f, 1e-3f);
}

TEST (ObstacleDetection, AHoleInTheFloorIsADropOff)
{
  const auto is_hole = [] (const Eigen::Vector3f& p) {
    return p.x() > 1.2f && p.x() < 1.6f && std::abs (p.y()) < 0.2f;
  };
  Patch with_hole = floorAt (0.f);
  with_hole.covers = [is_hole] (const Eigen::Vector3f& p) { return !is_hole (p); };
  const FloorScene scene ({with_hole, floorAt (-0.3f)}, pose, 320);
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  ASSERT_EQ (result.obstacles.size(), 1u);
  EXPECT_EQ (result.obstacles[0].kind, Obstacle::Kind::drop_off);
  EXPECT_NEAR (result.obstacles[0].distance, 1.2f, 0.02f);
  const auto& scan = detection.getScan();
  EXPECT_NEAR (scan.ranges[180], 1.2f, 0.02f) << "straight ahead";
  EXPECT_TRUE (std::isinf (scan.ranges[230])) << "25 degrees left of it";
}

TEST (ObstacleDetection, ShallowDropsAreNone)
{
  Patch near = floorAt (0.f);
  near.covers = [] (const Eigen::Vector3f& p) { return p.x() < 1.f; };
  const FloorScene scene ({near, floorAt (-0.02f)}, pose);
  EXPECT_EQ (detect (scene).count (ObstacleClass::drop_off), 0u);
}

TEST (ObstacleDetection, SpecksAreNoObstacles)
{
  FloorScene scene (only_floor, pose, 320);
  std::vector<std::size_t> specks;
  for (std::uint32_t v = 50; v < 230; v += 30)
    for (std::uint32_t u = 20; u < 310; u += 30)
      for (const std::uint32_t k : {0u, 1u}) {
        specks.push_back (v * 320 + u + k);
        (*scene.cloud)[specks.back()].getVector3fMap() *= 0.7f;
      }
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  EXPECT_TRUE (result.obstacles.empty());
  EXPECT_EQ (result.count (ObstacleClass::speck), specks.size());
  for (const std::size_t i : specks)
    EXPECT_EQ (result[i], ObstacleClass::speck);
  for (const float range : detection.getScan().ranges)
    EXPECT_TRUE (std::isinf (range));

  detection.setMinClusterSize (2);
  detection.detect (result.obstacles, result.classes);
  EXPECT_EQ (result.obstacles.size(), specks.size() / 2);
}

TEST (ObstacleDetection, AnExcludedObjectIsNoObstacle)
{
  const FloorScene scene (only_floor + a_box, pose);
  auto object = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < scene.labels->size(); ++i)
    if ((*scene.labels)[i].label >= box_front && (*scene.labels)[i].label != no_plane)
      object->push_back (static_cast<pcl::index_t> (i));
  Detection detection;
  setInput (detection, scene);
  detection.setExcludedIndices (object);
  Result result;
  detection.detect (result.obstacles, result.classes);
  EXPECT_TRUE (result.obstacles.empty());
  EXPECT_EQ (result.count (ObstacleClass::excluded), object->size());
  EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.);

  detection.setExcludedIndices (nullptr);
  detection.detect (result.obstacles, result.classes);
  EXPECT_EQ (result.obstacles.size(), 1u);
}

TEST (ObstacleDetection, TheRimOfAnExcludedObjectIsExcludedWithIt)
{
  // Beside a box that touches it and stays, also where it touches the rim of the other.
  const auto other = box ({1.2f, 0.2f, 0.f}, {1.5f, 0.6f, 0.35f});
  for (const bool has_other : {false, true}) {
    const FloorScene scene (
        only_floor + a_box + (has_other ? other : std::vector<Patch>{}), pose, 320);
    const auto isOfObject = [&] (std::size_t i) {
      return (*scene.labels)[i].label - box_front < 6u;
    };
    auto object = pcl::make_shared<pcl::Indices>();
    std::size_t rim = 0;
    for (std::size_t i = 640; i < scene.labels->size() - 640; ++i)
      if (isOfObject (i)) {
        const bool is_inside = isOfObject (i - 1) && isOfObject (i + 1) &&
                               isOfObject (i - 640) && isOfObject (i + 640);
        rim += !is_inside;
        if (is_inside)
          object->push_back (static_cast<pcl::index_t> (i));
      }
    ASSERT_GT (rim, 100u);
    ASSERT_LT (4 * rim, object->size());
    Detection detection;
    setInput (detection, scene);
    detection.setExcludedIndices (object);
    Result result;
    detection.detect (result.obstacles, result.classes);
    ASSERT_EQ (result.obstacles.size(), has_other ? 1u : 0u);
    if (has_other) {
      EXPECT_GT (share (scene, result, 7, 12, ObstacleClass::obstacle), 0.9);
      EXPECT_EQ (result.count (ObstacleClass::excluded), object->size());
      EXPECT_EQ (result.count (ObstacleClass::obstacle),
                 result.obstacles[0].indices.size());
      continue;
    }
    EXPECT_EQ (result.count (ObstacleClass::obstacle), 0u);
    EXPECT_EQ (result.count (ObstacleClass::speck), 0u);
    EXPECT_GT (result.count (ObstacleClass::excluded), object->size() + rim / 2);
    for (const float range : detection.getScan().ranges)
      EXPECT_TRUE (std::isinf (range));
  }
}

TEST (ObstacleDetection, WithoutAFloorAllIsAnObstacle)
{
  // A wall; then a floor that the pose of the camera does not put at z = 0.
  const Patch wall{-Eigen::Vector3f::UnitX(), {1.5f, 0.f, 0.f}};
  FloorScene scene ({wall}, cameraPose (0.8f, 0.f));
  (*scene.cloud)[5].getVector3fMap().setConstant (not_a_number);
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  EXPECT_FALSE (detection.isFloorFound());
  EXPECT_EQ (result.count (ObstacleClass::obstacle), scene.cloud->size() - 1);
  EXPECT_EQ (result[5], ObstacleClass::unmeasured);
  ASSERT_EQ (result.obstacles.size(), 1u);
  EXPECT_NEAR (result.obstacles[0].distance, 1.5f, 0.01f);

  const FloorScene low (only_floor, pose);
  setInput (detection, low);
  detection.setCameraToBase (cameraPose (0.9f, 0.45f));
  detection.detect (result.obstacles, result.classes);
  EXPECT_FALSE (detection.isFloorFound());
  EXPECT_EQ (result.count (ObstacleClass::floor), 0u);
  detection.setFloorTolerances (0.17f, 0.2f);
  detection.detect (result.obstacles, result.classes);
  EXPECT_TRUE (detection.isFloorFound());
}

TEST (ObstacleDetection, ADropOffWhoseEdgeIsOutOfViewIsWhereRaysMeetZero)
{
  // The lowest rays of the image meet z = 0 at 1.21 m, and what is below it at 1.81 m.
  const auto on_it = box ({1.9f, 0.3f, -0.5f}, {2.2f, 0.7f, 0.2f});
  const FloorScene scene (
      std::vector<Patch>{floorAt (-0.5f)} + on_it, cameraPose (1.f, 0.262f), 320);
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  EXPECT_FALSE (detection.isFloorFound());
  EXPECT_EQ (detection.getFloor(), Eigen::Vector4f::Zero());
  EXPECT_EQ (result.count (ObstacleClass::floor), 0u);
  EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::drop_off), 1.);
  for (std::size_t i = 0; i < scene.cloud->size(); ++i)
    if (scene.inBase (i).z() > 0.f) {
      EXPECT_EQ (result[i], ObstacleClass::obstacle) << i;
    }
  ASSERT_GE (result.obstacles.size(), 2u);
  EXPECT_EQ (result.obstacles[0].kind, Obstacle::Kind::drop_off);
  EXPECT_NEAR (result.obstacles[0].distance, 1.21f, 0.01f);
  EXPECT_NEAR (result.obstacles[0].nearest.z(), 0.f, 1e-3f);
  EXPECT_NEAR (detection.getScan().ranges[180], 1.21f, 0.01f) << "straight ahead";

  // z = 0 of the default pose is the height of the camera, and tells nothing.
  detection.setCameraToBase (Detection().getCameraToBase());
  detection.detect (result.obstacles, result.classes);
  EXPECT_EQ (result.count (ObstacleClass::drop_off), 0u);
}

TEST (ObstacleDetection, TheCameraMayBeTiltedAndItsPoseSlightlyOff)
{
  for (const float pitch : {0.2f, 0.6f})
    for (const float roll : {-0.3f, 0.2f}) {
      const FloorScene scene (only_floor + a_box, cameraPose (0.8f, pitch, roll), 320);
      Detection detection;
      setInput (detection, scene);
      detection.setCameraToBase (cameraPose (0.82f, pitch + 0.01f, roll - 0.01f));
      Result result;
      detection.detect (result.obstacles, result.classes);
      ASSERT_EQ (result.obstacles.size(), 1u);
      EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.);
      EXPECT_NEAR (result.obstacles[0].distance, 1.2f, 0.03f);
    }
}

TEST (ObstacleDetection, AFloorIsFoundWithAnyTiltThatIsTolerated)
{
  const FloorScene scene (only_floor, pose, 320);
  for (const float off : {-0.15f, -0.05f, 0.05f, 0.15f}) {
    Detection detection;
    setInput (detection, scene);
    detection.setCameraToBase (cameraPose (0.8f, 0.45f + off));
    Result result;
    detection.detect (result.obstacles, result.classes);
    EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.) << off;
  }
}

TEST (ObstacleDetection, TheFloorIsNearZeroAlsoWhereMoreIsALittleHigherOrLower)
{
  constexpr float edge = 1.2f;
  for (const float step : {-0.045f, -0.03f, 0.03f, 0.045f}) {
    Patch near = floorAt (0.f), far = floorAt (step);
    near.covers = [] (const Eigen::Vector3f& p) { return p.x() < edge; };
    far.covers = [] (const Eigen::Vector3f& p) { return p.x() >= edge; };
    const FloorScene scene ({near, far}, pose, 320);
    const auto of_far = static_cast<std::size_t> (
        std::count_if (scene.labels->begin(), scene.labels->end(), [] (const auto& l) {
          return l.label == 1;
        }));
    ASSERT_GT (of_far, scene.labels->size() / 2);
    const Result result = detect (scene);
    EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.) << step;
  }
}

TEST (ObstacleDetection, TheFloorIsFoundInImagesOfFewRows)
{
  static constexpr std::uint32_t rows = 6; // of 768
  FloorScene scene (only_floor, pose, 1024);
  const auto takeRows = [] (auto& cloud) {
    auto wide = pcl::make_shared<std::decay_t<decltype (*cloud)>> (cloud->width, rows);
    for (std::uint32_t v = 0; v < rows; ++v)
      std::copy_n (
          &(*cloud) (0, v * cloud->height / rows), cloud->width, &(*wide) (0, v));
    cloud = wide;
  };
  takeRows (scene.cloud);
  takeRows (scene.normals);
  takeRows (scene.labels);
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  EXPECT_TRUE (detection.isFloorFound());
  EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.);
}

TEST (ObstacleDetection, TheFloorIsNearTheRobotWhereALowPlatformFillsTheView)
{
  constexpr float edge = 0.9f;
  for (const float step : {-0.03f, 0.02f, 0.03f}) {
    Patch near = floorAt (0.f), far = floorAt (step);
    near.covers = [] (const Eigen::Vector3f& p) { return p.x() < edge; };
    far.covers = [] (const Eigen::Vector3f& p) { return p.x() >= edge; };
    const FloorScene scene ({near, far}, cameraPose (1.f, 0.61f), 320);
    const Eigen::Vector4f floor (scene.planes[0].values.data());
    // The pose is right; it is 1 cm too high; its pitch is off.
    for (const Eigen::Affine3f& to_base :
         {cameraPose (1.f, 0.61f), cameraPose (1.01f, 0.61f), cameraPose (1.f, 0.6f)}) {
      Detection detection;
      setInput (detection, scene);
      detection.setCameraToBase (to_base);
      Result result;
      detection.detect (result.obstacles, result.classes);
      EXPECT_TRUE (detection.getFloor().isApprox (floor)) << step;
      EXPECT_EQ (share (scene, result, 0, 0, ObstacleClass::floor), 1.) << step;
    }
  }
}

TEST (ObstacleDetection, AnotherLevelThatIsClearNearTheRobotIsNoFloorFurtherAway)
{
  constexpr float edge = 1.2f;
  const float pitch = 0.7f;
  // Where the levels begin, three standard deviations of depth are 2.1 cm, and 15 cm at 5 m.
  for (const float step : {-0.04f, 0.03f}) {
    Patch near = floorAt (0.f), far = floorAt (step);
    near.covers = [] (const Eigen::Vector3f& p) { return p.x() < edge; };
    far.covers = [] (const Eigen::Vector3f& p) { return p.x() >= edge; };
    const auto other = step < 0.f ? ObstacleClass::drop_off : ObstacleClass::obstacle;
    for (const std::uint32_t width : {160u, 320u, 640u}) {
      const FloorScene scene (
          {near, far}, cameraPose (1.3f, pitch), width, kinectSigma);
      const Result result = detect (scene);
      EXPECT_GT (share (scene, result, 1, 1, other), 0.99) << step << ", " << width;
      EXPECT_GT (share (scene, result, 0, 0, ObstacleClass::floor), 0.998) << step;
      ASSERT_EQ (result.obstacles.size(), 1u) << step << ", " << width;
      EXPECT_NEAR (result.obstacles[0].distance, edge, 0.03f);
    }
  }
}

TEST (ObstacleDetection, AStepOfThreeStandardDeviationsOfDepthAcrossTheViewIsNoFloor)
{
  constexpr float edge = 2.f;
  for (const float step : {-0.044f, -0.036f, 0.036f, 0.044f}) {
    Patch near = floorAt (0.f), far = floorAt (step);
    near.covers = [] (const Eigen::Vector3f& p) { return p.x() < edge; };
    far.covers = [] (const Eigen::Vector3f& p) { return p.x() >= edge; };
    const auto other = step < 0.f ? ObstacleClass::drop_off : ObstacleClass::obstacle;
    for (const std::uint32_t width : {160u, 320u, 640u}) {
      const FloorScene scene ({near, far}, cameraPose (1.f, 0.44f), width, kinectSigma);
      const Result result = detect (scene);
      EXPECT_GT (share (scene, result, 1, 1, other), 0.99) << step << ", " << width;
      EXPECT_GT (share (scene, result, 0, 0, ObstacleClass::floor), 0.998) << step;
    }
  }
}

TEST (ObstacleDetection, ObstaclesAreSeparateWhereDepthJumpsAndComeByDistance)
{
  const auto behind = box ({2.5f, -0.3f, 0.f}, {2.7f, 0.6f, 1.f});
  const FloorScene scene (only_floor + behind + a_box, pose, 320);
  const Result result = detect (scene);
  ASSERT_EQ (result.obstacles.size(), 2u);
  EXPECT_NEAR (result.obstacles[0].distance, 1.2f, 0.01f);
  EXPECT_NEAR (result.obstacles[1].distance, 2.5f, 0.02f);
}

TEST (ObstacleDetection, TheScanHasTheClosestPointOfEachDirection)
{
  const auto things = a_box + box ({2.f, 0.3f, 0.f}, {2.5f, 0.7f, 0.5f}) +
                      box ({0.8f, -1.f, 1.1f}, {3.f, 1.f, 1.2f});
  const FloorScene scene (only_floor + things, cameraPose (0.8f, 0.2f), 320);
  Detection detection;
  setInput (detection, scene);
  // The robot's own frame may be turned against its camera.
  for (const float turn : {0.f, 1.5f, 3.1f}) {
    const Eigen::Affine3f to_base =
        Eigen::AngleAxisf (turn, Eigen::Vector3f::UnitZ()) * scene.camera_to_base;
    detection.setCameraToBase (to_base);
    pcl::rgbd_planes::ScanLimits limits;
    limits.angle_min = -2.f;
    limits.angle_max = 3.5f;
    limits.angle_increment = 0.02f;
    limits.range_min = 1.25f;
    limits.range_max = 2.2f;
    limits.max_height = 1.f;
    detection.setScanLimits (limits);
    Result result;
    detection.detect (result.obstacles, result.classes);

    std::vector<float> expected (276, std::numeric_limits<float>::infinity());
    for (const auto& obstacle : result.obstacles)
      for (const auto i : obstacle.indices) {
        const Eigen::Vector3f p =
            to_base * (*scene.cloud)[static_cast<std::size_t> (i)].getVector3fMap();
        const float range = std::hypot (p.x(), p.y());
        double angle = std::atan2 (p.y(), p.x()) + 2.;
        if (angle < -0.01)
          angle += 2. * M_PI;
        const auto step = static_cast<std::size_t> (std::lround (angle / 0.02));
        if (range <= 2.2f && p.z() <= 1.f && step < expected.size())
          expected[step] = std::min (expected[step], range);
      }
    for (float& range : expected)
      if (range < 1.25f)
        range = -std::numeric_limits<float>::infinity();
    EXPECT_TRUE (std::isinf (*std::min_element (expected.begin(), expected.end())));
    const auto& scan = detection.getScan();
    EXPECT_FLOAT_EQ (scan.angle_min, -2.f);
    EXPECT_FLOAT_EQ (scan.angle_max, 3.5f);
    ASSERT_EQ (scan.ranges.size(), expected.size());
    EXPECT_GT (std::count_if (expected.begin(),
                              expected.end(),
                              [] (float range) { return std::isfinite (range); }),
               5);
    std::size_t different = 0;
    for (std::size_t k = 0; k < expected.size(); ++k)
      different += !(expected[k] == scan.ranges[k] ||
                     std::abs (expected[k] - scan.ranges[k]) < 1e-4f);
    EXPECT_LE (different, 2u) << "points that rounding puts on the other side";
  }
}

TEST (ObstacleDetection, TheScanOfAnObstacleHasNoGapsWherePixelsAreWiderThanItsSteps)
{
  // Two sills with a gap between them, 5 degrees wide.
  const auto sills = box ({1.f, -3.f, 0.f}, {1.05f, 0.f, 0.06f}) +
                     box ({1.f, 0.09f, 0.f}, {1.05f, 3.f, 0.06f});
  const FloorScene scene (only_floor + sills, cameraPose (1.f, 0.8f), 160);
  constexpr auto turn = static_cast<float> (2. * M_PI);
  Detection detection;
  setInput (detection, scene);
  // Ahead; behind, where the first direction follows on the last one.
  for (const float yaw : {0.f, turn / 2.f}) {
    detection.setCameraToBase (Eigen::AngleAxisf (yaw, Eigen::Vector3f::UnitZ()) *
                               scene.camera_to_base);
    pcl::rgbd_planes::ScanLimits limits;
    limits.angle_increment = turn / 3600.f;
    limits.angle_min = -turn / 2.f;
    limits.angle_max = turn / 2.f - limits.angle_increment;
    detection.setScanLimits (limits);
    std::vector<Obstacle> obstacles;
    detection.detect (obstacles);
    const auto& ranges = detection.getScan().ranges;
    ASSERT_EQ (ranges.size(), 3600u);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const float angle =
          limits.angle_min + static_cast<float> (i) * limits.angle_increment - yaw;
      const float x = std::cos (angle), y = std::sin (angle) / x;
      if (x > 0.f && ((y > -0.5f && y < -0.01f) || (y > 0.1f && y < 0.5f))) {
        EXPECT_NEAR (ranges[i] * x, 1.f, 0.02f) << angle << ", " << yaw;
      }
      if (x > 0.f && y > 0.01f && y < 0.08f) {
        EXPECT_TRUE (std::isinf (ranges[i])) << angle << ", " << yaw;
      }
    }
  }
}

TEST (ObstacleDetection, TheScanOfAWallHasNoGapsWhoseEndsAreOutOfRange)
{
  // What is in range lies between two columns that are 64 apart.
  Eigen::Affine3f turned = cameraPose (1.5f, 0.f);
  turned.prerotate (Eigen::AngleAxisf (0.105f, Eigen::Vector3f::UnitZ()));
  const auto wall = box ({2.f, -4.f, 0.f}, {2.1f, 4.f, 4.f});
  const FloorScene scene (only_floor + wall, turned);
  Detection detection;
  setInput (detection, scene);
  pcl::rgbd_planes::ScanLimits limits;
  limits.angle_increment = 0.002f;
  limits.range_max = 2.f / std::cos (0.13f);
  detection.setScanLimits (limits);
  std::vector<Obstacle> obstacles;
  detection.detect (obstacles);
  const auto& ranges = detection.getScan().ranges;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const float angle =
        limits.angle_min + static_cast<float> (i) * limits.angle_increment;
    if (std::abs (angle) < 0.12f) {
      EXPECT_NEAR (ranges[i] * std::cos (angle), 2.f, 0.01f) << angle;
    }
  }
}

TEST (ObstacleDetection, TheScanHasWhatIsKnownLateToBeNoSpeck)
{
  const FloorScene scene (only_floor + a_box, pose, 320);
  Detection detection;
  setInput (detection, scene);
  std::vector<Obstacle> expected, found;
  detection.detect (expected);
  ASSERT_EQ (expected.size(), 1u);
  const std::vector<float> ranges = detection.getScan().ranges;
  // Its last row tells that it is large enough.
  detection.setMinClusterSize (static_cast<unsigned> (expected[0].indices.size()));
  detection.detect (found);
  ASSERT_EQ (found.size(), 1u);
  EXPECT_EQ (found[0].nearest, expected[0].nearest);
  EXPECT_EQ (detection.getScan().ranges, ranges);
}

TEST (ObstacleDetection, TheScanDoesNotDependOnFramesBefore)
{
  Detection reused;
  std::vector<Obstacle> obstacles;
  for (int k = 0; k < 6; ++k) {
    const float x = 1.f + 0.1f * static_cast<float> (k / 2);
    const auto sill = box ({x, -3.f, 0.f}, {x + 0.05f, 3.f, 0.06f});
    const FloorScene scene (
        only_floor + sill, cameraPose (0.1f, 0.f), 160, kinectSigma);
    setInput (reused, scene);
    reused.detect (obstacles);
    Detection fresh;
    setInput (fresh, scene);
    fresh.detect (obstacles);
    EXPECT_EQ (reused.getScan().ranges, fresh.getScan().ranges) << "frame " << k;
  }
}

TEST (ObstacleDetection, AScanOfAlmostAWholeTurnHasEachDirectionOnce)
{
  // 720 steps of half a degree make a turn; these limits are 719.6 steps apart.
  pcl::rgbd_planes::ScanLimits limits;
  limits.angle_min = -3.14f;
  limits.angle_max = 3.14f;
  const FloorScene scene (only_floor + a_box, pose, 320);
  Detection detection;
  setInput (detection, scene);
  detection.setScanLimits (limits);
  std::vector<Obstacle> obstacles;
  // The box behind the robot: it lies across the first and the last direction.
  detection.setCameraToBase (
      Eigen::AngleAxisf (static_cast<float> (M_PI), Eigen::Vector3f::UnitZ()) *
      scene.camera_to_base);
  detection.detect (obstacles);
  const auto& ranges = detection.getScan().ranges;
  ASSERT_EQ (ranges.size(), 720u);
  EXPECT_TRUE (std::isfinite (ranges.front()));
  EXPECT_TRUE (std::isfinite (ranges.back()));
}

TEST (ObstacleDetection, AScanInStepsOfMoreThanATurnHasOneDirection)
{
  pcl::rgbd_planes::ScanLimits limits;
  limits.angle_increment = 10.f;
  Detection detection;
  detection.setScanLimits (limits);
  const FloorScene scene (only_floor + a_box, pose);
  setInput (detection, scene);
  std::vector<Obstacle> obstacles;
  detection.detect (obstacles);
  EXPECT_EQ (detection.getScan().ranges.size(), 1u);
  EXPECT_EQ (detection.getScan().angle_max, limits.angle_min);
}

TEST (ObstacleDetection, MissingPointsAreUnmeasured)
{
  FloorScene scene (only_floor + a_box, pose);
  for (std::size_t i = 0; i < scene.cloud->size(); i += 3)
    (*scene.cloud)[i].getVector3fMap().setConstant (i % 2 ? not_a_number : 0.f);
  (*scene.cloud)[1].x = std::numeric_limits<float>::infinity();
  for (auto& normal : *scene.normals)
    normal.getNormalVector3fMap().setConstant (not_a_number);
  const Result result = detect (scene);
  for (std::size_t i = 0; i < scene.cloud->size(); i += 3)
    EXPECT_EQ (result[i], ObstacleClass::unmeasured);
  EXPECT_EQ (result[1], ObstacleClass::unmeasured);
  EXPECT_GT (result.count (ObstacleClass::floor), scene.cloud->size() / 4);
  EXPECT_FALSE (result.obstacles.empty());

  for (auto& point : *scene.cloud)
    point.getVector3fMap().setConstant (not_a_number);
  const Result nothing = detect (scene);
  EXPECT_TRUE (nothing.obstacles.empty());
  EXPECT_EQ (nothing.count (ObstacleClass::unmeasured), scene.cloud->size());
}

TEST (ObstacleDetection, PointsBeyondTheRangeOfTheSensorAreUnmeasured)
{
  const auto behind = box ({2.5f, -0.3f, 0.f}, {2.7f, 0.6f, 1.f});
  for (const bool has_floor : {true, false}) {
    const FloorScene scene (only_floor + a_box + behind, pose);
    Detection detection;
    setInput (detection, scene);
    detection.setDepthNoise ({0.001f, 0.002f, 2.f});
    if (!has_floor)
      detection.setCameraToBase (cameraPose (5.f, 0.45f));
    Result result;
    detection.detect (result.obstacles, result.classes);
    EXPECT_EQ (detection.isFloorFound(), has_floor);
    for (std::size_t i = 0; i < scene.cloud->size(); ++i)
      EXPECT_EQ (result[i] != ObstacleClass::unmeasured,
                 (*scene.cloud)[i].getVector3fMap().norm() <= 2.f)
          << i;
  }
}

TEST (ObstacleDetection, WithIndicesOnlyThesePointsAreLookedAt)
{
  const FloorScene scene (only_floor + a_box, pose);
  auto left = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < scene.cloud->size(); ++i)
    if (i % 160 < 80)
      left->push_back (static_cast<pcl::index_t> (i));
  const Result all = detect (scene);
  Detection detection;
  setInput (detection, scene);
  detection.setIndices (left);
  Result half;
  detection.detect (half.obstacles, half.classes);
  for (std::size_t i = 0; i < scene.cloud->size(); ++i)
    EXPECT_EQ (half[i], i % 160 < 80 ? all[i] : ObstacleClass::unmeasured) << i;

  detection.setIndices (pcl::IndicesPtr()); // the whole cloud again
  detection.detect (half.obstacles, half.classes);
  for (std::size_t i = 0; i < scene.cloud->size(); ++i)
    EXPECT_EQ (half[i], all[i]) << i;
}

TEST (ObstacleDetection, AnyImageSizeWorksAndObjectsCanBeReused)
{
  Detection detection;
  Result result;
  for (const std::uint32_t width : {320u, 3u, 4u, 161u, 333u}) {
    const FloorScene scene (only_floor + a_box, pose, width);
    setInput (detection, scene);
    detection.detect (result.obstacles, result.classes);
    EXPECT_EQ (result.classes.size(), scene.cloud->size());
    const Result fresh = detect (scene);
    ASSERT_EQ (result.obstacles.size(), fresh.obstacles.size());
    for (std::size_t i = 0; i < fresh.classes.size(); ++i)
      EXPECT_EQ (result[i], fresh[i]);
  }
}

TEST (ObstacleDetection, BadInputGivesEmptyOutput)
{
  const FloorScene scene (only_floor + a_box, pose);
  Detection detection;
  Result result;
  const auto expectRefused = [&] (const char* what) {
    result = detect (scene);
    EXPECT_FALSE (result.obstacles.empty());
    detection.detect (result.obstacles, result.classes);
    EXPECT_TRUE (result.obstacles.empty()) << what;
    EXPECT_TRUE (result.classes.empty()) << what;
    EXPECT_TRUE (detection.getScan().ranges.empty()) << what;
  };
  expectRefused ("no cloud");
  setInput (detection, scene);
  detection.setInputNormals (nullptr);
  expectRefused ("no normals");
  setInput (detection, scene);
  detection.setInputPlanes (scene.planes, nullptr);
  expectRefused ("no labels");
  setInput (detection, scene);
  auto line = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> (*scene.cloud);
  line->width = static_cast<std::uint32_t> (line->size());
  line->height = 1;
  detection.setInputCloud (line);
  expectRefused ("unorganized");
  setInput (detection, scene);
  detection.setExcludedIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{-1}));
  expectRefused ("an excluded index outside");
  detection.setExcludedIndices (nullptr);
  detection.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{1 << 20}));
  expectRefused ("an index outside");
}

TEST (ObstacleDetection, SettersRefuseWhatMakesNoSense)
{
  Detection detection;
  detection.setCameraToBase (pose);
  Eigen::Affine3f scaled = pose;
  scaled.linear() *= 2.f;
  detection.setCameraToBase (scaled);
  EXPECT_TRUE (detection.getCameraToBase().isApprox (pose));
  detection.setDepthNoise ({0.001f, not_a_number});
  EXPECT_EQ (detection.getDepthNoise().quadratic, 0.002f);
  for (const float increment : {0.f, -0.1f, not_a_number, 1e-9f}) {
    pcl::rgbd_planes::ScanLimits limits;
    limits.angle_increment = increment;
    detection.setScanLimits (limits);
    EXPECT_FLOAT_EQ (detection.getScanLimits().angle_increment, 0.0087266463f);
  }
  for (const float last : {-2.f, 5.f, not_a_number}) {
    pcl::rgbd_planes::ScanLimits limits;
    limits.angle_max = last; // less than the first one, more than a turn from it
    detection.setScanLimits (limits);
    EXPECT_FLOAT_EQ (detection.getScanLimits().angle_max, 1.5707963f);
  }
  for (float pcl::rgbd_planes::ScanLimits::*limit :
       {&pcl::rgbd_planes::ScanLimits::range_min,
        &pcl::rgbd_planes::ScanLimits::range_max,
        &pcl::rgbd_planes::ScanLimits::max_height}) {
    pcl::rgbd_planes::ScanLimits limits;
    limits.*limit = not_a_number;
    detection.setScanLimits (limits);
    EXPECT_FALSE (std::isnan (detection.getScanLimits().*limit));
  }
  for (const auto& [nearest, farthest] : {std::pair (-0.5f, 2.f), {-3.f, -2.f}}) {
    pcl::rgbd_planes::ScanLimits limits;
    limits.range_min = nearest;
    limits.range_max = farthest;
    detection.setScanLimits (limits);
    EXPECT_EQ (detection.getScanLimits().range_min, 0.f);
    EXPECT_EQ (detection.getScanLimits().range_max, 10.f);
  }
  for (const float wrong : {-1.f, not_a_number}) {
    detection.setFloorTolerances (wrong, wrong);
    detection.setMinObstacleHeight (wrong);
    detection.setMinDropDepth (wrong);
  }
  EXPECT_EQ (detection.getFloorAngleTolerance(), 0.17f);
  EXPECT_EQ (detection.getFloorHeightTolerance(), 0.05f);
  EXPECT_EQ (detection.getMinObstacleHeight(), 0.01f);
  EXPECT_EQ (detection.getMinDropDepth(), 0.03f);
  constexpr auto right_angle = static_cast<float> (M_PI / 2.);
  detection.setFloorTolerances (right_angle, 0.06f);
  EXPECT_EQ (detection.getFloorAngleTolerance(), right_angle);
  EXPECT_EQ (detection.getFloorHeightTolerance(), 0.06f);
  detection.setFloorTolerances (1.6f, 0.f); // ceilings, and no floor at all
  EXPECT_EQ (detection.getFloorAngleTolerance(), right_angle);
  EXPECT_EQ (detection.getFloorHeightTolerance(), 0.06f);
}

TEST (ObstacleDetection, HeightsOfObstaclesAndDepthsOfDropsAreSettings)
{
  const FloorScene low (only_floor + box ({1.2f, -0.3f, 0.f}, {1.5f, 0.3f, 0.03f}),
                        pose);
  Detection detection;
  Result result;
  setInput (detection, low);
  detection.detect (result.obstacles, result.classes);
  const std::size_t before = result.count (ObstacleClass::obstacle);
  detection.setMinObstacleHeight (0.05f);
  detection.detect (result.obstacles, result.classes);
  EXPECT_LT (result.count (ObstacleClass::obstacle), before);
  detection.setMinObstacleHeight (0.1f);
  detection.detect (result.obstacles, result.classes);
  constexpr std::uint32_t box_top = 6;
  EXPECT_EQ (share (low, result, box_top, box_top, ObstacleClass::floor), 1.);
  EXPECT_GT (share (low, result, box_front, box_front, ObstacleClass::obstacle), 0.9)
      << "may be the foot of something";

  Patch near = floorAt (0.f);
  near.covers = [] (const Eigen::Vector3f& p) { return p.x() < 1.5f; };
  const FloorScene step ({near, floorAt (-0.2f)}, pose);
  setInput (detection, step);
  detection.detect (result.obstacles, result.classes);
  EXPECT_GT (result.count (ObstacleClass::drop_off), 0u);
  detection.setMinDropDepth (0.3f);
  detection.detect (result.obstacles, result.classes);
  EXPECT_EQ (result.count (ObstacleClass::drop_off), 0u);
}

TEST (ObstacleDetection, PlanesThatAreNoneDoNoHarm)
{
  FloorScene scene (only_floor + a_box, pose);
  pcl::ModelCoefficients none;
  for (const std::vector<float>& values :
       {std::vector<float>{},
        std::vector<float>{0.f, 0.f, 0.f, 0.f},
        std::vector<float>{1.f, 0.f, not_a_number, 0.f}}) {
    none.values = values;
    scene.planes.push_back (none);
  }
  // The floor with the other sign and another length is the same plane.
  for (auto& value : scene.planes[0].values)
    value *= -2.f;
  EXPECT_EQ (detect (scene).obstacles.size(), 1u);
}

TEST (ObstacleDetection, NoAllocationsForFramesLikeThoseBefore)
{
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "allocations are not counted together with the address sanitizer";
#endif
  const auto behind = box ({2.5f, -0.3f, 0.f}, {2.7f, 0.6f, 1.f});
  const FloorScene one (only_floor + behind + a_box, pose, 320);
  const FloorScene other (only_floor + a_box + behind, pose, 320);
  Detection detection;
  Result result;
  for (const bool first_round : {true, false})
    for (const FloorScene* scene : {&one, &other}) {
      setInput (detection, *scene);
      const std::size_t before = allocations;
      detection.detect (result.obstacles, result.classes);
      const std::size_t count = allocations - before;
      ASSERT_EQ (result.obstacles.size(), 2u);
      if (first_round && scene == &one) {
        EXPECT_GT (count, 0u) << "the counter sees nothing";
      }
      if (!first_round) {
        EXPECT_EQ (count, 0u);
      }
    }
}
