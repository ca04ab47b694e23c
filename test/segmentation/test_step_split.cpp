// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_clouds.h"

#include <pcl/segmentation/impl/step_split.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace plane_clouds;
using pcl::rgbd_planes::DepthNoise;
using pcl::rgbd_planes::Plane;
using pcl::rgbd_planes::PlaneMoments;
using pcl::rgbd_planes::planeOf;
using pcl::rgbd_planes::PlaneSamples;
using pcl::rgbd_planes::StepSplit;

namespace {

/** Far beyond what noise does, and near enough for one plane. */
constexpr float near_depth = 1.f, far_depth = 1.011f;

/** The rectangle of a wall that faces the camera. */
Surface
board (float depth, int u0, int u1)
{
  return {{0.f, 0.f, -1.f}, depth, [=] (int u, int v) {
            return u >= u0 && u < u1 && v >= 100 && v < 240;
          }};
}

/** Planes as StepSplit takes them. */
class StepSplitTest : public testing::Test {
protected:
  /** Samples in columns of pixels before \a end belong to plane 0, others to plane 1. */
  void
  look (const std::vector<Surface>& surfaces, int end, float max_sigmas = 3.f)
  {
    const Scene scene =
        render (surfaces, 640, 480, [] (float z) { return 0.5f * kinectSigma (z); });
    const auto normals = trueNormals (scene, surfaces);
    samples_.compute (pcl::rgbd_planes::viewPoints (*scene.cloud),
                      {&(*normals)[0].normal_x,
                       &(*normals)[0].curvature,
                       sizeof (pcl::Normal) / sizeof (float)},
                      {},
                      DepthNoise{},
                      0.08f);
    owners_.assign (samples_.size(), -1);
    moments_.clear();
    for (int v = 0; v < samples_.height; ++v)
      for (int u = 0; u < samples_.width; ++u) {
        const std::size_t i = samples_.at (u, v);
        if (!samples_.isFree (i))
          continue;
        const std::size_t plane = u * samples_.step < end ? 0 : 1;
        moments_.resize (std::max (moments_.size(), plane + 1));
        const float p[] = {samples_.x[i], samples_.y[i], samples_.z[i]};
        moments_[plane].add (p, samples_.weight[i]);
        owners_[i] = static_cast<std::int32_t> (plane);
      }
    pcl::rgbd_planes::findTileParts (owners_, parts_);
    split_.compute (samples_, 25, max_sigmas, owners_, parts_, moments_);
    planes_.clear();
    for (const PlaneMoments& moments : moments_)
      planes_.push_back (planeOf (moments.inverseDistance()));
  }

  /** The owner of the sample in the middle of column \a u of pixels. */
  std::int32_t
  ownerIn (int u) const
  {
    return owners_[samples_.at (u / samples_.step, 180 / samples_.step)];
  }

  PlaneSamples samples_;
  std::vector<PlaneMoments> moments_;
  std::vector<std::int32_t> owners_;
  std::vector<pcl::rgbd_planes::TilePart> parts_;
  std::vector<Plane> planes_;
  StepSplit split_;
};

} // namespace

TEST_F (StepSplitTest, TheSmallerSideOfAStepBecomesAPlane)
{
  look ({board (near_depth, 0, 100), board (far_depth, 100, 160)}, 640);
  ASSERT_EQ (planes_.size(), 2u);
  EXPECT_EQ (ownerIn (50), 0);
  EXPECT_EQ (ownerIn (130), 1);
  EXPECT_NEAR (planes_[0].d, near_depth, 0.003f);
  EXPECT_NEAR (planes_[1].d, far_depth, 0.003f);
  EXPECT_EQ (split_.areSides(), (std::vector<bool>{true, true}));
}

TEST_F (StepSplitTest, ASideThatLiesOnAnotherPlaneGoesThere)
{
  look ({board (near_depth, 0, 100), board (far_depth, 100, 600)}, 160);
  ASSERT_EQ (planes_.size(), 2u);
  EXPECT_EQ (ownerIn (50), 0);
  EXPECT_EQ (ownerIn (130), 1);
  EXPECT_EQ (ownerIn (400), 1);
  EXPECT_NEAR (planes_[0].d, near_depth, 0.003f);
}

TEST_F (StepSplitTest, APlaneWithoutAStepStays)
{
  look ({board (near_depth, 0, 160)}, 640);
  EXPECT_EQ (planes_.size(), 1u);
  EXPECT_EQ (std::count (owners_.begin(), owners_.end(), 1), 0);
  EXPECT_EQ (split_.areSides(), std::vector<bool>{false});
}

/** Their errors may be those of the sensor. */
TEST_F (StepSplitTest, LargePlanesStayAtLowSteps)
{
  look ({board (near_depth, 0, 400), board (far_depth, 400, 640)}, 640);
  EXPECT_EQ (planes_.size(), 1u);
}

TEST_F (StepSplitTest, LargePlanesArePartedAtClearSteps)
{
  constexpr float recessed = 1.025f;
  look ({board (near_depth, 0, 320), board (recessed, 320, 640)}, 640);
  ASSERT_EQ (planes_.size(), 2u);
  EXPECT_NE (ownerIn (100), ownerIn (540));
  look ({board (near_depth, 0, 200),
         board (recessed, 200, 440),
         board (near_depth, 440, 640)},
        640);
  EXPECT_EQ (ownerIn (100), ownerIn (540));
  EXPECT_NE (ownerIn (100), ownerIn (320));
  for (const int u : {100, 320})
    EXPECT_NEAR (planes_[static_cast<std::size_t> (ownerIn (u))].d,
                 u == 320 ? recessed : near_depth,
                 0.003f);
}

TEST_F (StepSplitTest, WithinALargerReachLowStepsAreNone)
{
  look ({board (near_depth, 0, 100), board (far_depth, 100, 160)}, 640, 6.f);
  EXPECT_EQ (planes_.size(), 1u);
}

/** The plane that missed them was tilted by the step. */
TEST_F (StepSplitTest, SmallPlanesOnWhatIsLeftJoinIt)
{
  constexpr float recessed = 1.025f;
  look ({board (near_depth, 0, 150),
         board (recessed, 150, 600),
         board (recessed, 620, 640)},
        610);
  ASSERT_EQ (moments_.size(), 3u);
  EXPECT_EQ (ownerIn (30), 2);
  EXPECT_EQ (ownerIn (400), 0);
  EXPECT_EQ (ownerIn (630), 0);
  EXPECT_EQ (moments_[1].points, 0u);
  EXPECT_NEAR (planes_[0].d, recessed, 0.003f);
}
