// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "count_allocations.h"
#include "synthetic_clouds.h"
#include "tracked_rows.h"

#include <pcl/segmentation/plane_tracker.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

using namespace tracked_rows;

TEST (PlaneTracker, PlanesKeepTheirIdentityWhateverTheirOrder)
{
  pcl::PlaneTracker tracker;
  EXPECT_EQ (track (tracker, row ({wall, ground}, "aaaabbbb")), (Ids{0, 1}));
  EXPECT_EQ (track (tracker, row ({ground, wall}, "bbbbaaaa")), (Ids{1, 0}));
  EXPECT_EQ (track (tracker, row ({ground, wall}, "bbbaaaaa")), (Ids{1, 0}));
}

TEST (PlaneTracker, OtherNormalsAndDistancesAreOtherPlanes)
{
  pcl::PlaneTracker tracker;
  EXPECT_EQ (track (tracker, row ({wall}, "aaaa")), (Ids{0}));
  EXPECT_EQ (track (tracker, row ({ground}, "aaaa")), (Ids{1}));
  EXPECT_EQ (track (tracker, row ({plane (0.f, -1.f, 0.f, 2.5f)}, "aaaa")), (Ids{2}));
}

TEST (PlaneTracker, MoreThanHalfARadianOrAMetreIsAnotherPlane)
{
  const auto turned = [] (float angle) {
    return plane (std::sin (angle), 0.f, -std::cos (angle), 2.f);
  };
  for (const auto& [other, id] : {std::pair (turned (0.49f), 0u),
                                  {turned (0.51f), 1u},
                                  {plane (0.f, 0.f, -1.f, 2.99f), 0u},
                                  {plane (0.f, 0.f, -1.f, 3.01f), 1u}}) {
    pcl::PlaneTracker tracker;
    EXPECT_EQ (track (tracker, row ({wall}, "aaaa")), (Ids{0}));
    EXPECT_EQ (track (tracker, row ({other}, "aaaa")), (Ids{id}));
  }
}

TEST (PlaneTracker, TheMoreAPlaneHasChangedTheLessItsPixelsCount)
{
  for (const float gap : {0.1f, 0.3f, 0.8f}) {
    pcl::PlaneTracker tracker;
    const auto board = plane (0.f, 0.f, -1.f, 2.f - gap);
    EXPECT_EQ (track (tracker, row ({board, wall}, "aaaaabbb")), (Ids{0, 1}));
    EXPECT_EQ (track (tracker, row ({wall}, "aaaaaaaa")), (Ids{1}))
        << "what was behind a board that is gone";
  }
}

TEST (PlaneTracker, DistancesCountLessWhileTheCameraMoves)
{
  const auto wallAt = [] (float distance) { return plane (0.f, 0.f, -1.f, distance); };
  // Another wall tells whether it does. The floor does not tell that a robot drives.
  for (const auto& [other, then, id] : {std::tuple (wallAt (4.f), wallAt (4.f), 1u),
                                        {wallAt (4.f), wallAt (4.05f), 0u},
                                        {ground, ground, 0u}}) {
    pcl::PlaneTracker tracker;
    EXPECT_EQ (
        track (tracker, row ({wallAt (2.f), wallAt (2.06f), other}, "aaaaabbbcccc")),
        (Ids{0, 1, 2}));
    EXPECT_EQ (track (tracker, row ({wallAt (2.07f), then}, "aaaaaaaabbbb")),
               (Ids{id, 2}));
  }
}

/** Two walls 10 cm apart, of which the far one comes into view, 10 cm nearer in each frame. */
TEST (PlaneTracker, WallsKeepTheirIdentityWhileARobotDrivesTowardsThem)
{
  pcl::PlaneTracker tracker;
  const char* const frames[] = {"aaaabbbbbbbbbbbbcccccccc",
                                "aaaaabbbbbbbbbbbcccccccc",
                                "aaaaaabbbbbbbbbbcccccccc",
                                "aaaaaaabbbbbbbbbcccccccc"};
  float distance = 3.f;
  for (const char* frame : frames) {
    EXPECT_EQ (track (tracker,
                      row ({plane (0.f, 0.f, -1.f, distance),
                            plane (0.f, 0.f, -1.f, distance - 0.1f),
                            ground},
                           frame)),
               (Ids{0, 1, 2}))
        << frame;
    distance -= 0.1f;
  }
}

TEST (PlaneTracker, TheLargestPartOfAPlaneKeepsItsIdentity)
{
  pcl::PlaneTracker tracker;
  EXPECT_EQ (track (tracker, row ({wall}, "aaaaaaaa")), (Ids{0}));
  EXPECT_EQ (track (tracker, row ({wall, wall}, "aaabbbbb")), (Ids{1, 0}));
}

TEST (PlaneTracker, APlaneThatWasPartOfAnotherOneIsRecognized)
{
  pcl::PlaneTracker tracker;
  EXPECT_EQ (track (tracker, row ({wall, wall}, "aaaaabbb")), (Ids{0, 1}));
  EXPECT_EQ (track (tracker, row ({wall}, "aaaaaaaa")), (Ids{0}));
  EXPECT_EQ (track (tracker, row ({wall, wall}, "aaaaabbb")), (Ids{0, 1}));
}

TEST (PlaneTracker, HiddenPlanesAreRecognized)
{
  pcl::PlaneTracker tracker;
  const auto side_of_a_box = plane (-1.f, 0.f, 0.f, 0.5f);
  EXPECT_EQ (track (tracker, row ({wall, ground}, "aaaabbbb")), (Ids{0, 1}));
  EXPECT_EQ (track (tracker, row ({ground, side_of_a_box}, "bbbbbaaa")), (Ids{1, 2}));
  EXPECT_EQ (track (tracker, row ({ground, wall}, "bbbbaaaa")), (Ids{1, 0}));
}

TEST (PlaneTracker, PlanesHiddenByTwoOthersAreRecognized)
{
  pcl::PlaneTracker tracker;
  const auto front = plane (0.6f, 0.f, -0.8f, 0.6f),
             side = plane (-1.f, 0.f, 0.f, 0.5f);
  EXPECT_EQ (track (tracker, row ({wall, front, side}, "aaaabbbbbbcccccc")),
             (Ids{0, 1, 2}));
  EXPECT_EQ (track (tracker, row ({front, side}, "aaaaaabbbbbb....")), (Ids{1, 2}));
  EXPECT_EQ (track (tracker, row ({front, side}, "aabbbbbbbb......")), (Ids{1, 2}));
  EXPECT_EQ (track (tracker, row ({side}, "aaaaaaaa........")), (Ids{2}));
  EXPECT_EQ (track (tracker, row ({wall, side}, "aaaabbbb........")), (Ids{0, 2}));
}

TEST (PlaneTracker, WhereAPlaneIsSeenNoMoreOthersAreNotTakenForIt)
{
  pcl::PlaneTracker tracker;
  const auto step = plane (0.f, -1.f, 0.f, 0.8f);
  EXPECT_EQ (track (tracker, row ({ground}, "aaaaaaaa")), (Ids{0}));
  EXPECT_EQ (track (tracker, row ({ground}, "a.......")), (Ids{0}));
  EXPECT_EQ (track (tracker, row ({step}, ".aaaaaaa")), (Ids{1}));
}

TEST (PlaneTracker, PlanesThatAreNotFoundAreRememberedFor15Frames)
{
  for (const int missing : {1, 15, 16, 40}) {
    pcl::PlaneTracker tracker;
    EXPECT_EQ (track (tracker, row ({wall, ground}, "aaaabbbb")), (Ids{0, 1}));
    for (int i = 0; i < missing; ++i)
      EXPECT_EQ (track (tracker, row ({ground}, "....aaaa")), (Ids{1}));
    const std::uint32_t expected = missing <= 15 ? 0 : 2;
    EXPECT_EQ (track (tracker, row ({ground, wall}, "bbbbaaaa")), (Ids{1, expected}))
        << missing << " frames";
  }
}

TEST (PlaneTracker, WhereAPlaneWasForgottenNoOtherOneIsKnown)
{
  pcl::PlaneTracker tracker;
  EXPECT_EQ (track (tracker, row ({wall}, "aa..")), (Ids{0}));
  for (int i = 0; i < 15; ++i)
    track (tracker, row ({}, "...."));
  EXPECT_EQ (track (tracker, row ({wall}, "..aa")), (Ids{1}));
  EXPECT_EQ (track (tracker, row ({wall}, "aa..")), (Ids{2}));
}

TEST (PlaneTracker, PlanesMayMoveFarFrameByFrame)
{
  pcl::PlaneTracker tracker;
  for (const float distance : {2.f, 2.6f, 3.2f, 3.8f})
    EXPECT_EQ (track (tracker, row ({plane (0.f, 0.f, -1.f, distance)}, "aaaa")),
               (Ids{0}))
        << distance;
}

TEST (PlaneTracker, WhatAPlaneLeftCountsOnlyWhileItIsNotFound)
{
  pcl::PlaneTracker tracker;
  const auto behind = plane (0.f, 0.f, -1.f, 2.9f);
  const auto between = plane (0.f, 0.f, -1.f, 2.6f); // nearer to the one behind
  EXPECT_EQ (track (tracker, row ({behind, wall}, "aaaaaaab")), (Ids{0, 1}));
  EXPECT_EQ (track (tracker, row ({behind, wall}, "abbbbbbb")), (Ids{0, 1}));
  EXPECT_EQ (track (tracker, row ({between}, "aaaaaaaa")), (Ids{1}));
}

TEST (PlaneTracker, WhatAForgottenPlaneLeftIsOfNoOtherOne)
{
  pcl::PlaneTracker tracker;
  EXPECT_EQ (track (tracker, row ({wall}, "aaaa....")), (Ids{0}));
  for (int i = 0; i < 17; ++i)
    EXPECT_EQ (track (tracker, row ({ground}, "aaaa....")), (Ids{1}));
  EXPECT_EQ (track (tracker, row ({ground, wall}, "aaaabbbb")), (Ids{1, 2}));
  EXPECT_EQ (track (tracker, row ({ground}, "aaaa....")), (Ids{1}));
  EXPECT_EQ (track (tracker, row ({wall}, "aaaa....")), (Ids{3}));
}

TEST (PlaneTracker, IdentitiesAreNeverUsedAgain)
{
  pcl::PlaneTracker tracker;
  std::uint32_t expected = 0;
  for (int i = 0; i < 100; ++i)
    EXPECT_EQ (
        track (tracker, row ({i % 2 ? wall : ground}, i % 4 < 2 ? "aa.." : "..aa")),
        (Ids{i < 4 ? expected++ : static_cast<std::uint32_t> (i % 4)}));
}

namespace {

/** A corner of a room with boxes, seen by a camera that moves sideways and turns, 30 frames of
 * a second; labels are those of the truth in an order that changes. */
std::vector<Image>
simulatedSequence ()
{
  const auto in_columns = [] (int from, int to) {
    return [=] (int u, int v) { return u >= from && u < to && v > 40 && v < 90; };
  };
  std::vector<Image> sequence;
  for (int k = 0; k < 30; ++k) {
    const float t = static_cast<float> (k) / 30.f;
    const int moved = 2 * k;
    const Eigen::Matrix3f turn =
        Eigen::AngleAxisf (0.3f * t, Eigen::Vector3f::UnitY()).toRotationMatrix();
    const auto seen = [&] (const Eigen::Vector3f& normal, float d) {
      return synthetic::Surface{turn * normal, d + 0.5f * t * normal.x()};
    };
    std::vector<synthetic::Surface> surfaces{seen ({0.f, 0.f, -1.f}, 4.f),
                                             seen ({0.f, -1.f, 0.f}, 1.2f),
                                             seen ({-0.8f, 0.f, -0.6f}, 2.4f),
                                             seen ({0.f, 0.f, -1.f}, 2.f),
                                             seen ({0.f, 0.f, -1.f}, 1.8f)};
    surfaces[3].covers = in_columns (10 + moved, 40 + moved);
    surfaces[4].covers = in_columns (50 + moved, 90 + moved);
    const auto scene = synthetic::render (surfaces, 160, 120);
    Image image;
    image.labels.resize (160u, 120u);
    const auto first = static_cast<std::size_t> (k) % surfaces.size();
    for (std::size_t p = 0; p < surfaces.size(); ++p) {
      const auto& surface = surfaces[(p + first) % surfaces.size()];
      image.models.push_back (plane (
          surface.normal.x(), surface.normal.y(), surface.normal.z(), surface.d));
    }
    for (std::size_t i = 0; i < scene.surface.size(); ++i)
      image.labels[i].label = scene.surface[i] < 0
                                  ? unlabelled
                                  : static_cast<std::uint32_t> (
                                        (static_cast<std::size_t> (scene.surface[i]) +
                                         surfaces.size() - first) %
                                        surfaces.size());
    sequence.push_back (image);
  }
  return sequence;
}

} // namespace

TEST (PlaneTracker, SurfacesKeepTheirIdentityWhileTheCameraMoves)
{
  pcl::PlaneTracker tracker;
  const auto sequence = simulatedSequence();
  for (std::size_t k = 0; k < sequence.size(); ++k) {
    const auto ids = track (tracker, sequence[k]);
    ASSERT_EQ (ids.size(), 5u);
    for (std::size_t p = 0; p < ids.size(); ++p)
      EXPECT_EQ (ids[p], (p + k) % 5) << "frame " << k;
  }
}

TEST (PlaneTracker, NoAllocationsForFramesLikeThoseBefore)
{
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "allocations are not counted together with the address sanitizer";
#endif
  pcl::PlaneTracker tracker;
  const auto sequence = simulatedSequence();
  Ids ids;
  for (const int round : {0, 1, 2})
    for (const auto& image : sequence) {
      const std::size_t before = allocations;
      tracker.track (image.models, image.labels, ids);
      if (round == 0 && &image == &sequence.front()) {
        EXPECT_GT (allocations, before) << "the counter sees nothing";
      }
      if (round == 2) {
        EXPECT_EQ (allocations, before);
      }
    }
}
