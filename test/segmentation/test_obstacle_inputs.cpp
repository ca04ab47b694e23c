// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "count_allocations.h"
#include "obstacle_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace obstacle_scenes;

TEST (ObstacleInputs, MissingPointsAreUnmeasured)
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

TEST (ObstacleInputs, PointsBeyondTheRangeOfTheSensorAreUnmeasured)
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

TEST (ObstacleInputs, WithIndicesOnlyThesePointsAreLookedAt)
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

TEST (ObstacleInputs, AnExcludedObjectIsNoObstacle)
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

TEST (ObstacleInputs, TheRimOfAnExcludedObjectIsExcludedWithIt)
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

TEST (ObstacleInputs, PlanesThatAreNoneDoNoHarm)
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

TEST (ObstacleInputs, APoseThatNobodyGaveIsToldOnceInARow)
{
  const FloorScene scene (only_floor + a_box, pose);
  Detection detection;
  std::vector<Obstacle> obstacles;
  const auto warningOf = [&] {
    testing::internal::CaptureStderr();
    detection.detect (obstacles);
    return testing::internal::GetCapturedStderr();
  };
  detection.setInputCloud (scene.cloud);
  detection.setInputNormals (scene.normals);
  detection.setInputPlanes (scene.planes, scene.labels);
  EXPECT_NE (warningOf().find ("setCameraToBase"), std::string::npos);
  EXPECT_EQ (warningOf(), "");
  // Where it was given, there may well be no floor in sight.
  detection.setCameraToBase (scene.camera_to_base);
  EXPECT_EQ (warningOf(), "");
  EXPECT_TRUE (detection.isFloorFound());
  detection.setCameraToBase (cameraPose (2.f, 0.61f));
  EXPECT_EQ (warningOf(), "");
  EXPECT_FALSE (detection.isFloorFound());
}

TEST (ObstacleInputs, NormalsWithoutUnitLengthAreToldOnceInARow)
{
  const FloorScene scene (only_floor + a_box, pose);
  Detection detection;
  std::vector<Obstacle> obstacles;
  const auto warningFor = [&] (float length) {
    auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>> (*scene.normals);
    for (auto& normal : *normals)
      normal.getNormalVector3fMap() *= length;
    setInput (detection, scene);
    detection.setInputNormals (normals);
    testing::internal::CaptureStderr();
    detection.detect (obstacles);
    return testing::internal::GetCapturedStderr();
  };
  for (const float length : {0.f, 0.9f, 100.f}) {
    EXPECT_NE (warningFor (length).find ("no normal has a length of 1"),
               std::string::npos)
        << length;
    EXPECT_EQ (warningFor (length), "");
    EXPECT_EQ (warningFor (1.f), "");
  }
  EXPECT_EQ (warningFor (not_a_number), "") << "there are none";
}

TEST (ObstacleInputs, AnyImageSizeWorksAndObjectsCanBeReused)
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

TEST (ObstacleInputs, NoAllocationsForFramesLikeThoseBefore)
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

TEST (ObstacleInputs, FramesMayHaveMoreNoiseThanIsNotSet)
{
  const auto noisy = [] (float z) { return 3.f * kinectSigma (z); };
  const FloorScene scene (only_floor, pose, 320, noisy);
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  EXPECT_TRUE (result.obstacles.empty());
  // Figures of one's own are taken as they are.
  detection.setDepthNoise (pcl::rgbd_planes::DepthNoise());
  detection.detect (result.obstacles, result.classes);
  EXPECT_FALSE (result.obstacles.empty());
}

TEST (ObstacleInputs, WhatIsExcludedWithoutDepthStaysUnmeasured)
{
  const FloorScene scene (only_floor, pose);
  const std::size_t measured = scene.cloud->size() - 1, missing = measured - 1;
  (*scene.cloud)[missing].x = not_a_number;
  Detection detection;
  setInput (detection, scene);
  detection.setExcludedIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{
      static_cast<pcl::index_t> (missing), static_cast<pcl::index_t> (measured)}));
  Result result;
  detection.detect (result.obstacles, result.classes);
  EXPECT_EQ (result[missing], ObstacleClass::unmeasured);
  EXPECT_EQ (result[measured], ObstacleClass::excluded);
}

TEST (ObstacleInputs, ClassesAreOrganizedInTheFrameOfTheCloud)
{
  const FloorScene scene (only_floor + a_box, pose);
  scene.cloud->header.frame_id = "camera";
  scene.cloud->header.stamp = 7;
  scene.cloud->sensor_origin_ = {0.1f, 0.f, 0.f, 0.f};
  scene.cloud->sensor_orientation_ = {0.f, 1.f, 0.f, 0.f};
  const auto classes = detect (scene).classes;
  EXPECT_EQ (classes.width, scene.cloud->width);
  EXPECT_EQ (classes.height, scene.cloud->height);
  EXPECT_EQ (classes.header.frame_id, "camera");
  EXPECT_EQ (classes.header.stamp, 7u);
  EXPECT_EQ (classes.sensor_origin_, scene.cloud->sensor_origin_);
  EXPECT_EQ (classes.sensor_orientation_.coeffs(),
             scene.cloud->sensor_orientation_.coeffs());
}

TEST (ObstacleInputs, BadInputLeavesNothingOfTheFrameBefore)
{
  const FloorScene scene (only_floor + a_box, pose);
  Detection detection;
  setInput (detection, scene);
  Result result;
  detection.detect (result.obstacles, result.classes);
  ASSERT_TRUE (detection.isFloorFound());
  detection.setInputNormals (nullptr);
  detection.detect (result.obstacles, result.classes);
  EXPECT_FALSE (detection.isFloorFound());
  EXPECT_EQ (detection.getFloor(), Eigen::Vector4f::Zero());
  EXPECT_TRUE (detection.getClasses().empty());
  EXPECT_TRUE (detection.getScan().ranges.empty());
}

TEST (ObstacleInputs, BadInputGivesEmptyOutput)
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
  auto other_normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>> (*scene.normals);
  std::swap (other_normals->width, other_normals->height);
  detection.setInputNormals (other_normals);
  expectRefused ("normals with columns for rows");
  setInput (detection, scene);
  auto other_labels = pcl::make_shared<pcl::PointCloud<pcl::Label>> (*scene.labels);
  std::swap (other_labels->width, other_labels->height);
  detection.setInputPlanes (scene.planes, other_labels);
  expectRefused ("labels with columns for rows");
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
