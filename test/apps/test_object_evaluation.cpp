// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/object_comparison.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

using namespace pcl::rgbd_planes;

namespace {

/** Objects 1, 2 and 3: 100 points each, in a row of their own, 1 m away. Between 1 and 2 are
 * 10 cm, between 2 and 3 1 cm; 100 more points are of no object. */
class ObjectEvaluationTest : public testing::Test {
protected:
  ObjectEvaluationTest()
  {
    const float rows[] = {0.f, 0.1f, 0.11f, 0.3f};
    for (std::uint32_t row = 0; row < 4; ++row)
      for (int i = 0; i < 100; ++i) {
        points_.insert (points_.end(),
                        {0.001f * static_cast<float> (i), rows[row], 1.f});
        truth_.ids.push_back (row < 3 ? row + 1 : 0);
      }
    for (int row = 0; row < 3; ++row)
      found_.push_back (
          {range (100 * row, 100 * row + 100), {0.05f, 0.04f, 0.03f}, true});
  }

  static pcl::Indices
  range (int first, int last)
  {
    pcl::Indices indices (static_cast<std::size_t> (last - first));
    std::iota (indices.begin(), indices.end(), first);
    return indices;
  }

  ObjectEvaluation
  evaluate () const
  {
    const OrganizedPoints points{points_.data(), 3, 100, 4};
    ObjectTruth truth = truth_;
    lookAtFullSize (points, points, truth);
    ObjectEvaluation evaluation;
    evaluation.add (points, points, truth, found_);
    return evaluation;
  }

  std::vector<float> points_;
  ObjectTruth truth_;
  std::vector<FoundObject> found_;
};

} // namespace

TEST_F (ObjectEvaluationTest, TruthItself)
{
  const ObjectEvaluation result = evaluate();
  EXPECT_EQ (result.apart.objects, 1u);
  EXPECT_EQ (result.touching.objects, 2u);
  EXPECT_EQ (result.all().found_50, 3u);
  EXPECT_EQ (result.all().found_80, 3u);
  EXPECT_EQ (result.false_objects, 0u);
  EXPECT_EQ (result.sized, 0u);
}

TEST_F (ObjectEvaluationTest, IntersectionOverUnion)
{
  found_[0].indices = range (0, 50); // exactly a half
  found_[1].indices = range (100, 180);
  found_[2].indices = range (200, 249);
  const ObjectEvaluation result = evaluate();
  EXPECT_EQ (result.apart.found_50, 1u);
  EXPECT_EQ (result.apart.found_80, 0u);
  EXPECT_EQ (result.touching.found_50, 1u);
  EXPECT_EQ (result.touching.found_80, 1u);
}

TEST_F (ObjectEvaluationTest, OneForOne)
{
  // Halves of one object; a merge of two.
  found_ = {{range (0, 50), {}, false},
            {range (50, 100), {}, false},
            {range (100, 300), {}, false}};
  const ObjectEvaluation result = evaluate();
  EXPECT_EQ (result.apart.found_50, 1u);
  EXPECT_EQ (result.touching.found_50, 1u);
}

TEST_F (ObjectEvaluationTest, ObjectsInPieces)
{
  // Three pieces of one object; a merge of two, half of which is of either.
  found_ = {{range (0, 33), {}, false},
            {range (33, 66), {}, false},
            {range (66, 100), {}, false},
            {range (100, 300), {}, false}};
  EXPECT_EQ (evaluate().apart.in_pieces, 1u);
  EXPECT_EQ (evaluate().touching.in_pieces, 0u);
  found_.emplace_back();
  found_.back().indices = range (299, 301); // half of it lies on no object
  EXPECT_EQ (evaluate().all().in_pieces, 2u);
  found_.back().indices = range (299, 302); // most of it does
  EXPECT_EQ (evaluate().all().in_pieces, 1u);
}

TEST_F (ObjectEvaluationTest, FalseObjects)
{
  found_[0].indices = range (251, 350); // 49 points on an object, 50 on none
  found_[1].indices = range (250, 350); // half of its points
  const ObjectEvaluation result = evaluate();
  EXPECT_EQ (result.false_objects, 1u);
  EXPECT_DOUBLE_EQ (result.falsePointsPercent(), 100. * 99 / 400);
}

TEST_F (ObjectEvaluationTest, ObjectsThatAreNotAskedFor)
{
  for (int i = 0; i < 51; ++i) // object 1 keeps 49 points, which are not false
    points_[static_cast<std::size_t> (3 * i)] = std::numeric_limits<float>::quiet_NaN();
  found_[0].indices = range (51, 100);
  for (int i = 200; i < 300; ++i) // object 3 is far
    points_[static_cast<std::size_t> (3 * i + 2)] = 3.6f;
  const ObjectEvaluation result = evaluate();
  EXPECT_EQ (result.all().objects, 1u);
  EXPECT_EQ (result.apart.found_80, 1u);
  EXPECT_EQ (result.false_objects, 0u);
}

TEST_F (ObjectEvaluationTest, LowAndHighObjectsAreNotAskedFor)
{
  truth_.objects = {{1, TrueObject::Shape::box, {0.1f, 0.1f, 0.009f}}};
  EXPECT_EQ (evaluate().apart.objects, 0u);
  truth_.objects[0].size.z() = 0.0101f;
  EXPECT_EQ (evaluate().apart.objects, 1u);
  truth_.objects[0].size.z() = 0.299f;
  EXPECT_EQ (evaluate().apart.objects, 1u);
  truth_.objects[0].size.z() = 0.31f;
  EXPECT_EQ (evaluate().apart.objects, 0u);
  EXPECT_EQ (evaluate().false_objects, 0u);
}

TEST_F (ObjectEvaluationTest, SizesAndGraspability)
{
  truth_.objects = {{1, TrueObject::Shape::box, {0.045f, 0.048f, 0.035f}}};
  ObjectEvaluation result = evaluate();
  EXPECT_EQ (result.sized, 1u);
  EXPECT_EQ (result.graspable_right, 1u);
  EXPECT_EQ (result.boxes, 1u);
  EXPECT_EQ (result.boxes_right, 1u);

  truth_.objects[0].size = {0.2f, 0.3f, 0.25f};
  EXPECT_EQ (evaluate().graspable_right, 0u);
  found_[0].size = {0.28f, 0.219f, 0.23f}; // in the other order, each within 10 %
  found_[0].graspable = false;
  result = evaluate();
  EXPECT_EQ (result.graspable_right, 1u);
  EXPECT_EQ (result.boxes_right, 1u);
  found_[0].size.z() = 0.224f;
  EXPECT_EQ (evaluate().boxes_right, 0u);
  truth_.objects[0].shape = TrueObject::Shape::cylinder;
  EXPECT_EQ (evaluate().boxes, 0u);
}

TEST_F (ObjectEvaluationTest, BoxesWhoseSidesAreSeen)
{
  // The points are a row along one of its sides, 5 cm above its foot.
  TrueObject box{1, TrueObject::Shape::box, {0.1f, 0.009f, 0.05f}};
  box.pose = Eigen::Translation3f (0.05f, 0.f, 0.95f);
  const auto count = [&] (const Eigen::Vector3f& size) {
    truth_.objects = {box};
    truth_.objects[0].size = size;
    return evaluate();
  };
  found_[0].size = {0.012f, 0.1f, 0.05f};
  EXPECT_EQ (count (box.size).boxes_seen, 1u);
  EXPECT_EQ (count (box.size).boxes_seen_right, 1u);
  EXPECT_EQ (count ({0.111f, 0.009f, 0.05f}).boxes_seen, 0u);
  EXPECT_EQ (count ({0.1f, 0.011f, 0.05f}).boxes_seen, 0u);
  EXPECT_EQ (count ({0.1f, 0.009f, 0.061f}).boxes_seen, 0u);
  EXPECT_EQ (count ({0.1f, 0.009f, 0.061f}).boxes, 1u);
  EXPECT_EQ (count ({0.1f, 0.009f, 0.061f}).boxes_seen_right, 0u);
  found_[0].size.z() = 0.07f;
  EXPECT_EQ (count (box.size).boxes_seen, 1u);
  EXPECT_EQ (count (box.size).boxes_seen_right, 0u);
  for (int i = 88; i < 100; ++i)
    points_[static_cast<std::size_t> (3 * i)] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ (count (box.size).boxes_seen, 0u);
  // Turned, the same side is another one.
  box.pose = box.pose * Eigen::AngleAxisf (0.5f * static_cast<float> (M_PI),
                                           Eigen::Vector3f::UnitZ());
  EXPECT_EQ (count ({0.009f, 0.09f, 0.05f}).boxes_seen, 1u);
}

// Two objects on pixels 4 mm apart, with a gap of 16 mm, keep 3 x 5 and 1 x 5 points of them,
// and a gap of 32 mm.
TEST (ObjectsOfSmallImages, FullSizeTellsWhatTouchesAndWhatIsAskedFor)
{
  Frame frame;
  frame.cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>> (20, 20);
  frame.labels.kind = PointLabels::Kind::objects;
  frame.labels.points.resize (20u, 20u);
  for (int v = 0; v < 20; ++v)
    for (int u = 0; u < 20; ++u) {
      (*frame.cloud) (u, v).getVector3fMap() << 0.004f * static_cast<float> (u),
          0.004f * static_cast<float> (v), 1.f;
      frame.labels.points (u, v).label = u < 10 ? 20 : u < 13 ? 1 : 30;
    }
  const ObjectTruth truth = objectTruth (frame);
  EXPECT_EQ (truth.touching, (std::set<std::uint32_t>{2, 3}));

  FoundObject left;
  for (int v = 0; v < 5; ++v)
    left.indices.insert (left.indices.end(), {5 * v, 5 * v + 1, 5 * v + 2});
  ObjectEvaluation evaluation;
  scoreObjects (frame, truth, 4, {left}, evaluation);
  EXPECT_EQ (evaluation.all().objects, 0u);
  EXPECT_EQ (evaluation.full_size_objects, 2u);
  EXPECT_EQ (evaluation.full_size_found, 1u);
}
