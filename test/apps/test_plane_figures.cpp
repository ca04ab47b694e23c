// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/curved_points.h>
#include <pcl/apps/object_label_evaluation.h>
#include <pcl/apps/right_angles.h>
#include <pcl/segmentation/impl/label_runs.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace pcl::rgbd_planes;

namespace {

/** 20 columns and 10 rows of points at (1, 1, 1), and planes to be painted on them. */
class PlaneFigures : public testing::Test {
protected:
  PlaneFigures() : xyz_ (3 * 200, 1.f), labels_ (20, 10)
  {
    found_.labels.assign (200, unlabelled);
  }

  OrganizedPoints
  points () const
  {
    return {xyz_.data(), 3, 20, 10};
  }

  /** Points [\a begin, \a end) of all 200, row after row, are of a new plane. */
  void
  addPlane (std::size_t begin,
            std::size_t end,
            const Eigen::Vector3f& normal = {0.f, 0.f, -1.f})
  {
    std::fill (found_.labels.begin() + static_cast<std::ptrdiff_t> (begin),
               found_.labels.begin() + static_cast<std::ptrdiff_t> (end),
               static_cast<std::uint32_t> (found_.coefficients.size()));
    found_.coefficients.emplace_back (normal.x(), normal.y(), normal.z(), 1.f);
  }

  void
  setLabels (std::size_t begin, std::size_t end, std::uint32_t label)
  {
    for (std::size_t i = begin; i < end; ++i)
      labels_[i].label = label;
  }

  void
  setMissing (std::size_t i)
  {
    xyz_[3 * i] = std::numeric_limits<float>::quiet_NaN();
  }

  std::vector<float> xyz_;
  PlaneSet found_;
  pcl::PointCloud<pcl::Label> labels_;
};

Eigen::Vector3f
direction (float degrees_from_x_towards_y)
{
  const float angle = degrees_from_x_towards_y * static_cast<float> (M_PI) / 180.f;
  return {std::cos (angle), std::sin (angle), 0.f};
}

} // namespace

TEST_F (PlaneFigures, TheTableIsItsPartsAndTheBestPlane)
{
  setLabels (0, 60, 1);
  setLabels (60, 100, 9);
  setLabels (100, 140, 20);
  addPlane (140, 160); // where nothing is known
  addPlane (0, 30);    // 30 of 100
  addPlane (30, 120);  // 70 of the table and 20 of the object
  ObjectLabelEvaluation evaluation;
  evaluation.add (points(), found_, labels_);
  EXPECT_DOUBLE_EQ (evaluation.tableIou(), 70. / 120.);
  EXPECT_DOUBLE_EQ (evaluation.worstTableIou(), 70. / 120.);
  EXPECT_DOUBLE_EQ (evaluation.purityPercent(), 100. * (30. + 70.) / (30. + 90.));
}

TEST_F (PlaneFigures, MissingPointsAreNotOfTheTable)
{
  setLabels (0, 100, 1);
  addPlane (0, 90);
  for (std::size_t i = 85; i < 95; ++i) // 5 of both, 5 of the table alone
    setMissing (i);
  ObjectLabelEvaluation evaluation;
  evaluation.add (points(), found_, labels_);
  EXPECT_DOUBLE_EQ (evaluation.tableIou(), 85. / 90.);
}

TEST_F (PlaneFigures, TablesOfAllFramesAreAveragedAndTheWorstIsKept)
{
  setLabels (0, 100, 1);
  ObjectLabelEvaluation evaluation;
  evaluation.add (points(), found_, labels_); // no plane
  addPlane (0, 100);
  evaluation.add (points(), found_, labels_);
  evaluation.add (points(), found_, labels_);
  EXPECT_DOUBLE_EQ (evaluation.tableIou(), 2. / 3.);
  EXPECT_DOUBLE_EQ (evaluation.worstTableIou(), 0.);
}

TEST_F (PlaneFigures, PartsOfAnObjectAreOneAndObjectsAreNot)
{
  setLabels (0, 50, 20);
  setLabels (50, 100, 29);
  setLabels (100, 130, 30);
  addPlane (0, 130);
  ObjectLabelEvaluation evaluation;
  evaluation.add (points(), found_, labels_);
  EXPECT_DOUBLE_EQ (evaluation.purityPercent(), 100. * 100. / 130.);
  EXPECT_TRUE (std::isnan (evaluation.tableIou())) << "there is no table";
}

TEST_F (PlaneFigures, WithoutFramesThereAreNoFigures)
{
  EXPECT_TRUE (std::isnan (ObjectLabelEvaluation().tableIou()));
  EXPECT_TRUE (std::isnan (ObjectLabelEvaluation().worstTableIou()));
  EXPECT_TRUE (std::isnan (ObjectLabelEvaluation().purityPercent()));
  EXPECT_TRUE (std::isnan (CurvedPoints().labelledPercent()));
  EXPECT_TRUE (std::isnan (CurvedPoints().shatteredPercent()));
  EXPECT_TRUE (std::isnan (RightAngles().medianDegrees()));
  EXPECT_TRUE (std::isnan (RightAngles().pairsWithinPercent()));
  EXPECT_TRUE (std::isnan (RightAngles().framesWithinPercent()));
}

TEST_F (PlaneFigures, CurvedIsWhatIsSeenOnNoTruePlane)
{
  pcl::PointCloud<TruthPoint> truth (20, 10);
  for (std::size_t i = 0; i < 200; ++i) {
    truth[i].label = i < 100 ? 1 : 0; // a plane, then a sphere
    if (i >= 180)                     // then nothing
      truth[i].getVector3fMap().setConstant (std::nanf (""));
  }
  for (std::size_t i = 160; i < 180; ++i)
    setMissing (i);
  addPlane (0, 115);   // 15 of them on the sphere
  addPlane (130, 140); // all of them
  addPlane (170, 190); // none
  CurvedPoints curved;
  curved.add (points(), found_, truth);
  EXPECT_DOUBLE_EQ (curved.labelledPercent(), 100. * (15. + 10.) / 60.);
  EXPECT_DOUBLE_EQ (curved.shatteredPercent(), 100. * 10. / 60.);
}

TEST_F (PlaneFigures, RightAnglesAreThoseOfBigPlanesNear90Degrees)
{
  addPlane (0, 50, direction (0.f));
  addPlane (50, 100, direction (91.f));   // 1 from a right angle to the first
  addPlane (100, 150, direction (-93.f)); // 3 from one to the first
  addPlane (150, 154, direction (75.f));  // 15 from one to the first; 2 % of the pixels
  addPlane (154, 157, direction (95.f));  // 5 from one to the first, but small
  addPlane (160, 180, direction (45.f));  // none with any
  RightAngles right;
  right.add (points(), found_, RightAngles::Pairs::all);
  EXPECT_NEAR (right.medianDegrees(), 3., 1e-4);
  EXPECT_DOUBLE_EQ (right.pairsWithinPercent(), 100. / 3.);
  EXPECT_DOUBLE_EQ (right.framesWithinPercent(), 0.);
  EXPECT_EQ (right.frames(), 1u);
}

TEST_F (PlaneFigures, FramesAreRightWhenAllTheirPairsAre)
{
  RightAngles right;
  addPlane (0, 50, direction (0.f));
  addPlane (50, 100, direction (1.f)); // parallel: no pair
  right.add (points(), found_, RightAngles::Pairs::all);
  EXPECT_EQ (right.frames(), 0u);
  addPlane (100, 150, direction (91.f)); // 1 and 0
  right.add (points(), found_, RightAngles::Pairs::all);
  EXPECT_EQ (right.frames(), 1u);
  EXPECT_DOUBLE_EQ (right.framesWithinPercent(), 100.);
  addPlane (150, 200, direction (93.f)); // 3 and 2
  right.add (points(), found_, RightAngles::Pairs::all);
  EXPECT_EQ (right.frames(), 2u);
  EXPECT_DOUBLE_EQ (right.framesWithinPercent(), 50.);
}

TEST_F (PlaneFigures, WithTheFloorOnlyAnglesToTheLowestPlaneCount)
{
  const Eigen::AngleAxisf tilt (static_cast<float> (M_PI) / 180.f,
                                Eigen::Vector3f::UnitX()); // 1 degree
  const Eigen::AngleAxisf turn (80.f * static_cast<float> (M_PI) / 180.f,
                                Eigen::Vector3f::UnitY());
  const Eigen::Vector3f board = tilt * Eigen::Vector3f (0.f, 0.f, -1.f);
  addPlane (0, 40, board);
  addPlane (40, 180, turn * board); // 10 from a right angle to the other board
  addPlane (180, 200, Eigen::Vector3f (0.f, -1.f, 0.f)); // the last row
  RightAngles floor, all;
  floor.add (points(), found_, RightAngles::Pairs::with_floor);
  EXPECT_NEAR (floor.medianDegrees(), 1., 1e-4);
  EXPECT_DOUBLE_EQ (floor.framesWithinPercent(), 100.);
  all.add (points(), found_, RightAngles::Pairs::all);
  EXPECT_DOUBLE_EQ (all.pairsWithinPercent(), 200. / 3.);
  EXPECT_DOUBLE_EQ (all.framesWithinPercent(), 0.);
}
