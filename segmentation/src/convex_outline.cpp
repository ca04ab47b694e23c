// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/convex_outline.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

using Eigen::Vector2f;

constexpr int index_steps = 64;
/** Corners of the polygon that stands for a disc. */
constexpr int disc_corners = 16;

float
cross (const Vector2f& a, const Vector2f& b, const Vector2f& c)
{
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/** Appends the border of sorted points that turns one way: the lower one for \a side 1,
 * the upper one for -1; both from left to right. */
void
appendChain (const std::vector<Vector2f>& sorted,
             float side,
             std::vector<Vector2f>& chain)
{
  chain.clear();
  for (const auto& point : sorted) {
    while (chain.size() > 1 &&
           side * cross (chain[chain.size() - 2], chain.back(), point) <= 0.f)
      chain.pop_back();
    chain.push_back (point);
  }
}

void
sortByX (std::vector<Vector2f>& points)
{
  std::sort (points.begin(), points.end(), [] (const Vector2f& a, const Vector2f& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
}

} // namespace

void
convexHull (std::vector<Vector2f>& points, std::vector<Vector2f>& corners)
{
  sortByX (points);
  corners.clear();
  std::size_t fixed = 1; // corners that the chain at hand cannot drop
  const auto add = [&] (const Vector2f& point) {
    while (corners.size() > fixed &&
           cross (corners[corners.size() - 2], corners.back(), point) <= 0.f)
      corners.pop_back();
    corners.push_back (point);
  };
  std::for_each (points.begin(), points.end(), add);
  fixed = corners.size();
  std::for_each (points.rbegin(), points.rend(), add);
  if (corners.size() > 1)
    corners.pop_back(); // the first one again
}

void
ConvexOutline::compute (std::vector<Vector2f>& points, float tolerance)
{
  corners_.clear();
  right_ = left_ - 1.f;
  if (points.empty())
    return;
  convexHull (points, corners_);

  grown_.clear();
  for (const auto& corner : corners_)
    for (int k = 0; k < disc_corners; ++k) {
      const auto angle = static_cast<float> (2. * M_PI * k / disc_corners);
      grown_.push_back (corner +
                        tolerance * Vector2f (std::cos (angle), std::sin (angle)));
    }
  sortByX (grown_);
  appendChain (grown_, 1.f, lower_.points);
  appendChain (grown_, -1.f, upper_.points);
  left_ = grown_.front().x();
  right_ = grown_.back().x();
  steps_per_unit_ = right_ > left_ ? index_steps / (right_ - left_) : 0.f;
  lower_.index (left_, steps_per_unit_);
  upper_.index (left_, steps_per_unit_);
}

void
ConvexOutline::Chain::index (float left, float steps_per_unit)
{
  first.assign (index_steps + 1, 0);
  std::size_t edge = 0;
  for (int step = 0; step <= index_steps; ++step) {
    const float x = left + static_cast<float> (step) / std::max (steps_per_unit, 1e-6f);
    while (edge + 2 < points.size() && points[edge + 1].x() < x)
      ++edge;
    first[static_cast<std::size_t> (step)] = static_cast<int> (edge);
  }
}

float
ConvexOutline::Chain::at (float x, std::size_t step) const
{
  if (points.size() < 2)
    return points.front().y();
  auto edge = static_cast<std::size_t> (first[step]);
  while (edge + 2 < points.size() && points[edge + 1].x() < x)
    ++edge;
  const Vector2f& a = points[edge];
  const Vector2f& b = points[edge + 1];
  const float width = b.x() - a.x();
  return width > 0.f ? a.y() + (b.y() - a.y()) * (x - a.x()) / width : b.y();
}

bool
ConvexOutline::contains (const Vector2f& point) const
{
  if (!(point.x() >= left_ && point.x() <= right_))
    return false;
  const auto step = static_cast<std::size_t> ((point.x() - left_) * steps_per_unit_);
  const std::size_t clamped = std::min<std::size_t> (step, index_steps);
  return point.y() >= lower_.at (point.x(), clamped) &&
         point.y() <= upper_.at (point.x(), clamped);
}

} // namespace rgbd_planes
} // namespace pcl
