// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_clouds.h"

#include <pcl/common/angles.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

// Scenes on which it is known what comes of leaving out one addition.

using namespace plane_clouds;
using pcl::rgbd_planes::PlaneAdditions;
using pcl::rgbd_planes::PlaneExtraction;
using pcl::rgbd_planes::unlabelled;

namespace {

using plane_clouds::extract;

PlaneExtraction
extract (const std::vector<Surface>& surfaces, const PlaneAdditions& additions)
{
  const Scene scene = render (surfaces);
  return extract (*scene.cloud, *trueNormals (scene, surfaces), additions);
}

/** The surface through (0, 0, depth) that faces the camera, from column u0 to u1. */
Surface
strip (float depth, int u0, int u1)
{
  return {{0.f, 0.f, -1.f}, depth, [=] (int u, int) { return u >= u0 && u < u1; }};
}

/** The labels in columns u0 to u1. */
std::set<std::uint32_t>
labelsIn (const PlaneExtraction& extraction, int u0, int u1)
{
  std::set<std::uint32_t> labels;
  for (std::size_t i = 0; i < extraction.labels().size(); ++i)
    if (i % 640 >= static_cast<std::size_t> (u0) &&
        i % 640 < static_cast<std::size_t> (u1))
      labels.insert (extraction.labels()[i]);
  return labels;
}

using Labels = std::set<std::uint32_t>;

} // namespace

TEST (PlaneAdditions, PointsAtCreasesStartNoCluster)
{
  const std::vector<Surface> wall{tiltedPlane (1.f, 0.f, 0.f)};
  const Scene scene = render (wall);
  const auto normals = trueNormals (scene, wall);
  // Wrong by 45 degrees, as the curvature tells.
  for (int v = 0; v < 480; ++v)
    for (int u = 200; u < 300; ++u) {
      (*normals) (u, v).getNormalVector3fMap() =
          Eigen::Vector3f (std::sqrt (0.5f), 0.f, -std::sqrt (0.5f));
      (*normals) (u, v).curvature = 0.1f;
    }
  PlaneAdditions additions;
  EXPECT_EQ (labelsIn (extract (*scene.cloud, *normals, additions), 0, 640), Labels{0});
  additions.creases = false;
  EXPECT_EQ (labelsIn (extract (*scene.cloud, *normals, additions), 220, 280).count (0),
             0u);
}

TEST (PlaneAdditions, NormalsAreTrustedUpToHalfOfTheLargestCurvature)
{
  const std::vector<Surface> wall{tiltedPlane (1.f, 0.f, 0.f)};
  const Scene scene = render (wall);
  const auto normals = trueNormals (scene, wall);
  const auto setCurvature = [&] (float curvature, int u0, int u1) {
    for (int v = 0; v < 480; ++v)
      for (int u = u0; u < u1; ++u)
        (*normals) (u, v).curvature = curvature;
  };
  setCurvature (0.1f, 0, 640);
  EXPECT_TRUE (extract (*scene.cloud, *normals, {}).planes().empty());
  setCurvature (0.05f, 0, 640);
  EXPECT_EQ (extract (*scene.cloud, *normals, {}).planes().size(), 1u);

  for (int v = 0; v < 480; ++v)
    for (int u = 200; u < 300; ++u)
      (*normals) (u, v).getNormalVector3fMap() =
          Eigen::Vector3f (std::sqrt (0.5f), 0.f, -std::sqrt (0.5f));
  EXPECT_EQ (labelsIn (extract (*scene.cloud, *normals, {}), 0, 640), Labels{0});
  setCurvature (0.03f, 0, 640);
  EXPECT_EQ (labelsIn (extract (*scene.cloud, *normals, {}), 220, 280).count (0), 0u);
}

TEST (PlaneAdditions, NoiseGrowsWithRange)
{
  const std::vector<Surface> wall{tiltedPlane (5.f, 0.f, 0.f)};
  const Scene scene = render (wall, 640, 480, kinectSigma);
  const auto normals = trueNormals (scene, wall);
  const auto share = [&] (const PlaneAdditions& additions) {
    const PlaneExtraction extraction = extract (*scene.cloud, *normals, additions);
    return static_cast<double> (extraction.moments()[0].points) / (640. * 480.);
  };
  PlaneAdditions additions;
  EXPECT_GE (share (additions), 0.98);
  additions.noise = false;
  // Three standard deviations are 57 mm then, of points that spread by 51 mm.
  EXPECT_NEAR (share (additions), std::erf (57. / 51. / std::sqrt (2.)), 0.1);
}

TEST (PlaneAdditions, PeaksHoldThePlaneOfASlightlyWrongNormal)
{
  // Its distances along a normal 6 degrees off spread over more than merged bins.
  const std::vector<Surface> surfaces{
      {{0.f, 0.f, -1.f}, 1.2f, [] (int u, int v) {
         return std::abs (u - 320) + std::abs (v - 240) < 200;
       }}};
  const Scene scene = render (surfaces);
  const auto normals = trueNormals (scene, {{tiltedPlane (1.f, 0.f, 6.f).normal, 0.f}});
  PlaneAdditions additions;
  additions.parts = additions.growth = additions.repeat = additions.joining = false;
  EXPECT_EQ (extract (*scene.cloud, *normals, additions).planes().size(), 1u);
  additions.peaks = false;
  EXPECT_GE (extract (*scene.cloud, *normals, additions).planes().size(), 2u);
}

TEST (PlaneAdditions, PartsTellPlanesOfNearlyTheSameDistanceApart)
{
  const std::vector<Surface> boards{strip (1.f, 40, 240), strip (1.014f, 400, 600)};
  PlaneAdditions additions;
  const PlaneExtraction apart = extract (boards, additions);
  ASSERT_EQ (apart.planes().size(), 2u);
  for (const auto& plane : apart.planes())
    EXPECT_LE (synthetic::angleDegrees (plane.normal, {0.f, 0.f, -1.f}), 0.01f);
  additions.parts = false;
  const PlaneExtraction through_both = extract (boards, additions);
  ASSERT_EQ (through_both.planes().size(), 1u);
  EXPECT_GE (
      synthetic::angleDegrees (through_both.planes()[0].normal, {0.f, 0.f, -1.f}),
      0.5f);
}

TEST (PlaneAdditions, GrowthTakesPointsWithoutANormal)
{
  const std::vector<Surface> wall{tiltedPlane (1.f, 0.f, 0.f)};
  const Scene scene = render (wall);
  const auto normals = trueNormals (scene, wall);
  for (int v = 0; v < 480; ++v)
    for (int u = 200; u < 300; ++u)
      (*normals) (u, v).getNormalVector3fMap().setConstant (synthetic::nan);
  PlaneAdditions additions;
  additions.assignment = false;
  EXPECT_EQ (labelsIn (extract (*scene.cloud, *normals, additions), 200, 300),
             Labels{0});
  additions.growth = false;
  EXPECT_EQ (labelsIn (extract (*scene.cloud, *normals, additions), 200, 300),
             Labels{unlabelled});
}

/** A ramp from \a begin to \a end, ahead of a camera 1 m above the floor that looks down by 30
 * degrees; a platform at its end; and the floor. */
std::vector<Surface>
rampToPlatform (float degrees, float begin, float end)
{
  const float slope = std::tan (pcl::deg2rad (degrees));
  const Eigen::Vector3f forward (0.f, -0.5f, std::sqrt (0.75f)),
      up (0.f, -std::sqrt (0.75f), -0.5f);
  const Eigen::Vector3f normal = (up - slope * forward).normalized();
  const auto between =
      [=] (const Eigen::Vector3f& n, float d, float first, float last) -> Surface {
    return {n, d, [=] (int u, int v) {
              const Eigen::Vector3f ray (
                  (u - 319.5f) / 525.f, (v - 239.5f) / 525.f, 1.f);
              const float ahead = -d / ray.dot (n) * ray.dot (forward);
              return ahead > first && ahead <= last;
            }};
  };
  return {between (normal, -normal.dot (begin * forward - up), begin, end),
          between (up, 1.f - slope * (end - begin), end, 10.f),
          {up, 1.f}};
}

void
expectBendsMatter (const std::vector<Surface>& surfaces, std::size_t seen)
{
  const Scene scene =
      render (surfaces, 640, 480, [] (float z) { return 0.5f * kinectSigma (z); });
  const auto normals = estimateNormals (scene.cloud);
  const auto countFound = [&] (const PlaneExtraction& extraction) {
    return static_cast<std::size_t> (
        std::count_if (surfaces.begin(), surfaces.end(), [&] (const auto& surface) {
          const auto& planes = extraction.planes();
          return std::any_of (planes.begin(), planes.end(), [&] (const auto& plane) {
            return plane.normal.dot (surface.normal) > std::cos (pcl::deg2rad (0.5f)) &&
                   std::abs (plane.d - surface.d) < 0.01f;
          });
        }));
  };
  PlaneAdditions additions;
  const PlaneExtraction parted = extract (*scene.cloud, *normals, additions);
  EXPECT_EQ (parted.planes().size(), seen);
  EXPECT_EQ (countFound (parted), seen);
  additions.bends = false;
  EXPECT_LT (countFound (extract (*scene.cloud, *normals, additions)), seen);
}

TEST (PlaneAdditions, BendsPartARampFromTheFloorAndAPlatform)
{
  {
    SCOPED_TRACE ("no platform");
    expectBendsMatter (rampToPlatform (7.f, 1.6f, 10.f), 2);
  }
  expectBendsMatter (rampToPlatform (10.f, 1.2f, 2.f), 3);
}

TEST (PlaneAdditions, CurvedCandidatesAreRefused)
{
  // A cylinder of 0.1 m around the vertical line 1.1 m away.
  constexpr float radius = 0.1f, axis = 1.1f;
  Cloud cloud (640, 480);
  Normals normals (640, 480);
  for (int v = 0; v < 480; ++v)
    for (int u = 0; u < 640; ++u) {
      const float x = (u - 319.5f) / 525.f, y = (v - 239.5f) / 525.f;
      const float root = axis * axis - (1.f + x * x) * (axis * axis - radius * radius);
      const float z = (axis - std::sqrt (root)) / (1.f + x * x);
      cloud (u, v) = {x * z, y * z, z};
      normals (u, v).getNormalVector3fMap() =
          Eigen::Vector3f (x * z, 0.f, z - axis) / radius;
    }
  const auto labelled = [&] (const PlaneExtraction& extraction) {
    std::size_t seen = 0, on_planes = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      seen += std::isfinite (cloud[i].z);
      on_planes += extraction.labels()[i] != unlabelled;
    }
    return static_cast<double> (on_planes) / static_cast<double> (seen);
  };
  PlaneAdditions additions;
  const PlaneExtraction with = extract (cloud, normals, additions);
  EXPECT_GE (with.rejections().curved, 1u);
  EXPECT_LE (labelled (with), 0.2);
  additions.curved = additions.patches = false;
  const PlaneExtraction without = extract (cloud, normals, additions);
  EXPECT_EQ (without.rejections().curved, 0u);
  EXPECT_GE (labelled (without), 0.8);
}

TEST (PlaneAdditions, RepeatFindsWhatWasInTheClusterOfAnother)
{
  // Bins are 16 mm wide, and there is no minimum between distances 31 mm apart.
  const std::vector<Surface> steps{
      strip (1.008f, 0, 260), strip (1.039f, 260, 380), strip (1.008f, 380, 640)};
  PlaneAdditions additions;
  EXPECT_EQ (extract (steps, additions).planes().size(), 2u);
  additions.repeat = false;
  EXPECT_EQ (extract (steps, additions).planes().size(), 1u);
}

TEST (PlaneAdditions, RepeatFindsPlanesWhoseNormalsScatter)
{
  // Samples in turn 9 degrees to the left and to the right; too few of a kind touch.
  const std::vector<Surface> box{{{0.f, 0.f, -1.f}, 1.5f, [] (int u, int v) {
                                    return u >= 200 && u < 360 && v >= 200 && v < 232;
                                  }}};
  const Scene scene = render (box);
  const auto normals = trueNormals (scene, box);
  for (int v = 200; v < 232; ++v)
    for (int u = 200; u < 360; ++u) {
      const float turn = u / 4 % 2 == 0 ? 0.15f : -0.15f;
      (*normals) (u, v).getNormalVector3fMap() << std::sin (turn), 0.f,
          -std::cos (turn);
    }
  PlaneAdditions additions;
  EXPECT_EQ (extract (*scene.cloud, *normals, additions).planes().size(), 1u);
  additions.repeat = false;
  EXPECT_EQ (extract (*scene.cloud, *normals, additions).planes().size(), 0u);
}

TEST (PlaneAdditions, JoiningUnitesAWallBehindAColumn)
{
  const std::vector<Surface> wall{strip (2.f, 0, 250), strip (2.f, 350, 640)};
  PlaneAdditions additions;
  EXPECT_EQ (extract (wall, additions).planes().size(), 1u);
  additions.joining = false;
  EXPECT_EQ (extract (wall, additions).planes().size(), 2u);
}

TEST (PlaneAdditions, JoiningUnitesWhatMuchNoiseParts)
{
  const Scene scene = render ({tiltedPlane (0.8f, 60.f, 0.f)}, 640, 480, [] (float z) {
    return 2.5f * kinectSigma (z);
  });
  const auto normals = estimateNormals (scene.cloud);
  PlaneAdditions additions;
  EXPECT_EQ (extract (*scene.cloud, *normals, additions).planes().size(), 1u);
  additions.joining = false;
  EXPECT_GE (extract (*scene.cloud, *normals, additions).planes().size(), 2u);
}

TEST (PlaneAdditions, StepsPartTheEdgeOfATableFromItsLegs)
{
  // Both legs lie 12 mm behind the edge.
  const auto isLeg = [] (int u, int v) {
    return v >= 232 && v < 352 && ((u >= 80 && u < 108) || (u >= 500 && u < 528));
  };
  const std::vector<Surface> table{
      {{0.f, 0.f, -1.f},
       1.2f,
       [] (int u, int v) { return u >= 60 && u < 540 && v >= 200 && v < 232; }},
      {{0.f, 0.f, -1.f}, 1.212f, isLeg}};
  const Scene scene =
      render (table, 640, 480, [] (float z) { return 0.5f * kinectSigma (z); });
  const auto normals = trueNormals (scene, table);
  PlaneAdditions additions;
  const PlaneExtraction parted = extract (*scene.cloud, *normals, additions);
  ASSERT_EQ (parted.planes().size(), 2u);
  EXPECT_NEAR (parted.planes()[0].d, 1.2f, 0.003f);
  EXPECT_NEAR (parted.planes()[1].d, 1.212f, 0.003f);
  EXPECT_EQ (parted.labels()[300 * 640 + 90], 1u);
  EXPECT_EQ (parted.labels()[300 * 640 + 510], 1u);
  additions.steps = false;
  EXPECT_EQ (extract (*scene.cloud, *normals, additions).planes().size(), 1u);
}

TEST (PlaneAdditions, StripsJoinTheLegsOfATable)
{
  // Turned against each other, as warped depth does: within noise, but the plane of one leg
  // passes the other one at 5 cm.
  const auto leg = [] (int u0, float turn) -> Surface {
    const Eigen::Vector3f normal (std::sin (turn), 0.f, -std::cos (turn));
    const float x = (static_cast<float> (u0) + 10.f - 319.5f) / 525.f * 1.2f;
    return {normal, -normal.dot (Eigen::Vector3f (x, 0.f, 1.2f)), [=] (int u, int v) {
              return u >= u0 && u < u0 + 20 && v >= 150 && v < 350;
            }};
  };
  const std::vector<Surface> table{leg (80, 0.05f), leg (510, -0.05f)};
  const Scene scene =
      render (table, 640, 480, [] (float z) { return 0.3f * kinectSigma (z); });
  const auto normals = trueNormals (scene, table);
  PlaneAdditions additions;
  const PlaneExtraction joined = extract (*scene.cloud, *normals, additions);
  ASSERT_EQ (joined.planes().size(), 1u);
  EXPECT_GT (joined.moments()[0].points, 7000u);
  additions.strips = false;
  EXPECT_EQ (extract (*scene.cloud, *normals, additions).planes().size(), 2u);
}

TEST (PlaneAdditions, AssignmentIsExactToThePixel)
{
  const std::vector<Surface> steps{strip (1.f, 0, 322), strip (1.5f, 322, 640)};
  PlaneAdditions additions;
  EXPECT_EQ (labelsIn (extract (steps, additions), 320, 322), Labels{0});
  additions.assignment = false;
  // Samples stand for 4 x 4 pixels, here from column 320 on, and see column 322.
  EXPECT_EQ (labelsIn (extract (steps, additions), 316, 320), Labels{0});
  EXPECT_EQ (labelsIn (extract (steps, additions), 320, 322), Labels{1});
}

/** Such as the foot of a thing that stands on a table, within noise of both. */
TEST (PlaneAdditions, AssignmentLeavesOutWhatFacesElsewhereAndIsOnNoPlane)
{
  const std::vector<Surface> wall{tiltedPlane (1.f, 0.f, 0.f)};
  const Scene scene = render (wall);
  const auto normals = trueNormals (scene, wall);
  const int u0 = 300, u1 = 320, v0 = 200, v1 = 220;
  for (int v = v0; v < v1; ++v)
    for (int u = u0; u < u1; ++u)
      (*normals) (u, v).getNormalVector3fMap() = -Eigen::Vector3f::UnitY();
  const PlaneExtraction extraction = extract (*scene.cloud, *normals, {});
  for (int v = 0; v < 480; ++v)
    for (int u = 0; u < 640; ++u) {
      const bool inside = u >= u0 && u < u1 && v >= v0 && v < v1;
      ASSERT_EQ (extraction.labels()[static_cast<std::size_t> (v * 640 + u)],
                 inside ? unlabelled : 0u)
          << u << ", " << v;
    }
}

TEST (PlaneAdditions, IntersectionsLeaveOutWhatTurnsAGrazingPlane)
{
  // A ceiling at 1 m above the sensor, from 4.5 m to the wall at 5 m.
  std::vector<Surface> room{
      {{0.f, 0.f, -1.f}, 5.f, [] (int, int v) { return v >= 135; }},
      {{0.f, 1.f, 0.f}, 1.f, [] (int, int v) { return v >= 123 && v < 135; }}};
  const Scene scene = render (room, 640, 480, kinectSigma);
  const auto normals = trueNormals (scene, room);
  const PlaneExtraction found = extract (*scene.cloud, *normals, PlaneAdditions());
  ASSERT_EQ (found.planes().size(), 2u);
  for (const auto& plane : found.planes()) {
    const Surface& surface = room[plane.normal[1] > .5f];
    EXPECT_LT (plane.normal.cross (surface.normal).norm(), .0005f);
    EXPECT_NEAR (plane.d, surface.d, .001f);
  }
}

TEST (PlaneAdditions, IntersectionsSayWherePlanesEnd)
{
  // Walls that meet flatly, as those of a bay window, seen from inside and from outside.
  for (const float turn : {15.f, -15.f}) {
    std::vector<Surface> walls{tiltedPlane (2.5f, 0.f, turn),
                               tiltedPlane (2.5f, 0.f, -turn)};
    walls[0].covers = [] (int u, int) { return u < 320; };
    walls[1].covers = [] (int u, int) { return u >= 320; };
    const Scene scene = render (walls, 640, 480, kinectSigma);
    const auto normals = trueNormals (scene, walls);
    const auto wrong = [&] (const PlaneAdditions& additions) {
      const PlaneExtraction found = extract (*scene.cloud, *normals, additions);
      EXPECT_EQ (found.planes().size(), 2u);
      const std::uint32_t first = found.labels()[240 * 640 + 10];
      std::size_t number = 0;
      for (std::size_t i = 0; i < found.labels().size(); ++i)
        number += found.labels()[i] != unlabelled &&
                  (found.labels()[i] == first) != (scene.surface[i] == 0);
      return number;
    };
    PlaneAdditions additions;
    const std::size_t with = wrong (additions);
    additions.intersections = false;
    EXPECT_LT (4 * with, wrong (additions)) << turn << ": " << with;
  }
}
