// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/cluster_merging.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

struct Values {
  double sum = 0.;
  int count = 0;

  Values&
  operator+= (const Values& other)
  {
    sum += other.sum;
    count += other.count;
    return *this;
  }
};

float
difference (const Values& a, const Values& b)
{
  return static_cast<float> (std::abs (a.sum / a.count - b.sum / b.count));
}

using Merging = pcl::rgbd_planes::ClusterMerging<Values>;

} // namespace

TEST (ClusterMerging, PrefersTheBetterMerge)
{
  // a = 0, b = 1, c = 1.8: b and c merge first (0.8 < 1), to 1.4; a stays out.
  for (const bool reverse : {false, true}) {
    Merging merging;
    merging.reset ({{0., 1}, {1., 1}, {1.8, 1}});
    merging.addNeighbours (reverse ? 1 : 0, reverse ? 2 : 1);
    merging.addNeighbours (reverse ? 0 : 1, reverse ? 1 : 2);
    merging.merge (1.f, difference);
    EXPECT_EQ (merging.find (1), merging.find (2));
    EXPECT_NE (merging.find (0), merging.find (1));
    EXPECT_DOUBLE_EQ (merging[merging.find (2)].sum, 2.8);
    EXPECT_EQ (merging[merging.find (2)].count, 2);
  }
}

TEST (ClusterMerging, FollowsMergesOfMerges)
{
  // 0 + 1 = 0.5; then 2 (2) is within 1.6 of it: one cluster, though 0 and 2 are 2
  // apart.
  Merging merging;
  merging.reset ({{0., 1}, {1., 1}, {2., 1}, {9., 1}});
  merging.addNeighbours (0, 1);
  merging.addNeighbours (1, 2);
  merging.addNeighbours (2, 3);
  merging.merge (1.6f, difference);
  EXPECT_EQ (merging.find (0), merging.find (2));
  EXPECT_EQ (merging.find (3), 3u);
  EXPECT_EQ (merging[merging.find (0)].count, 3);
}

TEST (ClusterMerging, OnlyNeighboursMerge)
{
  Merging merging;
  merging.reset ({{1., 1}, {1., 1}, {1., 1}});
  merging.addNeighbours (0, 1);
  merging.merge (1.f, difference);
  EXPECT_EQ (merging.find (0), merging.find (1));
  EXPECT_EQ (merging.find (2), 2u);
}
