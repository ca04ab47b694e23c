// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/object_box.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

/** So many points, or at most twice as many, tell the sides of a box as well as all. */
constexpr unsigned min_points = 300;
/** The part of the points at either end that may be flying pixels. */
constexpr float trimmed_part = 0.02f;

float
cross (const Eigen::Vector2f& a, const Eigen::Vector2f& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** The direction of the side of the hull along which a rectangle around it is smallest. */
Eigen::Vector2f
smallestRectangle (const std::vector<Eigen::Vector2f>& corners)
{
  float smallest = std::numeric_limits<float>::max();
  Eigen::Vector2f best = Eigen::Vector2f::UnitX();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Eigen::Vector2f& corner = corners[k];
    const Eigen::Vector2f side = corners[(k + 1) % corners.size()] - corner;
    if (side.squaredNorm() == 0.f)
      continue;
    const Eigen::Vector2f along = side.normalized();
    float low = 0.f, high = 0.f, width = 0.f;
    for (const auto& other : corners) {
      const Eigen::Vector2f to_other = other - corner;
      low = std::min (low, along.dot (to_other));
      high = std::max (high, along.dot (to_other));
      width = std::max (width, cross (along, to_other));
    }
    if ((high - low) * width < smallest) {
      smallest = (high - low) * width;
      best = along;
    }
  }
  return best;
}

struct Range {
  float low = 0.f;
  float high = 0.f;
};

/** The range of the values but for a few at either end; changes their order. */
Range
trimmedRange (std::vector<float>& values)
{
  const auto trimmed =
      static_cast<std::ptrdiff_t> (trimmed_part * static_cast<float> (values.size()));
  const auto low = values.begin() + trimmed, high = values.end() - 1 - trimmed;
  std::nth_element (values.begin(), low, values.end());
  Range range;
  range.low = *low;
  std::nth_element (low, high, values.end());
  range.high = *high;
  return range;
}

} // namespace

ObjectBox
ObjectBoxFinder::compute (const OrganizedPoints& points,
                          const pcl::Indices& indices,
                          const SupportPlane& support)
{
  projected_.clear();
  values_.clear();
  const std::size_t step = std::max<std::size_t> (indices.size() / min_points, 1);
  for (std::size_t k = 0; k < indices.size(); k += step) {
    const float* p = points[static_cast<std::size_t> (indices[k])];
    projected_.push_back (support.project (p));
    values_.push_back (support.plane.distance (p));
  }
  const float height = trimmedRange (values_).high;
  border_ = projected_;
  convexHull (border_, hull_);
  const Eigen::Vector2f along = smallestRectangle (hull_);
  const Eigen::Vector2f across (-along.y(), along.x());
  const auto rangeAlong = [&] (const Eigen::Vector2f& direction) {
    values_.clear();
    for (const auto& q : projected_)
      values_.push_back (direction.dot (q));
    return trimmedRange (values_);
  };
  const Range x = rangeAlong (along), y = rangeAlong (across);

  ObjectBox box;
  const Eigen::Vector2f middle =
      0.5f * ((x.low + x.high) * along + (y.low + y.high) * across);
  box.center = support.unproject (middle) + 0.5f * height * support.plane.normal;
  box.axes << along.x() * support.axis_x + along.y() * support.axis_y,
      across.x() * support.axis_x + across.y() * support.axis_y, support.plane.normal;
  box.size = {x.high - x.low, y.high - y.low, height};
  return box;
}

} // namespace rgbd_planes
} // namespace pcl
