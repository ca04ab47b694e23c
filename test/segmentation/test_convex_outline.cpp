// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/convex_outline.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using Eigen::Vector2f;
using pcl::rgbd_planes::ConvexOutline;

namespace {

/** How far \a p is outside of a counterclockwise polygon, by trying all edges; 0 inside. */
float
distanceOutside (const std::vector<Vector2f>& corners, const Vector2f& p)
{
  float nearest = std::numeric_limits<float>::max();
  bool inside = corners.size() > 2;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector2f a = corners[k], side = corners[(k + 1) % corners.size()] - a;
    inside &= side.x() * (p - a).y() - side.y() * (p - a).x() >= 0.f;
    const float length = side.squaredNorm();
    const float t =
        length > 0.f ? std::min (1.f, std::max (0.f, side.dot (p - a) / length)) : 0.f;
    nearest = std::min (nearest, (p - a - t * side).norm());
  }
  return inside ? 0.f : nearest;
}

std::vector<Vector2f>
randomPoints (unsigned seed, int count)
{
  std::mt19937 generator (seed);
  std::uniform_real_distribution<float> uniform (-1.f, 1.f);
  std::vector<Vector2f> points;
  for (int i = 0; i < count; ++i) {
    const float x = uniform (generator), y = uniform (generator);
    points.emplace_back (x, 0.4f * y + 0.3f * x);
  }
  return points;
}

bool
isInOctagon (const ConvexOutline& outline, const Vector2f& p)
{
  return std::all_of (outline.innerSides().begin(),
                      outline.innerSides().end(),
                      [&] (const ConvexOutline::Side& side) {
                        return side.a * p.x() + side.b * p.y() + side.c > 0.f;
                      });
}

} // namespace

TEST (ConvexOutline, HoldsItsPointsAndIsConvex)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto points = randomPoints (seed, 200);
    auto copy = points;
    ConvexOutline outline;
    outline.compute (copy, 0.001f);
    const auto& corners = outline.corners();
    ASSERT_GE (corners.size(), 3u);
    for (const auto& p : points) {
      EXPECT_LT (distanceOutside (corners, p), 1e-5f);
      EXPECT_TRUE (outline.contains (p));
    }
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vector2f a = corners[(k + 1) % corners.size()] - corners[k];
      const Vector2f b = corners[(k + 2) % corners.size()] - corners[k];
      EXPECT_GT (a.x() * b.y() - a.y() * b.x(), 0.f);
    }
  }
}

TEST (ConvexOutline, ContainsWhatIsWithinTheTolerance)
{
  constexpr float tolerance = 0.1f;
  for (unsigned seed = 0; seed < 20; ++seed) {
    auto points = randomPoints (seed, 50);
    ConvexOutline outline;
    outline.compute (points, tolerance);
    for (const auto& p : randomPoints (seed + 100, 500)) {
      const Vector2f q = 1.5f * p;
      const float outside = distanceOutside (outline.corners(), q);
      if (outside < 0.98f * tolerance) {
        EXPECT_TRUE (outline.contains (q)) << outside;
      }
      if (outside > 1.0001f * tolerance) {
        EXPECT_FALSE (outline.contains (q)) << outside;
      }
    }
  }
}

TEST (ConvexOutline, OctagonInsideHoldsMostAndNothingElse)
{
  for (const float tolerance : {0.001f, 0.1f}) {
    int in_octagon = 0, in_outline = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
      auto points = randomPoints (seed, 200);
      ConvexOutline outline;
      outline.compute (points, tolerance);
      for (const auto& p : randomPoints (seed + 100, 500)) {
        const Vector2f q = 1.5f * p;
        in_octagon += isInOctagon (outline, q);
        in_outline += outline.contains (q);
        EXPECT_LE (isInOctagon (outline, q), outline.contains (q)) << q.transpose();
      }
    }
    EXPECT_GT (in_octagon, 0.8 * in_outline);
  }
}

TEST (ConvexOutline, DepthIsThatOfTheLargestDiscInside)
{
  for (unsigned seed = 0; seed < 5; ++seed) {
    auto points = randomPoints (seed, 200);
    const auto centers = points;
    ConvexOutline outline;
    outline.compute (points, 0.1f);
    for (const auto& p : centers) {
      const float depth = outline.depthOf (p);
      float outside = 0.f, slightly_outside = 0.f;
      for (int k = 0; k < 360; ++k) {
        const float angle = static_cast<float> (k) * static_cast<float> (M_PI) / 180.f;
        const Vector2f way = depth * Vector2f (std::cos (angle), std::sin (angle));
        outside = std::max (outside, distanceOutside (outline.corners(), p + way));
        slightly_outside = std::max (
            slightly_outside, distanceOutside (outline.corners(), p + 1.01f * way));
      }
      EXPECT_LT (outside, 1e-5f);
      if (depth > 1e-3f) {
        EXPECT_GT (slightly_outside, 0.f);
      }
    }
    EXPECT_LT (outline.depthOf ({0.f, 2.f}), -1.f);
  }
}

TEST (ConvexOutline, FewPoints)
{
  ConvexOutline outline;
  std::vector<Vector2f> none;
  outline.compute (none, 0.1f);
  EXPECT_TRUE (outline.corners().empty());
  EXPECT_FALSE (outline.contains ({0.f, 0.f}));
  EXPECT_FALSE (isInOctagon (outline, {0.f, 0.f}));

  std::vector<Vector2f> one{{1.f, 2.f}, {1.f, 2.f}};
  outline.compute (one, 0.1f);
  EXPECT_TRUE (outline.contains ({1.05f, 2.f}));
  EXPECT_FALSE (outline.contains ({1.2f, 2.f}));
  outline.compute (one, 0.f);
  EXPECT_FALSE (isInOctagon (outline, {3.f, 3.f}));

  std::vector<Vector2f> line{{0.f, 0.f}, {1.f, 1.f}, {2.f, 2.f}};
  outline.compute (line, 0.1f);
  EXPECT_TRUE (outline.contains ({1.5f, 1.5f}));
  EXPECT_FALSE (outline.contains ({1.5f, 1.f}));
  EXPECT_FALSE (outline.contains ({std::numeric_limits<float>::quiet_NaN(), 1.f}));
}
