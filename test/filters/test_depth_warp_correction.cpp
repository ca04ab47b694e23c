// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/filters/depth_warp_correction.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Correction = pcl::DepthWarpCorrection<pcl::PointXYZ>;
using Models = std::vector<pcl::ModelCoefficients>;
using Inliers = std::vector<pcl::PointIndices>;
using Planes = pcl::rgbd_planes::PlaneVectors;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/** The corner of a room as a camera sees it whose inverse depth errs by \a warp, a function
 * of the pixel at VGA: a floor 1.2 m below the camera and walls. */
class Corner {
public:
  explicit Corner (std::uint32_t width,
                   double (*warp) (double u, double v),
                   const Planes& floor_and_walls = threeWalls())
  : planes (floor_and_walls)
  , inliers (floor_and_walls.size())
  {
    cloud->resize (width, width * 3 / 4);
    truth.resize (width, width * 3 / 4);
    const double step = 640. / width;
    for (std::uint32_t row = 0; row < cloud->height; ++row)
      for (std::uint32_t column = 0; column < width; ++column) {
        const double u = (column + 0.5) * step, v = (row + 0.5) * step;
        const Eigen::Vector3d ray ((u - 320.) / 525., (v - 240.) / 525., 1.);
        double inverse_depth = 0.;
        std::size_t seen = 0;
        for (std::size_t k = 0; k < planes.size(); ++k) {
          const Eigen::Vector4d plane = planes[k].cast<double>();
          const double one = -plane.head<3>().dot (ray) / plane[3];
          if (one > inverse_depth) {
            inverse_depth = one;
            seen = k;
          }
        }
        truth (column, row).getVector3fMap() = (ray / inverse_depth).cast<float>();
        (*cloud) (column, row).getVector3fMap() =
            (ray / (inverse_depth + warp (u, v))).cast<float>();
        inliers[seen].indices.push_back (static_cast<int> (row * width + column));
      }
  }

  Models
  models () const
  {
    Models result;
    for (const auto& plane : planes) {
      result.emplace_back();
      result.back().values.assign (plane.data(), plane.data() + 4);
    }
    return result;
  }

  /** Root mean square of the errors in depth, in metres. */
  double
  depthError (const Cloud& points) const
  {
    double squares = 0.;
    for (std::size_t i = 0; i < points.size(); ++i)
      squares += std::pow (points[i].z - truth[i].z, 2);
    return std::sqrt (squares / static_cast<double> (points.size()));
  }

  static Planes
  threeWalls ()
  {
    return {{0.f, -1.f, 0.f, 1.2f},
            {0.f, 0.f, -1.f, 4.f},
            {0.8f, 0.f, -0.6f, 2.6f},
            {-0.7071f, 0.f, -0.7071f, 3.3f}};
  }

  /** Two walls, whose angle is not a right one by \a skew, in degrees. */
  static Planes
  twoWalls (float skew)
  {
    const float angle =
        std::atan2 (0.8f, -0.6f) - skew * static_cast<float> (M_PI) / 180.f;
    return {{0.f, -1.f, 0.f, 1.2f},
            {0.8f, 0.f, -0.6f, 2.8f},
            {std::cos (angle), 0.f, -std::sin (angle), 3.4f}};
  }

  Planes planes;
  Cloud::Ptr cloud = pcl::make_shared<Cloud>();
  Cloud truth;
  Inliers inliers;
};

double
noWarp (double, double)
{
  return 0.;
}

/** Waves of 300 and 430 pixels, 5 cm at 4 m. */
double
waves (double u, double v)
{
  return 0.002 *
         (std::sin (0.0209 * u + 0.3) + std::sin (0.0146 * (0.6 * u + 0.8 * v)));
}

/** Tilts planes by a degree. */
double
linearWarp (double u, double v)
{
  return 6e-6 * (u - 320.) - 8e-6 * (v - 240.);
}

Cloud
correctWith (Correction& correction, const Cloud::ConstPtr& cloud)
{
  Cloud output;
  correction.setInputCloud (cloud);
  correction.filter (output);
  return output;
}

Cloud
correct (const Corner& corner)
{
  Correction correction;
  EXPECT_TRUE (correction.addFrame (corner.cloud, corner.models(), corner.inliers));
  return correctWith (correction, corner.cloud);
}

void
expectSameBytes (const Cloud& a, const Cloud& b)
{
  ASSERT_EQ (a.size(), b.size());
  EXPECT_EQ (std::memcmp (a.data(), b.data(), a.size() * sizeof (pcl::PointXYZ)), 0);
}

} // namespace

TEST (DepthWarpCorrection, PlanesTellTheWarpThatTheyShare)
{
  for (const std::uint32_t width : {640u, 320u, 160u}) {
    const Corner corner (width, waves);
    const double before = corner.depthError (*corner.cloud);
    EXPECT_GT (before, 0.01);
    EXPECT_LT (corner.depthError (correct (corner)), before / 4.) << width;
  }
}

TEST (DepthWarpCorrection, WithoutWarpPointsStay)
{
  const Corner corner (320, noWarp);
  EXPECT_LT (corner.depthError (correct (corner)), 1e-4);
}

TEST (DepthWarpCorrection, RightAnglesTellWhatTiltsAllPlanesAlike)
{
  for (const std::uint32_t width : {640u, 160u}) {
    const Corner corner (width, linearWarp, Corner::twoWalls (0.f));
    const double before = corner.depthError (*corner.cloud);
    EXPECT_GT (before, 0.01);
    const auto errorAfter = [&] (Correction& correction) {
      for (int frame = 0; frame < 30; ++frame)
        EXPECT_TRUE (
            correction.addFrame (corner.cloud, corner.models(), corner.inliers));
      return corner.depthError (correctWith (correction, corner.cloud));
    };
    Correction with, without;
    EXPECT_TRUE (with.getRightAngles());
    without.setRightAngles (false);
    EXPECT_FALSE (without.getRightAngles());
    EXPECT_LT (errorAfter (with), before / 2.) << width;
    EXPECT_GT (errorAfter (without), 0.75 * before) << width;
  }
}

TEST (DepthWarpCorrection, OtherAnglesStay)
{
  for (const float skew : {5.f, -5.f, 20.f}) {
    const Corner corner (320, noWarp, Corner::twoWalls (skew));
    EXPECT_LT (corner.depthError (correct (corner)), 1e-4) << skew;
  }
}

/** A corner without warp and the error that a panel on a wall makes, nearly at right angles to
 * floor and other wall; it has \a size x \a size cells. */
double
errorOfPanel (int size)
{
  Corner corner (320, noWarp, Corner::twoWalls (0.f));
  const Eigen::Vector4f skew = Corner::twoWalls (3.f)[2];
  const auto isOnPanel = [&] (int i) {
    return i % 320 >= 240 && i % 320 < 240 + 4 * size && i / 320 >= 40 &&
           i / 320 < 40 + 4 * size;
  };
  corner.planes.push_back (skew);
  corner.inliers.emplace_back();
  auto &wall = corner.inliers[2].indices, &panel = corner.inliers.back().indices;
  std::copy_if (wall.begin(), wall.end(), std::back_inserter (panel), isOnPanel);
  EXPECT_EQ (static_cast<int> (panel.size()), 16 * size * size);
  wall.erase (std::remove_if (wall.begin(), wall.end(), isOnPanel), wall.end());
  for (const int i : panel) {
    auto p = (*corner.cloud)[static_cast<std::size_t> (i)].getVector3fMap();
    p *= -skew[3] / skew.head<3>().dot (p);
    corner.truth[static_cast<std::size_t> (i)].getVector3fMap() = p;
  }
  return corner.depthError (correct (corner));
}

TEST (DepthWarpCorrection, SmallPlanesHardlyTellAngles)
{
  EXPECT_LT (errorOfPanel (12), 1e-4);
  EXPECT_LT (errorOfPanel (13), 2e-3);
  EXPECT_GT (errorOfPanel (13), 1e-4);
}

TEST (DepthWarpCorrection, PlanesNeedNotBeGood)
{
  Corner corner (320, noWarp);
  for (auto& plane : corner.planes) {
    plane[3] *= 1.01f; // 4 cm at 4 m
    plane.head<3>() =
        Eigen::AngleAxisf (0.02f, Eigen::Vector3f::UnitY()) * plane.head<3>();
  }
  EXPECT_LT (corner.depthError (correct (corner)), 0.003);
}

TEST (DepthWarpCorrection, NormalsMayPointAnywhere)
{
  Corner corner (160, waves);
  const Cloud expected = correct (corner);
  corner.planes[1] = -corner.planes[1];
  corner.planes[2] *= 2.f;
  const Cloud actual = correct (corner);
  for (std::size_t i = 0; i < actual.size(); ++i)
    EXPECT_NEAR (actual[i].z, expected[i].z, 1e-5f);
}

TEST (DepthWarpCorrection, PointsKeepTheirPixels)
{
  const Corner corner (160, waves);
  const Cloud output = correct (corner);
  EXPECT_EQ (output.width, 160u);
  EXPECT_EQ (output.height, 120u);
  for (std::size_t i = 0; i < output.size(); ++i) {
    EXPECT_NEAR (
        output[i].x / output[i].z, corner.truth[i].x / corner.truth[i].z, 1e-5);
    EXPECT_NEAR (
        output[i].y / output[i].z, corner.truth[i].y / corner.truth[i].z, 1e-5);
  }
}

TEST (DepthWarpCorrection, FramesAddWhatTheyTell)
{
  // Each of two frames has the planes of one half of the image.
  const Corner corner (320, waves);
  Inliers halves[2] = {Inliers (4), Inliers (4)};
  for (std::size_t k = 0; k < 4; ++k)
    for (const int i : corner.inliers[k].indices)
      halves[i % 320 < 160 ? 0 : 1][k].indices.push_back (i);
  double alone[2];
  Correction both;
  for (std::size_t h = 0; h < 2; ++h) {
    Correction one;
    ASSERT_TRUE (one.addFrame (corner.cloud, corner.models(), halves[h]));
    alone[h] = corner.depthError (correctWith (one, corner.cloud));
    ASSERT_TRUE (both.addFrame (corner.cloud, corner.models(), halves[h]));
  }
  EXPECT_EQ (both.getNumberOfFrames(), 2u);
  EXPECT_LT (corner.depthError (correctWith (both, corner.cloud)),
             0.5 * std::min (alone[0], alone[1]));
}

TEST (DepthWarpCorrection, WhatIsNoPlaneTellsNothing)
{
  Corner corner (320, waves);
  const auto moveTo =
      [&] (std::size_t u0, std::size_t v0, std::size_t u1, std::size_t v1) {
        corner.inliers.emplace_back();
        for (auto& inliers : corner.inliers)
          inliers.indices.erase (
              std::remove_if (inliers.indices.begin(),
                              inliers.indices.end(),
                              [&] (int i) {
                                const auto u = static_cast<std::size_t> (i % 320),
                                           v = static_cast<std::size_t> (i / 320);
                                return u >= u0 && u < u1 && v >= v0 && v < v1;
                              }),
              inliers.indices.end());
        for (std::size_t v = v0; v < v1; ++v)
          for (std::size_t u = u0; u < u1; ++u)
            corner.inliers.back().indices.push_back (static_cast<int> (v * 320 + u));
      };
  moveTo (0, 0, 16, 16);     // 4 x 4 cells
  moveTo (100, 20, 140, 60); // a plane through the camera
  moveTo (200, 20, 240, 60); // nonsense
  const Planes good = corner.planes;
  corner.planes.push_back ({0.f, 0.f, -1.f, 2.f});
  corner.planes.push_back ({0.f, 0.f, -1.f, 0.f});
  corner.planes.push_back ({not_a_number, 0.f, -1.f, 2.f});
  const Cloud with = correct (corner);
  corner.planes = good;
  corner.inliers.resize (4);
  expectSameBytes (with, correct (corner));
}

TEST (DepthWarpCorrection, CellsWithFewPointsDoNotCount)
{
  // Every second cell of 4 x 4 pixels has one point left, a wrong one.
  const Corner corner (320, noWarp);
  for (std::uint32_t v = 0; v < 240; ++v)
    for (std::uint32_t u = 0; u < 320; ++u)
      if ((u / 4 + v / 4) % 2) {
        auto p = (*corner.cloud) (u, v).getVector3fMap();
        if (u % 4 || v % 4)
          p.setConstant (not_a_number);
        else
          p *= 1.1f;
      }
  const Cloud output = correct (corner);
  for (std::size_t i = 0; i < output.size(); ++i)
    if ((i % 320 / 4 + i / 320 / 4) % 2 == 0) {
      EXPECT_NEAR (output[i].z, corner.truth[i].z, 1e-3f);
    }
}

TEST (DepthWarpCorrection, PointsAtTheCameraTellNothing)
{
  const Corner corner (160, waves);
  for (std::uint32_t v = 0; v < 20; ++v)
    for (std::uint32_t u = 0; u < 20; ++u) {
      auto p = (*corner.cloud) (u, v).getVector3fMap();
      p *= 1e-39f / p.z();
    }
  const Cloud near = correct (corner);
  for (std::uint32_t v = 0; v < 20; ++v)
    for (std::uint32_t u = 0; u < 20; ++u)
      (*corner.cloud) (u, v).getVector3fMap().setConstant (not_a_number);
  const Cloud missing = correct (corner);
  for (std::size_t i = 20 * 160; i < near.size(); ++i)
    EXPECT_EQ (near[i].z, missing[i].z) << i;
  EXPECT_LT (std::abs (near.back().z - corner.truth.back().z), 0.02f);
}

TEST (DepthWarpCorrection, PointsBeyondTheRangeOfTheSensorTellNothing)
{
  const Corner corner (160, waves);
  Correction correction;
  correction.setDepthNoise ({0.001f, 0.002f, 1.f});
  EXPECT_EQ (correction.getDepthNoise().max_range, 1.f);
  correction.setDepthNoise ({0.001f, 0.002f, 0.f});
  EXPECT_EQ (correction.getDepthNoise().max_range, 1.f);
  ASSERT_TRUE (correction.addFrame (corner.cloud, corner.models(), corner.inliers));
  expectSameBytes (correctWith (correction, corner.cloud), *corner.cloud);
}

TEST (DepthWarpCorrection, WhatHasNoDepthStays)
{
  const Corner corner (160, waves);
  Correction correction;
  ASSERT_TRUE (correction.addFrame (corner.cloud, corner.models(), corner.inliers));
  const float inf = std::numeric_limits<float>::infinity();
  const auto cloud = pcl::make_shared<Cloud> (*corner.cloud);
  const Eigen::Vector3f strange[] = {{not_a_number, not_a_number, not_a_number},
                                     {0.f, 0.f, 0.f},
                                     {0.1f, 0.1f, inf},
                                     {0.1f, 0.2f, -3.f},
                                     {3.f, 2.f, 1e30f}};
  for (std::size_t i = 0; i < std::size (strange); ++i)
    (*cloud)[i].getVector3fMap() = strange[i];
  for (std::size_t i = 1000; i < cloud->size(); i += 100) // both too near and too far
    (*cloud)[i].z = 1e8f;
  const Cloud output = correctWith (correction, cloud);
  for (std::size_t i = 1000; i < cloud->size(); i += 100)
    EXPECT_EQ (output[i].z, 1e8f) << i;
  for (std::size_t i = 0; i < std::size (strange); ++i)
    for (Eigen::Index k = 0; k < 3; ++k)
      EXPECT_TRUE (std::isnan (strange[i][k])
                       ? std::isnan (output[i].getVector3fMap()[k])
                       : output[i].getVector3fMap()[k] == strange[i][k])
          << i;
  EXPECT_NE (output[100].z, (*cloud)[100].z);
}

TEST (DepthWarpCorrection, OnlyIndicesMoveAndOtherFieldsStay)
{
  const Corner corner (160, waves);
  pcl::DepthWarpCorrection<pcl::PointXYZRGB> correction;
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>> (160, 120);
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    (*cloud)[i].getVector3fMap() = (*corner.cloud)[i].getVector3fMap();
    (*cloud)[i].rgba = static_cast<std::uint32_t> (i);
  }
  cloud->header.frame_id = "camera";
  ASSERT_TRUE (correction.addFrame (cloud, corner.models(), corner.inliers));
  const Cloud all = correct (corner);
  correction.setInputCloud (cloud);
  const auto some = pcl::make_shared<pcl::Indices> (pcl::Indices{200, 5000, 19000});
  correction.setIndices (some);
  pcl::PointCloud<pcl::PointXYZRGB> output;
  correction.filter (output);
  EXPECT_EQ (output.header.frame_id, "camera");
  ASSERT_EQ (output.size(), cloud->size());
  for (std::size_t i = 0; i < output.size(); ++i) {
    const bool moves =
        std::count (some->begin(), some->end(), static_cast<int> (i)) > 0;
    EXPECT_EQ (output[i].z, moves ? all[i].z : (*cloud)[i].z) << i;
    EXPECT_EQ (output[i].rgba, i);
  }
  correction.filter (*cloud); // in place
  for (std::size_t i = 0; i < output.size(); ++i)
    EXPECT_EQ ((*cloud)[i].z, output[i].z);
}

TEST (DepthWarpCorrection, AnotherCamera)
{
  Correction correction;
  for (const std::uint32_t width : {320u, 161u, 8u, 320u}) {
    const Corner corner (width, waves);
    ASSERT_TRUE (correction.addFrame (corner.cloud, corner.models(), corner.inliers));
    EXPECT_EQ (correction.getNumberOfFrames(), 1u);
    expectSameBytes (correctWith (correction, corner.cloud), correct (corner));
    correction.clearFrames();
    EXPECT_EQ (correction.getNumberOfFrames(), 0u);
  }
}

TEST (DepthWarpCorrection, WrongUseIsAnErrorAndLeavesNothing)
{
  const Corner corner (160, waves), other (320, waves);
  const Models models = corner.models();
  Correction correction;
  EXPECT_TRUE (correctWith (correction, corner.cloud).empty()) << "no frames";

  EXPECT_FALSE (correction.addFrame (corner.cloud, models, Inliers (3)));
  EXPECT_FALSE (correction.addFrame (corner.cloud, models, other.inliers));
  Inliers negative (4);
  negative[2].indices = {-1};
  EXPECT_FALSE (correction.addFrame (corner.cloud, models, negative));
  const auto row = pcl::make_shared<Cloud>();
  row->resize (19200);
  EXPECT_FALSE (correction.addFrame (row, models, corner.inliers));
  EXPECT_FALSE (correction.addFrame (pcl::make_shared<Cloud>(), models, Inliers (4)));
  EXPECT_FALSE (correction.addFrame (nullptr, models, corner.inliers));
  EXPECT_EQ (correction.getNumberOfFrames(), 0u);

  EXPECT_TRUE (correction.addFrame (corner.cloud, models, corner.inliers));
  EXPECT_FALSE (correction.addFrame (other.cloud, models, other.inliers));
  EXPECT_EQ (correction.getNumberOfFrames(), 1u);
  EXPECT_TRUE (correctWith (correction, other.cloud).empty()) << "another size";
  EXPECT_TRUE (correctWith (correction, row).empty());
  correction.setIndices (pcl::make_shared<pcl::Indices> (pcl::Indices{19200}));
  EXPECT_TRUE (correctWith (correction, corner.cloud).empty()) << "an index outside";
}

TEST (DepthWarpCorrection, PlanesOfAnotherCloudAreRefused)
{
  Corner corner (160, waves);
  Correction correction;
  for (auto& plane : corner.planes) // as CameraToBase turns them
    plane.head<3>() = Eigen::Vector3f (plane.z(), -plane.x(), -plane.y());
  EXPECT_FALSE (correction.addFrame (corner.cloud, corner.models(), corner.inliers));
  EXPECT_EQ (correction.getNumberOfFrames(), 0u);
  EXPECT_TRUE (correctWith (correction, corner.cloud).empty()) << "no frames";
}

TEST (DepthWarpCorrection, CloudsOfAnotherFrameAreRefused)
{
  const Corner corner (160, waves);
  Correction correction;
  ASSERT_TRUE (correction.addFrame (corner.cloud, corner.models(), corner.inliers));
  corner.cloud->sensor_origin_.z() = 1.f;
  EXPECT_FALSE (correction.addFrame (corner.cloud, corner.models(), corner.inliers));
  EXPECT_EQ (correction.getNumberOfFrames(), 1u);
  EXPECT_TRUE (correctWith (correction, corner.cloud).empty());
}

TEST (DepthWarpCorrection, PointsFarBesideTheCameraTellNothing)
{
  const Corner corner (160, waves);
  corner.cloud->front().getVector3fMap() << 1e38f, 0.f, 0.01f;
  Correction correction;
  ASSERT_TRUE (correction.addFrame (corner.cloud, corner.models(), corner.inliers));
  for (const auto& pixel : correction.getWarp())
    ASSERT_TRUE (std::isfinite (pixel.intensity));
}

TEST (DepthWarpCorrection, FramesWithoutPlanesTellNothing)
{
  const Corner corner (160, waves);
  Correction correction;
  EXPECT_TRUE (correction.addFrame (corner.cloud, {}, {}));
  expectSameBytes (correctWith (correction, corner.cloud), *corner.cloud);
}

TEST (DepthWarpCorrection, TheWarpMovesToAnotherObject)
{
  const Corner corner (160, waves), other (320, waves);
  Correction learned, given;
  EXPECT_TRUE (learned.getWarp().empty());
  ASSERT_TRUE (learned.addFrame (corner.cloud, corner.models(), corner.inliers));
  const auto warp = learned.getWarp();
  ASSERT_EQ (warp.width, 160u);
  ASSERT_EQ (warp.height, 120u);
  ASSERT_TRUE (given.setWarp (warp));
  EXPECT_EQ (given.getNumberOfFrames(), 0u);
  const Cloud corrected = correct (corner);
  expectSameBytes (correctWith (given, corner.cloud), corrected);
  EXPECT_TRUE (correctWith (given, other.cloud).empty()) << "another size";

  // Frames take its place.
  const Corner straight (160, noWarp);
  ASSERT_TRUE (given.addFrame (corner.cloud, corner.models(), corner.inliers));
  expectSameBytes (correctWith (given, corner.cloud), corrected);
  ASSERT_TRUE (given.addFrame (straight.cloud, straight.models(), straight.inliers));
  EXPECT_EQ (given.getNumberOfFrames(), 2u);
  ASSERT_TRUE (given.setWarp (warp));
  expectSameBytes (correctWith (given, corner.cloud), corrected);
  given.clearFrames();
  EXPECT_TRUE (given.getWarp().empty());
  EXPECT_TRUE (correctWith (given, corner.cloud).empty());
}

TEST (DepthWarpCorrection, WhatIsNoWarpIsRefused)
{
  Correction correction;
  pcl::PointCloud<pcl::Intensity> warp;
  EXPECT_FALSE (correction.setWarp (warp));
  warp.resize (19200);
  EXPECT_FALSE (correction.setWarp (warp)) << "a row";
  warp.width = 160;
  warp.height = 120;
  warp[77].intensity = not_a_number;
  EXPECT_FALSE (correction.setWarp (warp));
  EXPECT_TRUE (correction.getWarp().empty());
  warp[77].intensity = 0.1f;
  EXPECT_TRUE (correction.setWarp (warp));
  const Corner corner (160, noWarp);
  const Cloud output = correctWith (correction, corner.cloud);
  const float z = (*corner.cloud)[77].z;
  EXPECT_NEAR (1.f / output[77].z, 1.f / z - 0.1f, 1e-5f);
  EXPECT_EQ (output[78].z, (*corner.cloud)[78].z);
}
