// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "addition_scenes.h"

#include <pcl/common/angles.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace addition_scenes;
using namespace plane_clouds;

namespace {

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

} // namespace

TEST (CandidateAdditions, PointsAtCreasesStartNoCluster)
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

TEST (CandidateAdditions, NormalsAreTrustedUpToHalfOfTheLargestCurvature)
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

TEST (CandidateAdditions, NoiseGrowsWithRange)
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

TEST (CandidateAdditions, PeaksHoldThePlaneOfASlightlyWrongNormal)
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

TEST (CandidateAdditions, PartsTellPlanesOfNearlyTheSameDistanceApart)
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

TEST (CandidateAdditions, GrowthTakesPointsWithoutANormal)
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

TEST (CandidateAdditions, BendsPartARampFromTheFloorAndAPlatform)
{
  {
    SCOPED_TRACE ("no platform");
    expectBendsMatter (rampToPlatform (7.f, 1.6f, 10.f), 2);
  }
  expectBendsMatter (rampToPlatform (10.f, 1.2f, 2.f), 3);
}

TEST (CandidateAdditions, CurvedCandidatesAreRefused)
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
  additions.patches = false;
  EXPECT_GE (extract (cloud, normals, additions).rejections().curved, 1u);
  additions.curved = false;
  const PlaneExtraction without = extract (cloud, normals, additions);
  EXPECT_EQ (without.rejections().curved, 0u);
  EXPECT_GE (labelled (without), 0.8);
}

TEST (CandidateAdditions, RepeatFindsWhatWasInTheClusterOfAnother)
{
  // Bins are 16 mm wide, and there is no minimum between distances 31 mm apart.
  const std::vector<Surface> steps{
      strip (1.008f, 0, 260), strip (1.039f, 260, 380), strip (1.008f, 380, 640)};
  PlaneAdditions additions;
  EXPECT_EQ (extract (steps, additions).planes().size(), 2u);
  additions.repeat = false;
  EXPECT_EQ (extract (steps, additions).planes().size(), 1u);
}

TEST (CandidateAdditions, RepeatFindsPlanesWhoseNormalsScatter)
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
