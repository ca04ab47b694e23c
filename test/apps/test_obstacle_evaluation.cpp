// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/obstacle_evaluation.h>
#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace pcl::rgbd_planes;

namespace {

/** A camera 1 m above the floor looks straight down on 40 x 30 pixels 1 cm apart. Two
 * things of 10 x 10 pixels stand on it: 2 cm high from column 0 on, 30 cm high from column
 * 20 on. */
class ObstacleEvaluationTest : public testing::Test {
protected:
  ObstacleEvaluationTest() : truth_ (40, 30)
  {
    camera_to_base_.matrix().row (2) << 0.f, 0.f, -1.f, 1.f;
    camera_to_base_.matrix().row (1) << -1.f, 0.f, 0.f, 0.f;
    camera_to_base_.matrix().row (0) << 0.f, -1.f, 0.f, 0.f;
    for (int v = 0; v < 30; ++v)
      for (int u = 0; u < 40; ++u) {
        auto& point = truth_ (u, v);
        point.getVector3fMap() << 0.01f * static_cast<float> (u),
            0.01f * static_cast<float> (v), 1.f;
        if (v < 10 && u < 10)
          addThing (point, 0.02f, 1);
        if (v < 10 && u >= 20 && u < 30)
          addThing (point, 0.3f, 2);
      }
    for (const auto& point : truth_)
      measured_.push_back ({point.x, point.y, point.z});
    measured_.width = 40;
    measured_.height = 30;
    for (const auto& point : truth_)
      classes_.push_back (point.obstacle ? ObstacleClass::obstacle
                                         : ObstacleClass::floor);
  }

  static void
  addThing (TruthPoint& point, float height, std::uint32_t object)
  {
    point.z -= height;
    point.object = object;
    point.obstacle = 1;
  }

  ObstacleEvaluation
  evaluate (const DepthNoise& noise = {}) const
  {
    const auto numbers = numberObstacles (truth_);
    ObstacleEvaluation evaluation (noise);
    evaluation.add ({viewPoints (measured_), truth_, numbers, camera_to_base_},
                    classes_);
    return evaluation;
  }

  pcl::PointCloud<TruthPoint> truth_;
  pcl::PointCloud<pcl::PointXYZ> measured_;
  std::vector<ObstacleClass> classes_;
  Eigen::Affine3f camera_to_base_ = Eigen::Affine3f::Identity();
};

} // namespace

TEST_F (ObstacleEvaluationTest, ThingsAndConnectedPartsAreObstacles)
{
  auto numbers = numberObstacles (truth_);
  EXPECT_EQ (numbers[0], 1u);
  EXPECT_EQ (numbers[20], 2u);
  EXPECT_EQ (numbers[15], 0u);
  // Another thing that touches the first, and a part of that behind a gap in depth.
  addThing (truth_ (10, 0), 0.02f, 3);
  truth_ (0, 9).z -= 0.2f;
  numbers = numberObstacles (truth_);
  EXPECT_NE (numbers[10], numbers[9]);
  EXPECT_NE (numbers[9 * 40], numbers[8 * 40]);
  EXPECT_EQ (*std::max_element (numbers.begin(), numbers.end()), 4u);
}

TEST_F (ObstacleEvaluationTest, AllFound)
{
  const ObstacleEvaluation result = evaluate();
  EXPECT_EQ (result.obstacles, 2u);
  EXPECT_EQ (result.found_obstacles, 2u);
  EXPECT_EQ (result.floor_points, 1000u);
  EXPECT_EQ (result.obstaclesPercent(), 100.);
  EXPECT_EQ (result.falsePointsPercent(), 0.);
}

TEST_F (ObstacleEvaluationTest, FoundMeansHalfOfTheMeasuredPoints)
{
  for (int v = 0; v < 10; ++v)
    for (int u = 0; u < 6; ++u)
      classes_[static_cast<std::size_t> (40 * v + u)] = ObstacleClass::floor;
  EXPECT_EQ (evaluate().found_obstacles, 1u);
  for (int v = 0; v < 10; ++v)
    for (int u = 0; u < 2; ++u)
      measured_ (u, v).z = std::nanf (""); // 4 of the 8 columns that are left
  EXPECT_EQ (evaluate().found_obstacles, 2u);
  for (int v = 0; v < 10; ++v)
    classes_[static_cast<std::size_t> (40 * v + 6)] = ObstacleClass::speck;
  EXPECT_EQ (evaluate().found_obstacles, 1u);
}

TEST_F (ObstacleEvaluationTest, LowAndTinyObstaclesAreNotAskedFor)
{
  // Three standard deviations at 1 m are 9 mm: 1 cm counts, 9.5 mm does not.
  const auto setHeight = [&] (float height) {
    for (int v = 0; v < 10; ++v)
      for (int u = 0; u < 10; ++u)
        truth_ (u, v).z = 1.f - height;
  };
  setHeight (0.01f);
  EXPECT_EQ (evaluate().obstacles, 2u);
  setHeight (0.0095f);
  EXPECT_EQ (evaluate().obstacles, 1u);
  for (std::size_t i = 0; i < measured_.size(); ++i)
    if (truth_[i].object == 2)
      measured_[i].z = std::nanf ("");
  EXPECT_EQ (evaluate().obstacles, 0u);
  EXPECT_TRUE (std::isnan (evaluate().obstaclesPercent()));
}

TEST_F (ObstacleEvaluationTest, FloorPointsThatMeasureSomethingElseDoNotCount)
{
  classes_[10] = classes_[11] = ObstacleClass::obstacle;
  classes_[12] = ObstacleClass::drop_off;
  classes_[13] = ObstacleClass::speck;
  measured_[11].z = 0.98f; // 2 cm are more than three standard deviations
  const ObstacleEvaluation result = evaluate();
  EXPECT_EQ (result.floor_points, 999u);
  EXPECT_EQ (result.false_points, 2u);
  EXPECT_NEAR (result.falsePointsPercent(), 200. / 999., 1e-9);
  EXPECT_EQ (result.all_floor_points, 1000u);
  EXPECT_EQ (result.all_false_points, 3u);
}

TEST_F (ObstacleEvaluationTest, WithoutFloorNothingIsAskedFor)
{
  for (auto& point : truth_)
    point.obstacle = 1;
  EXPECT_EQ (evaluate().obstacles, 0u);
}

TEST_F (ObstacleEvaluationTest, NoiseOfTheSensorDecidesWhatCounts)
{
  const DepthNoise noise{0.004f, 0.004f}; // three standard deviations at 1 m are 24 mm
  measured_[11].z = 0.98f;
  EXPECT_EQ (evaluate().obstacles, 2u);
  EXPECT_EQ (evaluate().floor_points, 999u);
  EXPECT_EQ (evaluate (noise).obstacles, 1u);
  EXPECT_EQ (evaluate (noise).floor_points, 1000u);
}

TEST_F (ObstacleEvaluationTest, FramesArePooled)
{
  const auto numbers = numberObstacles (truth_);
  ObstacleEvaluation evaluation;
  const ObstacleTruth frame{viewPoints (measured_), truth_, numbers, camera_to_base_};
  evaluation.add (frame, classes_);
  classes_.assign (classes_.size(), ObstacleClass::floor);
  evaluation.add (frame, classes_);
  EXPECT_EQ (evaluation.obstacles, 4u);
  EXPECT_EQ (evaluation.obstaclesPercent(), 50.);
  EXPECT_EQ (evaluation.floor_points, 2000u);
}
