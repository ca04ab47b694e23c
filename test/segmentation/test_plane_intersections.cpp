// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/plane_intersections.h>

#include <gtest/gtest.h>

using pcl::rgbd_planes::PlaneIntersections;
using pcl::rgbd_planes::SeenPlane;

TEST (PlaneIntersections, NearerPlaneIsSeenInACorner)
{
  PlaneIntersections intersections;
  intersections.add (7, 3, {5, 0});
  intersections.add (3, 7, {2, 0});
  intersections.add (3, 7, {2, 1});
  EXPECT_EQ (intersections.between (3, 7), SeenPlane::unknown);
  intersections.find();
  EXPECT_EQ (intersections.between (3, 7), SeenPlane::nearer);
  EXPECT_EQ (intersections.between (7, 3), SeenPlane::nearer);
  intersections.clear();
  EXPECT_EQ (intersections.between (3, 7), SeenPlane::unknown);
}

TEST (PlaneIntersections, FartherPlaneIsSeenAtAnEdge)
{
  PlaneIntersections intersections;
  intersections.add (0, 1, {1, 4});
  intersections.add (1, 0, {0, 9});
  intersections.find();
  EXPECT_EQ (intersections.between (1, 0), SeenPlane::farther);
}

TEST (PlaneIntersections, APlaneInFrontOfAnotherDoesNotMeetIt)
{
  PlaneIntersections intersections;
  intersections.add (0, 1, {100, 0});
  intersections.add (1, 0, {0, 100});
  intersections.find();
  EXPECT_EQ (intersections.between (0, 1), SeenPlane::unknown);
}

TEST (PlaneIntersections, FewPointsOrDividedOnesTellNothing)
{
  PlaneIntersections intersections;
  intersections.add (0, 1, {100, 0});
  intersections.add (1, 0, {3, 0});
  intersections.add (0, 2, {100, 0});
  intersections.add (2, 0, {7, 3});
  intersections.find();
  EXPECT_EQ (intersections.between (0, 1), SeenPlane::unknown);
  EXPECT_EQ (intersections.between (0, 2), SeenPlane::unknown);
  EXPECT_EQ (intersections.between (1, 2), SeenPlane::unknown);
}
