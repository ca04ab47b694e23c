// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "true_edges.h"

#include <pcl/simulation/simulate.h>
#include <pcl/simulation/subsample.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <stdexcept>

using pcl::rgbd_planes::Camera;
using pcl::rgbd_planes::sceneNames;
using pcl::rgbd_planes::Sensor;
using pcl::rgbd_planes::simulate;
using pcl::rgbd_planes::SimulatedFrame;
using pcl::rgbd_planes::subsample;
using pcl::rgbd_planes::TruthPoint;

namespace {

class Scenes : public testing::TestWithParam<std::string> {};

/** Compares coordinates and colour; the rest of a point is padding. */
bool
sameBytes (const pcl::PointCloud<pcl::PointXYZRGB>& a,
           const pcl::PointCloud<pcl::PointXYZRGB>& b)
{
  return std::equal (a.begin(), a.end(), b.begin(), b.end(), [] (auto& p, auto& q) {
    return std::memcmp (p.data, q.data, sizeof (p.data)) == 0 && p.rgba == q.rgba;
  });
}

bool
sameBytes (const pcl::PointCloud<TruthPoint>& a, const pcl::PointCloud<TruthPoint>& b)
{
  return a.size() == b.size() &&
         std::memcmp (a.data(), b.data(), a.size() * sizeof (a[0])) == 0;
}

std::map<std::uint32_t, std::size_t>
pixelsPerObject (const SimulatedFrame& frame)
{
  std::map<std::uint32_t, std::size_t> pixels;
  for (const auto& point : *frame.truth)
    if (point.object != 0)
      ++pixels[point.object];
  return pixels;
}

} // namespace

TEST_P (Scenes, IdealDepthIsTheTruth)
{
  const auto frame = simulate (GetParam(), 1, Sensor::ideal);
  ASSERT_EQ (frame.cloud->width, 640u);
  ASSERT_EQ (frame.cloud->height, 480u);
  ASSERT_EQ (frame.truth->width, 640u);
  ASSERT_EQ (frame.truth->height, 480u);
  for (std::size_t i = 0; i < frame.cloud->size(); ++i) {
    const auto& measured = (*frame.cloud)[i];
    const auto& truth = (*frame.truth)[i];
    ASSERT_EQ (std::isfinite (measured.z), std::isfinite (truth.z));
    if (std::isfinite (truth.z)) {
      ASSERT_NEAR (
          (measured.getVector3fMap() - truth.getVector3fMap()).norm(), 0.f, 1e-6f);
    }
  }
}

TEST_P (Scenes, PointsProjectToTheirPixels)
{
  const Camera camera;
  for (const Sensor sensor : {Sensor::kinect, Sensor::active_stereo}) {
    const auto frame = simulate (GetParam(), 1, sensor);
    for (int v = 0; v < camera.height; ++v)
      for (int u = 0; u < camera.width; ++u) {
        const auto& point = (*frame.cloud) (u, v);
        if (!std::isfinite (point.z))
          continue;
        ASSERT_NEAR (
            point.x / point.z * camera.fx + camera.cx, static_cast<float> (u), 1e-3f);
        ASSERT_NEAR (
            point.y / point.z * camera.fy + camera.cy, static_cast<float> (v), 1e-3f);
      }
  }
}

TEST_P (Scenes, PlanesHoldTheirPoints)
{
  const auto frame = simulate (GetParam(), 1, Sensor::ideal);
  for (const auto& plane : frame.planes) {
    EXPECT_NEAR (plane.head<3>().norm(), 1.f, 1e-5f);
    EXPECT_GE (plane[3], 0.f);
  }
  for (const auto& point : *frame.truth) {
    ASSERT_LE (point.label, frame.planes.size());
    if (point.label == 0)
      continue;
    const Eigen::Vector4f& plane = frame.planes[point.label - 1];
    ASSERT_NEAR (plane.dot (point.getVector4fMap()), 0.f, 1e-4f);
    ASSERT_GT (plane.head<3>().dot (point.getNormalVector3fMap()), 0.999999f);
  }
}

/** The oracle for normals is the depth itself: tangents between neighbouring pixels. */
TEST_P (Scenes, NormalsAwayFromEdgesAgreeWithTheDepth)
{
  const auto frame = simulate (GetParam(), 1, Sensor::ideal);
  const auto& truth = *frame.truth;
  std::size_t checked = 0;
  for (std::uint32_t v = 1; v + 1 < truth.height; ++v)
    for (std::uint32_t u = 1; u + 1 < truth.width; ++u) {
      const auto& point = truth (u, v);
      if (point.edge != 0 || !std::isfinite (point.z))
        continue;
      const Eigen::Vector3f right =
          truth (u + 1, v).getVector3fMap() - truth (u - 1, v).getVector3fMap();
      const Eigen::Vector3f down =
          truth (u, v + 1).getVector3fMap() - truth (u, v - 1).getVector3fMap();
      const Eigen::Vector3f normal = down.cross (right).normalized();
      ASSERT_GT (normal.dot (point.getNormalVector3fMap()), 0.99f) << u << " " << v;
      ++checked;
    }
  EXPECT_GT (checked, truth.size() / 4);
}

TEST_P (Scenes, OnlyTheFloorIsNoObstacle)
{
  const auto frame = simulate (GetParam(), 1, Sensor::ideal);
  for (const auto& point : *frame.truth) {
    if (!std::isfinite (point.z))
      continue;
    const Eigen::Vector3f in_base = frame.camera_to_base * point.getVector3fMap();
    const Eigen::Vector3f normal =
        frame.camera_to_base.linear() * point.getNormalVector3fMap();
    const bool on_floor = std::fabs (in_base.z()) < 1e-4f && normal.z() > 0.9999f;
    ASSERT_EQ (point.obstacle, on_floor ? 0u : 1u);
  }
}

TEST_P (Scenes, ObjectsAreWhereTheirPointsAre)
{
  const auto frame = simulate (GetParam(), 1, Sensor::ideal);
  for (const auto& object : frame.objects) {
    const Eigen::Affine3f to_object = object.pose.inverse();
    const Eigen::Vector3f high (
        0.5f * object.size.x(), 0.5f * object.size.y(), object.size.z());
    const Eigen::Vector3f low (-high.x(), -high.y(), 0.f);
    for (const auto& point : *frame.truth) {
      if (point.object != object.id)
        continue;
      const Eigen::Vector3f p = to_object * point.getVector3fMap();
      const float outside = (low - p).cwiseMax (p - high).maxCoeff();
      EXPECT_LT (outside, 1e-4f) << object.id;
      if (object.shape == pcl::rgbd_planes::TrueObject::Shape::box &&
          GetParam() != "crockery") { // where they have no lids
        EXPECT_GT (outside, -1e-4f) << object.id;
      }
    }
  }
}

TEST_P (Scenes, TheSameSeedGivesTheSameBytes)
{
  const auto other = simulate (GetParam(), 8, Sensor::ideal);
  for (const Sensor sensor : {Sensor::kinect, Sensor::active_stereo}) {
    const auto first = simulate (GetParam(), 7, sensor);
    const auto second = simulate (GetParam(), 7, sensor);
    EXPECT_TRUE (sameBytes (*first.cloud, *second.cloud));
    EXPECT_TRUE (sameBytes (*first.truth, *second.truth));
    EXPECT_FALSE (sameBytes (*first.truth, *other.truth));
  }
}

TEST_P (Scenes, AllSensorsSeeTheSameTruth)
{
  const auto ideal = simulate (GetParam(), 3, Sensor::ideal);
  for (const Sensor sensor : {Sensor::kinect, Sensor::active_stereo})
    EXPECT_TRUE (sameBytes (*ideal.truth, *simulate (GetParam(), 3, sensor).truth));
}

/** Errors of inverse depth, 1/m, in the mean over blocks of 40 x 40 px; NaN where the truth
 * or the measurement has gaps. */
std::vector<double>
blockErrors (const SimulatedFrame& frame)
{
  constexpr std::uint32_t side = 40;
  std::vector<double> errors;
  for (std::uint32_t v = 0; v + side <= frame.cloud->height; v += side)
    for (std::uint32_t u = 0; u + side <= frame.cloud->width; u += side) {
      double sum = 0.;
      for (std::uint32_t k = 0; k < side * side; ++k) {
        const std::uint32_t column = u + k % side, row = v + k / side;
        const TruthPoint& truth = (*frame.truth) (column, row);
        sum += truth.edge ? std::nan ("")
                          : 1. / (*frame.cloud) (column, row).z - 1. / truth.z;
      }
      errors.push_back (sum / (side * side));
    }
  return errors;
}

double
correlation (const std::vector<double>& a, const std::vector<double>& b)
{
  double n = 0., sum_a = 0., sum_b = 0., aa = 0., bb = 0., ab = 0.;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!std::isfinite (a[i]) || !std::isfinite (b[i]))
      continue;
    n += 1.;
    sum_a += a[i];
    sum_b += b[i];
    aa += a[i] * a[i];
    bb += b[i] * b[i];
    ab += a[i] * b[i];
  }
  EXPECT_GE (n, 20.);
  return (n * ab - sum_a * sum_b) /
         std::sqrt ((n * aa - sum_a * sum_a) * (n * bb - sum_b * sum_b));
}

TEST (Simulate, FramesOfACameraShareTheirWarp)
{
  const auto errors = [] (unsigned seed, unsigned camera) {
    return blockErrors (simulate ("corridor", seed, Sensor::kinect, camera));
  };
  const auto first = errors (1, 5);
  EXPECT_GT (correlation (first, errors (2, 5)), 0.9);
  EXPECT_LT (correlation (first, errors (1, 6)), 0.6);
}

INSTANTIATE_TEST_SUITE_P (All, Scenes, testing::ValuesIn (sceneNames()));

TEST (Simulate, TableAndABoxFaceAreClearlyVisible)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto frame = simulate ("table_single", seed, Sensor::ideal);
    std::size_t table = 0;
    std::map<std::uint32_t, std::size_t> box_faces;
    for (const auto& point : *frame.truth) {
      const float height = (frame.camera_to_base * point.getVector3fMap()).z();
      const Eigen::Vector3f up =
          frame.camera_to_base.linear() * point.getNormalVector3fMap();
      if (point.object == 1)
        ++box_faces[point.label];
      else if (up.z() > 0.999f && height > 0.6f && height < 0.8f)
        ++table;
    }
    EXPECT_GE (table, 1000u) << seed;
    ASSERT_FALSE (box_faces.empty()) << seed;
    const auto largest =
        std::max_element (box_faces.begin(), box_faces.end(), [] (auto& a, auto& b) {
          return a.second < b.second;
        });
    EXPECT_GE (largest->second, 1000u) << seed;
  }
}

TEST (Simulate, TheClutteredTableShowsMoreThan50Objects)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto pixels =
        pixelsPerObject (simulate ("table_cluttered", seed, Sensor::ideal));
    const auto seen = std::count_if (
        pixels.begin(), pixels.end(), [] (const auto& p) { return p.second >= 50; });
    EXPECT_GT (seen, 50) << seed;
  }
}

TEST (Simulate, TheInsideOfHollowThingsIsSeenBehindTheirRims)
{
  const auto frame = simulate ("crockery", 2, Sensor::ideal);
  std::map<std::uint32_t, float> largest_step;
  for (std::size_t i = 640; i < frame.truth->size(); ++i) {
    const auto &point = (*frame.truth)[i], &above = (*frame.truth)[i - 640];
    if (point.object != 0 && point.object == above.object && point.label != above.label)
      largest_step[point.object] =
          std::max (largest_step[point.object], above.z - point.z);
  }
  ASSERT_EQ (frame.objects.size(), 10u);
  for (const auto& [object, step] : largest_step)
    EXPECT_EQ (step > 0.03f, object <= 7) << object;
}

TEST (Simulate, TheFloorHasObstaclesFrom1CmTo1M)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto frame = simulate ("floor_obstacles", seed, Sensor::ideal);
    std::map<std::uint32_t, float> height;
    for (const auto& point : *frame.truth)
      if (point.object != 0)
        height[point.object] = std::max (
            height[point.object], (frame.camera_to_base * point.getVector3fMap()).z());
    EXPECT_EQ (height.size(), 10u) << seed;
    EXPECT_NEAR (height[1], 0.01f, 1e-4f) << seed;
    const auto pixels = pixelsPerObject (frame);
    EXPECT_TRUE (std::all_of (pixels.begin(), pixels.end(), [] (const auto& p) {
      return p.second >= 50;
    })) << seed;
  }
}

/** All surfaces of this scene are planes, so that labels tell them apart. */
TEST (Simulate, EdgesAreWithin5PxOfAnotherSurface)
{
  const auto frame = simulate ("table_single", 2, Sensor::ideal);
  expectEdgesBetween (*frame.truth, *frame.truth);
}

TEST (Simulate, AnUnknownSceneIsRefusedWithTheKnownOnes)
{
  try {
    simulate ("attic", 0, Sensor::ideal);
    FAIL();
  }
  catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    EXPECT_NE (message.find ("attic"), std::string::npos);
    for (const auto& name : sceneNames())
      EXPECT_NE (message.find (name), std::string::npos);
  }
}

TEST (Subsample, TakesEveryNthPixel)
{
  pcl::PointCloud<TruthPoint> cloud (7, 5);
  for (std::uint32_t v = 0; v < 5; ++v)
    for (std::uint32_t u = 0; u < 7; ++u)
      cloud (u, v).label = 10 * v + u;
  const auto half = subsample (cloud, 2);
  ASSERT_EQ (half.width, 4u);
  ASSERT_EQ (half.height, 3u);
  EXPECT_EQ (half (0, 0).label, 0u);
  EXPECT_EQ (half (3, 2).label, 46u);
  EXPECT_EQ (subsample (cloud, 4).size(), 4u);
  EXPECT_TRUE (sameBytes (subsample (cloud, 1), cloud));
  EXPECT_THROW (subsample (cloud, 0), std::invalid_argument);
  EXPECT_EQ (subsample (cloud, 0xffffffff).size(), 1u);
  const std::vector<int> values (6);
  EXPECT_EQ (subsample (values, 3, 2).size(), 2u);
  EXPECT_THROW (subsample (values, 3, 0), std::invalid_argument);
  EXPECT_THROW (subsample (values, 0, 1), std::invalid_argument);
}
