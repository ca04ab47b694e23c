// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_clouds.h"

#include <pcl/segmentation/normal_space_plane_segmentation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace plane_clouds;
using pcl::rgbd_planes::PlaneExtraction;

namespace {

/** What is found with estimated normals. */
PlaneExtraction
extractWith (const Cloud::ConstPtr& cloud, bool drop_patches)
{
  pcl::rgbd_planes::PlaneAdditions additions;
  additions.patches = drop_patches;
  return extract (*cloud, *estimateNormals (cloud), additions);
}

/** The number of points on planes. */
std::size_t
labelled (const PlaneExtraction& extraction)
{
  const auto& labels = extraction.labels();
  return labels.size() -
         static_cast<std::size_t> (
             std::count (labels.begin(), labels.end(), pcl::rgbd_planes::unlabelled));
}

std::size_t
numberOfPlanes (const std::vector<Surface>& surfaces)
{
  return extractWith (render (surfaces, 640, 480, kinectSigma).cloud, true)
      .planes()
      .size();
}

/** The number of planes of a sensor with that noise. */
std::size_t
numberOfPlanes (const Cloud::ConstPtr& cloud, const pcl::rgbd_planes::DepthNoise& noise)
{
  Ours segmentation;
  segmentation.setDepthNoise (noise);
  Result result;
  segment (segmentation, cloud, result);
  return result.models.size();
}

/** A surface whose depth is \a depth (x, y) at x, y on the plane z = 1, seen from column
 * u0 to u1, with the noise of a Kinect. */
template <typename Depth>
Cloud::Ptr
relief (const Depth& depth, int u0, int u1)
{
  std::mt19937 generator (1);
  std::normal_distribution<float> gauss;
  auto cloud = pcl::make_shared<Cloud> (640, 480);
  for (int v = 0; v < 480; ++v)
    for (int u = 0; u < 640; ++u) {
      const float x = (static_cast<float> (u) - 319.5f) / 525.f,
                  y = (static_cast<float> (v) - 239.5f) / 525.f;
      const float true_z = u >= u0 && u < u1 ? depth (x, y) : synthetic::nan;
      const float z = true_z + kinectSigma (true_z) * gauss (generator);
      (*cloud) (u, v) = {x * z, y * z, z};
    }
  return cloud;
}

/** Walls 1.5 m away that meet at \a degrees: one that faces the camera, \a half columns
 * wide to both sides, and one on each side. */
std::vector<Surface>
foldedWall (int half, float degrees)
{
  constexpr float depth = 1.5f;
  const float x = static_cast<float> (half) / 525.f * depth,
              angle = pcl::deg2rad (degrees);
  const auto wall = [&] (float side, const std::function<bool (int, int)>& covers) {
    const Eigen::Vector3f normal (
        -side * std::sin (angle), 0.f, side == 0.f ? -1.f : -std::cos (angle));
    return Surface{
        normal, -normal.dot (Eigen::Vector3f (side * x, 0.f, depth)), covers};
  };
  return {wall (-1.f, [=] (int u, int) { return u < 320 - half; }),
          wall (0.f, [=] (int u, int) { return u >= 320 - half && u < 320 + half; }),
          wall (1.f, [=] (int u, int) { return u >= 320 + half; })};
}

} // namespace

TEST (CurvedPatches, PartsOfABallAreNoPlanes)
{
  const auto ball = relief (
      [] (float x, float y) { return 1.2f + 1.5f * (x * x + y * y); }, 160, 480);
  const PlaneExtraction without = extractWith (ball, false),
                        with = extractWith (ball, true);
  EXPECT_GE (labelled (without), ball->size() / 4);
  EXPECT_LE (labelled (with), labelled (without) / 4);
  EXPECT_EQ (with.rejections().curved + with.planes().size(),
             without.rejections().curved + without.planes().size());
}

TEST (CurvedPatches, PartsOfTanksAndVaultsAreNoPlanes)
{
  // Upright cylinders of this radius, whose near or far side is 2.5 m away.
  for (const float radius : {0.7f, 1.2f, 1.7f, 2.f})
    for (const float side : {-1.f, 1.f}) {
      const float axis = 2.5f - side * radius;
      const auto wall = relief (
          [=] (float x, float) {
            const float a = 1.f + x * x, c = axis * axis - radius * radius;
            return (axis + side * std::sqrt (axis * axis - a * c)) / a;
          },
          0,
          640);
      const std::size_t without = labelled (extractWith (wall, false)),
                        with = labelled (extractWith (wall, true));
      EXPECT_GE (without, wall->size() / 5) << radius << " m, " << side;
      EXPECT_LE (with, without / 8) << radius << " m, " << side;
    }
}

TEST (CurvedPatches, NormalsMayHaveAnySign)
{
  const auto ball = relief (
      [] (float x, float y) { return 1.2f + 1.5f * (x * x + y * y); }, 160, 480);
  const Normals::Ptr normals = estimateNormals (ball);
  Ours segmentation;
  segmentation.setInputCloud (ball);
  segmentation.setInputNormals (normals);
  Result facing, mixed;
  segment (segmentation, facing);
  const auto curved = segmentation.getRejections().curved;
  EXPECT_GT (curved, 0u);
  std::mt19937 random (1);
  for (auto& normal : *normals)
    if (random() % 2 == 0)
      normal.getNormalVector3fMap() *= -1.f;
  segment (segmentation, mixed);
  expectSame (mixed, facing);
  EXPECT_EQ (segmentation.getRejections().curved, curved);
}

TEST (CurvedPatches, FacesBetweenCreasesAreNone)
{
  for (const float degrees : {-60.f, -40.f, -30.f, 30.f, 40.f, 60.f})
    for (const int half : {60, 120})
      EXPECT_EQ (numberOfPlanes (foldedWall (half, degrees)), 3u)
          << degrees << " degrees, " << half;
}

TEST (CurvedPatches, AFaceThatGoesOnAtOneSideOnlyIsNone)
{
  for (const float degrees : {-20.f, 20.f}) {
    const auto walls = foldedWall (60, degrees);
    const auto part = [] (const Surface& wall) {
      return Surface{wall.normal, wall.d, [=] (int u, int v) {
                       return v >= 190 && v < 290 && u < 500 && wall.covers (u, v);
                     }};
    };
    EXPECT_EQ (numberOfPlanes ({part (walls[1]), part (walls[2])}), 2u)
        << degrees << " degrees";
  }
}

TEST (CurvedPatches, AStepBesideAPlaneIsNone)
{
  const std::vector<Surface> jamb{
      {{0.f, 0.f, -1.f}, 2.f, [] (int u, int) { return u < 400; }},
      {{0.f, 0.f, -1.f}, 2.05f, [] (int u, int) { return u >= 400; }}};
  EXPECT_EQ (numberOfPlanes (jamb), 2u);
}

TEST (CurvedPatches, AFarWallThatDepthBendsIsNone)
{
  // A radius of 10 m, about the error of depth of a Kinect at 4 m.
  const auto wall =
      relief ([] (float x, float y) { return 4.f + 0.8f * (x * x + y * y); }, 0, 640);
  const std::size_t planes = extractWith (wall, false).planes().size();
  EXPECT_GE (planes, 1u);
  EXPECT_EQ (extractWith (wall, true).planes().size(), planes);
}

TEST (CurvedPatches, FoldsThatStayNearAPlaneAreNone)
{
  // 2 cm deep to both sides, and 25 cm from one to the next.
  const auto folds = [] (float depth) {
    return relief (
        [=] (float x, float y) {
          return 2.f + depth * std::sin (50.f * x) * std::sin (50.f * y);
        },
        200,
        440);
  };
  const auto deep = folds (0.02f);
  EXPECT_GE (extractWith (deep, false).planes().size(), 1u);
  EXPECT_EQ (extractWith (deep, true).planes().size(), 0u);
  EXPECT_EQ (extractWith (folds (0.003f), true).planes().size(), 1u);

  pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> segmentation;
  segmentation.setInputCloud (deep);
  segmentation.setInputNormals (estimateNormals (deep));
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  EXPECT_EQ (segmentation.getMinimumNearNormals(), 0.75);
  segmentation.segment (models, inliers);
  EXPECT_TRUE (models.empty());
  segmentation.setMinimumNearNormals (0.);
  segmentation.segment (models, inliers);
  EXPECT_FALSE (models.empty());
}

TEST (CurvedPatches, NormalsOfStripsDoNotTellAndThoseOfWideWallsMayScatter)
{
  // Some of ten normals are off by 40 degrees, as their curvature tells.
  const auto isPlane = [] (int half_width, int half_height, std::size_t off) {
    Surface part = tiltedPlane (2.f, 0.f, 0.f);
    part.covers = [=] (int u, int v) {
      return std::abs (u - 320) < half_width && std::abs (v - 240) < half_height;
    };
    const std::vector<Surface> surfaces{part, tiltedPlane (4.f, 0.f, 0.f)};
    const Scene scene = render (surfaces, 640, 480, kinectSigma);
    const auto normals = trueNormals (scene, surfaces);
    for (std::size_t i = 0; i < normals->size(); ++i)
      if ((*scene.cloud)[i].z < 3.f && (i / 4 + i / 640 / 4) % 10 < off) {
        (*normals)[i].getNormalVector3fMap() =
            Eigen::Vector3f (0.f, std::sin (0.7f), -std::cos (0.7f));
        (*normals)[i].curvature = 0.1f;
      }
    return extract (*scene.cloud, *normals, {}).planes().size() == 2;
  };
  EXPECT_TRUE (isPlane (300, 12, 7));
  EXPECT_FALSE (isPlane (70, 70, 3)); // 0.53 m wide
  EXPECT_TRUE (isPlane (70, 70, 2));
  EXPECT_TRUE (isPlane (84, 84, 3)); // 0.64 m wide

  // Here it is a tenth of the image and more.
  EXPECT_FALSE (isPlane (100, 100, 8));
  EXPECT_TRUE (isPlane (70, 120, 3));
}

TEST (CurvedPatches, ACeilingSeenAtAFlatAngleIsNone)
{
  // Depth is off by what is a pixel away, as in synthetic recordings, up to 25 degrees of
  // the normals of a surface 0.4 m above the camera.
  std::mt19937 generator (1);
  std::uniform_int_distribution<int> shift (-1, 1);
  auto cloud = pcl::make_shared<Cloud> (640, 480);
  for (int v = 0; v < 480; ++v)
    for (int u = 0; u < 640; ++u) {
      const auto slope = [] (int row) {
        return (239.5f - static_cast<float> (row)) / 525.f;
      };
      const float z = v < 160 ? 0.4f / slope (v + shift (generator)) : synthetic::nan;
      (*cloud) (u,
                v) = {(static_cast<float> (u) - 319.5f) / 525.f * z, -slope (v) * z, z};
    }
  const PlaneExtraction extraction = extractWith (cloud, true);
  ASSERT_GE (extraction.planes().size(), 1u);
  EXPECT_GT (extraction.moments()[0].points, 640u * 160u * 9u / 10u);
}

/** Noise a little above what is set turned its normals towards the sensor, so that it was
 * taken for a part of an uneven surface. */
TEST (CurvedPatches, AWallInTheNoiseOfActiveStereoIsNone)
{
  const auto noise = pcl::rgbd_planes::DepthNoise::activeStereo();
  const auto sigma = [=] (float z) { return 1.2f * noise.sigmaAtSquare (z * z); };
  const auto wall = render ({tiltedPlane (3.5f, 30.f, 0.f)}, 640, 480, sigma).cloud;
  EXPECT_EQ (numberOfPlanes (wall, noise), 1u);
}

TEST (CurvedPatches, ABoardWhoseNormalsScatterAsWithActiveStereoIsNone)
{
  // Errors are drawn for every 14th pixel, and interpolated, which takes a third off.
  constexpr int side = 14, columns = 640 / side + 2;
  std::mt19937 generator (1);
  std::normal_distribution<float> gauss;
  std::vector<float> errors (columns * columns);
  for (float& error : errors)
    error = gauss (generator);
  auto noise = pcl::rgbd_planes::DepthNoise::activeStereo();
  // Before a wall, for what fills the view is no cloth.
  const auto board = relief (
      [&] (float x, float y) {
        if (std::max (std::abs (x), std::abs (y)) > 80.f / 525.f)
          return 3.f;
        const float u = (x * 525.f + 319.5f) / side, v = (y * 525.f + 239.5f) / side;
        const auto at = [&] (float column, float row) {
          return errors[static_cast<std::size_t> (row) * columns +
                        static_cast<std::size_t> (column)];
        };
        const float left = std::floor (u), top = std::floor (v);
        const float above =
            at (left, top) + (u - left) * (at (left + 1, top) - at (left, top));
        const float below = at (left, top + 1) +
                            (u - left) * (at (left + 1, top + 1) - at (left, top + 1));
        return 1.f +
               1.5f * noise.sigmaAtSquare (1.f) * (above + (v - top) * (below - above));
      },
      0,
      640);
  EXPECT_EQ (numberOfPlanes (board, noise), 2u);
  noise.normal_scatter = 1.f;
  EXPECT_EQ (numberOfPlanes (board, noise), 1u);
}
