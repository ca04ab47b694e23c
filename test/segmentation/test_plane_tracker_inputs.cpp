// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "tracked_rows.h"

#include <pcl/segmentation/plane_tracker.h>

#include <gtest/gtest.h>

#include <limits>
#include <utility>

using namespace tracked_rows;

TEST (PlaneTrackerInputs, FramesWithoutPlanesOrPixels)
{
  pcl::PlaneTracker tracker;
  EXPECT_EQ (track (tracker, {}), Ids{});
  EXPECT_EQ (track (tracker, row ({wall}, "aa")), (Ids{0}));
  EXPECT_EQ (track (tracker, row ({}, "..")), Ids{});
  EXPECT_EQ (track (tracker, row ({wall}, "aa")), (Ids{0}));
  EXPECT_EQ (track (tracker, row ({wall, ground}, "aa")), (Ids{0, 1}))
      << "a plane without pixels";
}

TEST (PlaneTrackerInputs, AFrameThatCouldNotBeSegmentedIsSkipped)
{
  pcl::PlaneTracker tracker;
  EXPECT_EQ (track (tracker, row ({wall, ground}, "aaaabbbb")), (Ids{0, 1}));
  EXPECT_EQ (track (tracker, {}), Ids{});
  EXPECT_EQ (track (tracker, row ({ground, wall}, "bbbbaaaa")), (Ids{1, 0}));
}

TEST (PlaneTrackerInputs, LabelsThatAreNoImageAreRefused)
{
  pcl::PlaneTracker tracker;
  Image image = row ({wall}, "aaaa");
  image.labels.width = 1000;
  EXPECT_EQ (track (tracker, image), Ids{});
  EXPECT_EQ (track (tracker, row ({wall}, "aaaa")), (Ids{0}));
}

TEST (PlaneTrackerInputs, BadInputIsRefusedAndForgotten)
{
  pcl::PlaneTracker tracker;
  EXPECT_EQ (track (tracker, row ({wall}, "aaaa")), (Ids{0}));
  Image image = row ({wall}, "aaaa");
  image.models[0].values.pop_back();
  Ids ids{7};
  tracker.track (image.models, image.labels, ids);
  EXPECT_EQ (ids, Ids{}) << "replaced";
  image = row ({wall}, "");
  EXPECT_EQ (track (tracker, image), Ids{});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ (track (tracker, row ({plane (nan, nan, nan, nan)}, "aaaa")), (Ids{1}))
      << "no plane is like it";
  EXPECT_EQ (track (tracker, row ({wall}, "aaaa")), (Ids{0}));
}

TEST (PlaneTrackerInputs, PlanesMayHaveAnySignAndLength)
{
  pcl::PlaneTracker tracker;
  EXPECT_EQ (track (tracker, row ({wall, ground}, "aaaabbbb")), (Ids{0, 1}));
  for (const float factor : {-1.f, 2.f, -0.5f}) {
    Image image = row ({ground, wall}, "bbbbaaaa");
    for (auto& model : image.models)
      for (float& value : model.values)
        value *= factor;
    EXPECT_EQ (track (tracker, image), (Ids{1, 0})) << factor;
  }
}

TEST (PlaneTrackerInputs, FramesOfAnotherSizeAreScaled)
{
  pcl::PlaneTracker tracker;
  EXPECT_EQ (track (tracker, row ({wall, wall}, "aaaabbbb")), (Ids{0, 1}));
  EXPECT_EQ (track (tracker, row ({wall, wall}, "bbaa")), (Ids{1, 0}));
  EXPECT_EQ (track (tracker, row ({wall, wall}, "aaaaaaaabbbbbbbb")), (Ids{0, 1}));
}

TEST (PlaneTrackerInputs, MovedObjectsTrackOn)
{
  const Image frame = row ({wall, ground}, "aaabbb");
  pcl::PlaneTracker from;
  track (from, frame);
  pcl::PlaneTracker to = std::move (from);
  for (auto* tracker : {&from, &to}) {
    const Ids ids = track (*tracker, frame);
    EXPECT_EQ (track (*tracker, frame), ids);
  }
}
