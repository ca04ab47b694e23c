// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "addition_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace addition_scenes;
using namespace plane_clouds;

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

namespace {

/** A wall at 1 m, where a thing stands 5 cm in front of columns 300 to 339 and, beside it, columns
 * 292 to 299 are \a ahead of the wall, by more than noise, with normals that say so or not. */
PlaneExtraction
extractFoot (float ahead, bool stands_out, bool has_normals_of_wall)
{
  const std::vector<Surface> wall{tiltedPlane (1.f, 0.f, 0.f)};
  const Scene scene = render (wall);
  const auto normals = trueNormals (scene, wall);
  for (int v = 0; v < 480; ++v)
    for (int u = 292; u < 340; ++u) {
      const bool is_foot = u < 300;
      if (is_foot || stands_out)
        (*scene.cloud) (u, v).getVector3fMap() *= 1.f - (is_foot ? ahead : 0.05f);
      if (is_foot ? !has_normals_of_wall : stands_out)
        (*normals) (u, v).getNormalVector3fMap().setConstant (synthetic::nan);
    }
  return extract (*scene.cloud, *normals, {});
}

} // namespace

TEST (PlaneAdditions, AssignmentLeavesOutTheFootOfWhatStandsOut)
{
  const float ahead = 0.005f;
  const PlaneExtraction foot = extractFoot (ahead, true, false);
  EXPECT_EQ (labelsIn (foot, 292, 300), Labels{unlabelled});
  EXPECT_EQ (labelsIn (foot, 288, 292), Labels{0});
  EXPECT_EQ (foot.moments()[0].points,
             static_cast<std::size_t> (
                 std::count (foot.labels().begin(), foot.labels().end(), 0u)));
  const Labels on_wall{0};
  EXPECT_EQ (labelsIn (extractFoot (ahead, false, false), 292, 300), on_wall);
  EXPECT_EQ (labelsIn (extractFoot (ahead, true, true), 292, 300), on_wall);
  EXPECT_EQ (labelsIn (extractFoot (-ahead, true, false), 292, 300), on_wall);
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
