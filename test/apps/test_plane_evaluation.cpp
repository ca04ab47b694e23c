// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/plane_evaluation.h>
#include <pcl/segmentation/impl/label_runs.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::rgbd_planes;

namespace {

/** Four walls side by side, each 10 x 10 pixels, at z = 1, 2, 3 and 4 m. */
class PlaneEvaluationTest : public testing::Test {
protected:
  PlaneEvaluationTest()
  {
    for (int k = 0; k < 4; ++k)
      truth_.coefficients.emplace_back (0.f, 0.f, -1.f, static_cast<float> (k + 1));
    for (int v = 0; v < 10; ++v)
      for (int u = 0; u < 40; ++u) {
        const auto k = static_cast<std::uint32_t> (u / 10);
        const float z = static_cast<float> (k + 1);
        points_.insert (
            points_.end(),
            {0.1f * static_cast<float> (u) * z, 0.1f * static_cast<float> (v) * z, z});
        truth_.labels.push_back (k);
      }
    found_ = truth_;
  }

  OrganizedPoints
  points () const
  {
    return {points_.data(), 3, 40, 10};
  }

  PlaneEvaluation
  evaluate (std::size_t min_points = 50) const
  {
    PlaneEvaluation evaluation;
    evaluation.add (points(), found_, truth_, min_points);
    return evaluation;
  }

  std::vector<float> points_;
  PlaneSet truth_, found_;
};

} // namespace

TEST_F (PlaneEvaluationTest, IdenticalLabelsAreAllCorrect)
{
  const PlaneEvaluation result = evaluate();
  EXPECT_EQ (result.planes_truth, 4u);
  EXPECT_EQ (result.planes_found, 4u);
  EXPECT_EQ (result.correct, 4u);
  EXPECT_EQ (result.over + result.under + result.missed + result.noise, 0u);
  EXPECT_DOUBLE_EQ (result.f1(), 1.);
  EXPECT_DOUBLE_EQ (result.meanIou(), 1.);
  EXPECT_DOUBLE_EQ (result.coveragePercent(), 100.);
  EXPECT_DOUBLE_EQ (result.offPercent(), 0.);
  EXPECT_NEAR (result.medianAngleDegrees(), 0., 1e-6);
  EXPECT_NEAR (result.medianDistanceMillimetres(), 0., 1e-3);
}

TEST_F (PlaneEvaluationTest, OrderDoesNotMatter)
{
  for (auto& label : found_.labels)
    label = 3 - label;
  std::reverse (found_.coefficients.begin(), found_.coefficients.end());
  EXPECT_EQ (evaluate().correct, 4u);
  EXPECT_DOUBLE_EQ (evaluate().offPercent(), 0.);
}

TEST_F (PlaneEvaluationTest, ASplitIsOverSegmented)
{
  found_.coefficients.push_back (found_.coefficients[1]);
  for (std::size_t i = 0; i < 200; ++i) // the upper half of the second wall
    if (found_.labels[i] == 1)
      found_.labels[i] = 4;
  const PlaneEvaluation result = evaluate();
  EXPECT_EQ (result.planes_found, 5u);
  EXPECT_EQ (result.correct, 3u);
  EXPECT_EQ (result.over, 1u);
  EXPECT_EQ (result.under + result.missed + result.noise, 0u);
  EXPECT_DOUBLE_EQ (result.meanIou(), (3. + 0.5) / 4.);
}

TEST_F (PlaneEvaluationTest, AMergeIsUnderSegmented)
{
  for (auto& label : found_.labels)
    if (label == 2)
      label = 1;
    else if (label == 3)
      label = 2;
  found_.coefficients.erase (found_.coefficients.begin() + 2);
  const PlaneEvaluation result = evaluate();
  EXPECT_EQ (result.planes_found, 3u);
  EXPECT_EQ (result.correct, 2u);
  EXPECT_EQ (result.under, 1u);
  EXPECT_EQ (result.over + result.missed + result.noise, 0u);
  EXPECT_DOUBLE_EQ (result.offPercent(), 25.) << "the third wall, 1 m from its plane";
}

TEST_F (PlaneEvaluationTest, AMissedPlaneAndAFalseOneAreCounted)
{
  for (auto& label : found_.labels)
    if (label == 0)
      label = unlabelled;
  PlaneEvaluation result = evaluate();
  EXPECT_EQ (result.missed, 1u);
  EXPECT_EQ (result.correct, 3u);
  EXPECT_DOUBLE_EQ (result.coveragePercent(), 75.);

  std::swap (truth_, found_); // now the first wall is found but not true
  result = evaluate();
  EXPECT_EQ (result.planes_truth, 3u);
  EXPECT_EQ (result.noise, 1u);
  EXPECT_EQ (result.correct, 3u);
  EXPECT_DOUBLE_EQ (result.f1(), 6. / 7.);
}

TEST_F (PlaneEvaluationTest, SmallTruePlanesAreNotAskedFor)
{
  // All of the first wall but 40 points is missing.
  for (std::size_t i = 0; i < truth_.labels.size(); ++i)
    if (truth_.labels[i] == 0 && i >= 160)
      points_[3 * i + 2] = std::nanf ("");
  const PlaneEvaluation result = evaluate (50);
  EXPECT_EQ (result.planes_truth, 3u);
  EXPECT_EQ (result.planes_found, 3u);
  EXPECT_EQ (result.correct, 3u);
  EXPECT_EQ (result.noise, 0u);
}

TEST_F (PlaneEvaluationTest, WhereThereIsNothingToFindNothingIsKnown)
{
  truth_.labels.assign (400, unlabelled);
  truth_.coefficients.clear();
  EXPECT_DOUBLE_EQ (evaluate().f1(), 0.) << "all that is found is false";
  EXPECT_TRUE (std::isnan (evaluate().meanIou()));
  found_ = truth_;
  EXPECT_TRUE (std::isnan (evaluate().f1()));
}

TEST_F (PlaneEvaluationTest, ErrorsOfPlanesAreMeasuredAtTheirCentroid)
{
  const float angle = static_cast<float> (7. * M_PI / 180.);
  for (std::size_t k = 0; k < 4; ++k) {
    const float z = static_cast<float> (k + 1);
    // Turned by 7 degrees about the centroid of the wall, then pushed back by 20 mm.
    const Eigen::Vector3f normal (std::sin (angle), 0.f, -std::cos (angle));
    const Eigen::Vector3f centroid (
        0.1f * (static_cast<float> (k) * 10.f + 4.5f) * z, 0.45f * z, z);
    found_.coefficients[k] = {
        normal.x(), normal.y(), normal.z(), -normal.dot (centroid) + 0.02f};
  }
  const PlaneEvaluation result = evaluate();
  EXPECT_NEAR (result.medianAngleDegrees(), 7., 1e-3);
  EXPECT_NEAR (result.medianDistanceMillimetres(), 20., 1e-2);
}

TEST_F (PlaneEvaluationTest, FramesArePooled)
{
  PlaneEvaluation both;
  both.add (points(), found_, truth_, 50);
  found_.labels.assign (400, unlabelled);
  found_.coefficients.clear();
  both.add (points(), found_, truth_, 50);
  EXPECT_EQ (both.planes_truth, 8u);
  EXPECT_EQ (both.missed, 4u);
  EXPECT_DOUBLE_EQ (both.coveragePercent(), 50.);
  EXPECT_DOUBLE_EQ (both.meanIou(), 0.5);
}

TEST_F (PlaneEvaluationTest, WithoutTruthOnlyCoverageAndOffAreKnown)
{
  PlaneEvaluation evaluation;
  evaluation.add (points(), found_);
  EXPECT_FALSE (evaluation.hasTruth());
  EXPECT_EQ (evaluation.planes_truth, 0u);
  EXPECT_EQ (evaluation.planes_found, 4u);
  EXPECT_DOUBLE_EQ (evaluation.coveragePercent(), 100.);
}
