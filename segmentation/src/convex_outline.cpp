// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "hull_kernels.h"

#include <pcl/segmentation/impl/convex_outline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

/** Appends a point to a border that turns one way, to the left for \a side 1 and to the right
 * for -1. Points at which it would not are dropped, but for the first \a fixed ones. */
void
append (const Vector2f& point,
        float side,
        std::size_t fixed,
        std::vector<Vector2f>& border)
{
  while (border.size() > fixed &&
         side * cross (border[border.size() - 2], border.back(), point) <= 0.f)
    border.pop_back();
  border.push_back (point);
}

void
sortByX (std::vector<Vector2f>& points)
{
  std::sort (points.begin(), points.end(), [] (const Vector2f& a, const Vector2f& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
}

/** The points furthest out in eight directions, counterclockwise. Appends copies of the last
 * one until they fill vectors. */
std::array<Vector2f, 8>
octagonOf (std::vector<Vector2f>& points)
{
  points.resize ((points.size() + hull_block - 1) / hull_block * hull_block,
                 Vector2f (points.back()));
  const auto furthest = findOctagon (points.data()->data(), points.size());
  std::array<Vector2f, 8> octagon;
  std::transform (furthest.begin(), furthest.end(), octagon.begin(), [&] (auto point) {
    return points[point];
  });
  return octagon;
}

/** Drops points inside of their octagon: they are no corners (Akl and Toussaint, A Fast
 * Convex Hull Algorithm, 1978). */
void
dropInnerPoints (std::vector<Vector2f>& points)
{
  const std::array<Vector2f, 8> octagon = octagonOf (points);
  if (std::all_of (octagon.begin(), octagon.end(), [&] (const Vector2f& corner) {
        return corner == octagon.front();
      }))
    return;
  points.resize (
      dropInside (octagon.front().data(), points.data()->data(), points.size()));
}

} // namespace

void
convexHull (std::vector<Vector2f>& points, std::vector<Vector2f>& corners)
{
  corners.clear();
  if (points.empty())
    return;
  dropInnerPoints (points);
  sortByX (points);
  for (const auto& point : points)
    append (point, 1.f, 1, corners);
  const std::size_t lower = corners.size();
  for (auto point = points.rbegin(); point != points.rend(); ++point)
    append (*point, 1.f, lower, corners);
  if (corners.size() > 1)
    corners.pop_back(); // the first one again
}

void
ConvexOutline::compute (std::vector<Vector2f>& points, float tolerance)
{
  corners_.clear();
  bounds_.setEmpty();
  inner_sides_ = {};
  if (points.empty())
    return;
  convexHull (points, corners_);

  std::array<Vector2f, disc_corners> disc;
  for (std::size_t k = 0; k < disc.size(); ++k) {
    const auto angle =
        static_cast<float> (2. * M_PI * static_cast<double> (k) / disc_corners);
    disc[k] = tolerance * Vector2f (std::cos (angle), std::sin (angle));
  }
  grown_.clear();
  for (const auto& corner : corners_)
    for (const auto& offset : disc)
      grown_.push_back (corner + offset);
  dropInnerPoints (grown_);
  sortByX (grown_);
  lower_.points.clear();
  upper_.points.clear();
  for (const auto& point : grown_) {
    append (point, 1.f, 1, lower_.points);
    append (point, -1.f, 1, upper_.points);
    bounds_.extend (point);
  }
  const float left = bounds_.min().x(), right = bounds_.max().x();
  steps_per_unit_ = right > left ? index_steps / (right - left) : 0.f;
  lower_.index (left, steps_per_unit_);
  upper_.index (left, steps_per_unit_);
  const std::array<Vector2f, 8> octagon = octagonOf (grown_);
  for (std::size_t k = 0; k < 8; ++k) {
    const Vector2f &a = octagon[k], &b = octagon[(k + 1) % 8];
    const Vector2f inwards (a.y() - b.y(), b.x() - a.x());
    inner_sides_[k] = {inwards.x(), inwards.y(), -inwards.dot (a)};
  }
}

void
ConvexOutline::Chain::index (float left, float steps_per_unit)
{
  steps.resize (index_steps + 1);
  std::size_t edge = 0;
  const float width = 1.f / std::max (steps_per_unit, 1e-6f);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const float x = left + static_cast<float> (k) * width;
    while (edge + 2 < points.size() && points[edge + 1].x() < x)
      ++edge;
    Step& step = steps[k];
    step.edge = edge;
    const float begin = at (x, edge), end = at (x + width, edge);
    step.low = std::min (begin, end);
    step.high = std::max (begin, end);
    for (std::size_t i = edge + 1; i < points.size() && points[i].x() < x + width;
         ++i) {
      step.low = std::min (step.low, points[i].y());
      step.high = std::max (step.high, points[i].y());
    }
  }
}

/** \a edge is that of the point or one before. */
float
ConvexOutline::Chain::at (float x, std::size_t edge) const
{
  if (points.size() < 2)
    return points.front().y();
  while (edge + 2 < points.size() && points[edge + 1].x() < x)
    ++edge;
  const Vector2f& a = points[edge];
  const Vector2f& b = points[edge + 1];
  const float width = b.x() - a.x();
  return width > 0.f ? a.y() + (b.y() - a.y()) * (x - a.x()) / width : b.y();
}

float
ConvexOutline::depthOf (const Vector2f& point) const
{
  constexpr float max = std::numeric_limits<float>::max();
  float depth = corners_.size() > 2 ? max : -max;
  for (std::size_t k = 0; k < corners_.size(); ++k) {
    const Vector2f &a = corners_[k], &b = corners_[(k + 1) % corners_.size()];
    const float length = (b - a).norm();
    if (length > 0.f)
      depth = std::min (depth, cross (a, b, point) / length);
  }
  return depth;
}

bool
ConvexOutline::contains (const Vector2f& point) const
{
  const float x = point.x(), y = point.y();
  if (!bounds_.contains (point))
    return false;
  const auto step = std::min<std::size_t> (
      static_cast<std::size_t> ((x - bounds_.min().x()) * steps_per_unit_),
      index_steps);
  const Chain::Step &lower = lower_.steps[step], &upper = upper_.steps[step];
  if (y > lower.high && y < upper.low)
    return true;
  return y >= lower.low && y <= upper.high && y >= lower_.at (x, lower.edge) &&
         y <= upper_.at (x, upper.edge);
}

} // namespace rgbd_planes
} // namespace pcl
