// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/plane_correction.h>
#include <pcl/segmentation/impl/label_runs.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>

using namespace pcl::rgbd_planes;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/** The plane z = \a depth, turned about the vertical. */
Eigen::Vector4f
wall (float depth, float degrees = 0.f)
{
  const float angle = degrees * static_cast<float> (M_PI) / 180.f;
  return {std::sin (angle), 0.f, -std::cos (angle), depth * std::cos (angle)};
}

/** An image of 40 x 10 points: left of its middle a wall 4 m away, true plane 0, right of it
 * another one, turned by 40 degrees, true plane 1. Both were found where they are. */
class PlaneCorrectionTest : public testing::Test {
protected:
  PlaneCorrectionTest() : pixels_ (40, 10)
  {
    truth_.coefficients = {wall (4.f), wall (4.f, 40.f)};
    truth_.labels.resize (400);
    for (std::size_t i = 0; i < 400; ++i) {
      truth_.labels[i] = i % 40 < 20 ? 0 : 1;
      (*cloud_)[i].getVector3fMap() =
          onPlane (i, truth_.coefficients[truth_.labels[i]]);
    }
    static_cast<PlaneSet&> (found_) = truth_;
    found_.cloud = cloud_;
  }

  /** Where the ray of point \a i meets a plane. */
  static Eigen::Vector3f
  onPlane (std::size_t i, const Eigen::Vector4f& plane)
  {
    const Eigen::Vector3f ray (0.01f * (static_cast<float> (i % 40) - 19.5f),
                               0.01f * (static_cast<float> (i / 40) - 4.5f),
                               1.f);
    return -plane[3] / plane.head<3>().dot (ray) * ray;
  }

  /** Every second point is measured 1 % too far, the others 1 % too near. */
  void
  addNoise ()
  {
    for (std::size_t i = 0; i < 400; ++i)
      (*cloud_)[i].getVector3fMap() *= i % 2 ? 1.01f : 0.99f;
  }

  /** Only the points of plane 0 stay. */
  void
  removeRight ()
  {
    for (std::size_t i = 0; i < 400; ++i)
      if (i % 40 >= 20)
        (*cloud_)[i].x = not_a_number;
  }

  PlaneCorrection
  evaluate (std::size_t min_points = 1) const
  {
    PlaneCorrection correction;
    correction.add (cloud_, found_, truth_, pixels_, {0.f, -1.f, 0.f}, min_points);
    return correction;
  }

  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud_ =
      pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> (40, 10);
  pcl::PointCloud<TruthPoint> pixels_;
  PlaneSet truth_;
  FoundPlanes found_;
};

} // namespace

TEST_F (PlaneCorrectionTest, OnTruePlanesNothingIsLeft)
{
  addNoise();
  const PlaneCorrection result = evaluate();
  EXPECT_EQ (result.before.points, 400u);
  double squares = 0.;
  for (std::size_t i = 0; i < 400; ++i)
    squares += std::pow (0.01 * truth_.coefficients[truth_.labels[i]][3], 2);
  EXPECT_NEAR (result.before.rmsMillimetres(), 1000. * std::sqrt (squares / 400), 1e-2);
  EXPECT_NEAR (result.along_ray.rmsMillimetres(), 0., 1e-3);
  EXPECT_NEAR (result.along_normal.rmsMillimetres(), 0., 1e-3);
}

TEST_F (PlaneCorrectionTest, RaysAndNormals)
{
  removeRight();
  addNoise();
  found_.coefficients[0] = wall (4.05f, 10.f);
  const Eigen::Vector4d plane = found_.coefficients[0].cast<double>();
  double along_ray = 0., along_normal = 0.;
  for (std::size_t i = 0; i < 400; ++i)
    if (i % 40 < 20) {
      const Eigen::Vector3d p = (*cloud_)[i].getVector3fMap().cast<double>();
      const double distance = plane.dot (p.homogeneous());
      along_normal += std::pow (p.z() - distance * plane.z() - 4., 2);
      const double scale = -plane[3] / plane.head<3>().dot (p);
      along_ray += std::pow (scale * p.z() - 4., 2);
    }
  const PlaneCorrection result = evaluate();
  EXPECT_NEAR (
      result.along_ray.rmsMillimetres(), 1000. * std::sqrt (along_ray / 200.), 1e-2);
  EXPECT_NEAR (result.along_normal.rmsMillimetres(),
               1000. * std::sqrt (along_normal / 200.),
               1e-2);
  EXPECT_GT (std::abs (along_ray - along_normal), 1e-3);
}

TEST_F (PlaneCorrectionTest, PointsOnNoFoundPlaneStay)
{
  removeRight();
  addNoise();
  for (std::size_t i = 0; i < 400; i += 2)
    found_.labels[i] = unlabelled;
  const PlaneCorrection result = evaluate();
  EXPECT_NEAR (result.before.rmsMillimetres(), 40., 1e-2);
  EXPECT_NEAR (result.along_ray.rmsMillimetres(), 40. / std::sqrt (2.), 1e-2);
}

TEST_F (PlaneCorrectionTest, EdgesOtherRangesAndSmallPlanesDoNotCount)
{
  for (std::size_t v = 0; v < 10; ++v) {
    pixels_[40 * v].edge = 1;
    truth_.labels[40 * v + 1] = unlabelled;
    (*cloud_)[40 * v + 2].y = not_a_number;
    (*cloud_)[40 * v + 3].getVector3fMap() *=
        3.4f / (*cloud_)[40 * v + 3].getVector3fMap().norm();
    (*cloud_)[40 * v + 4].getVector3fMap() *=
        3.6f / (*cloud_)[40 * v + 4].getVector3fMap().norm();
    (*cloud_)[40 * v + 5].getVector3fMap() *=
        5.9f / (*cloud_)[40 * v + 5].getVector3fMap().norm();
    (*cloud_)[40 * v + 6].getVector3fMap() *=
        6.1f / (*cloud_)[40 * v + 6].getVector3fMap().norm();
  }
  EXPECT_EQ (evaluate().before.points, 400u - 50u);
  EXPECT_EQ (evaluate (180).before.points, 400u - 50u);
  EXPECT_EQ (evaluate (181).before.points, 200u);
  EXPECT_EQ (evaluate (201).before.points, 0u);
  EXPECT_TRUE (std::isnan (evaluate (201).before.rmsMillimetres()));
}

TEST_F (PlaneCorrectionTest, FitsFollowWhatIsMeasured)
{
  removeRight();
  found_.coefficients.clear();
  found_.labels.assign (400, unlabelled);
  for (std::size_t i = 0; i < 400; ++i) {
    (*cloud_)[i].getVector3fMap() *= 1.02f;
    if (i % 40 == 7 || i % 40 == 8) { // seen past an edge
      (*cloud_)[i].getVector3fMap() *= 1.2f;
      pixels_[i].edge = 1;
    }
  }
  EXPECT_NEAR (evaluate().along_ray.rmsMillimetres(), 80., 1e-2);
  EXPECT_NEAR (evaluate().fits_along_ray.rmsMillimetres(), 80., 1e-2);
  addNoise();
  EXPECT_GT (evaluate().before.rmsMillimetres(), 89.);
  EXPECT_NEAR (evaluate().fits_along_ray.rmsMillimetres(), 80., 1.);
}

TEST_F (PlaneCorrectionTest, AnglesBetweenWalls)
{
  PlaneCorrection result = evaluate();
  ASSERT_EQ (result.walls.errors.size(), 1u);
  EXPECT_NEAR (result.walls.errors[0], 0., 1e-3);
  found_.coefficients[1] = wall (4.f, 40.9f);
  EXPECT_NEAR (evaluate().walls.medianDegrees(), 0.9, 1e-3);
  EXPECT_DOUBLE_EQ (evaluate().walls.withinPercent(), 100.);
  found_.coefficients[0] = wall (4.f, 2.f);
  EXPECT_NEAR (evaluate().walls.medianDegrees(), 1.1, 1e-3);
  EXPECT_DOUBLE_EQ (evaluate().walls.withinPercent(), 0.);
  EXPECT_NEAR (evaluate().fits_walls.medianDegrees(), 0., 1e-3);
}

TEST_F (PlaneCorrectionTest, WallsThatAreNotFound)
{
  for (std::size_t v = 0; v < 10; ++v)
    for (std::size_t u = 0; u < 10; ++u)
      found_.labels[40 * v + u] = unlabelled; // exactly a half of plane 0
  EXPECT_NEAR (evaluate().walls.errors.at (0), 0., 1e-3);
  found_.labels[10] = unlabelled;
  EXPECT_TRUE (std::isinf (evaluate().walls.errors.at (0)));
  EXPECT_DOUBLE_EQ (evaluate().walls.withinPercent(), 0.);
}

TEST_F (PlaneCorrectionTest, OnlyLargeVerticalPlanesThatMeetArePairs)
{
  truth_.coefficients[1] = wall (4.f, 29.f);
  EXPECT_TRUE (evaluate().walls.errors.empty());
  EXPECT_TRUE (std::isnan (evaluate().walls.medianDegrees()));
  truth_.coefficients[1] = wall (4.f, 31.f);
  EXPECT_EQ (evaluate().walls.errors.size(), 1u);
  truth_.coefficients[1] = {0.f, -1.f, 0.f, 1.f};
  EXPECT_TRUE (evaluate().walls.errors.empty());
  truth_.coefficients[1] = wall (4.f, 60.f);
  for (std::size_t i = 0; i < 400; ++i)
    if (truth_.labels[i] == 1 && (i % 40 > 20 || i / 40 >= 8))
      truth_.labels[i] = unlabelled; // 8 of 400 points are left
  EXPECT_EQ (evaluate().walls.errors.size(), 1u);
  truth_.labels[20] = unlabelled;
  EXPECT_TRUE (evaluate().walls.errors.empty());
}
