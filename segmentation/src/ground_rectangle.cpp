// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "flat_vectors.h"
#include "point_sample.h"
#include "trim_kernels.h"

#include <pcl/segmentation/impl/ground_rectangle.h>

#include <array>

namespace pcl {
namespace rgbd_planes {

namespace {

using Eigen::Vector2f;

/** Rectangles that are so many times larger than the smallest one may be as right. */
constexpr float max_area = 1.15f;
/** Those whose directions differ by less are alike, but for turns by 90 degrees; radians. */
constexpr float max_sine_alike = 0.17f;
/** The points must be so many times as close to the sides of another one as to the smallest. */
constexpr float clearly_closer = 1.2f;
/** One of so many points tells how close they are. */
constexpr std::size_t every_third = 3;
/** Points so near to a side, and by so many metres, are as close to it as can be told. */
constexpr float near_sigmas = 0.5f;
constexpr float near_m = 0.002f;

/** \return the area of the rectangle around a hull along one of its sides */
float
areaAlong (const std::vector<Vector2f>& hull,
           const Vector2f& corner,
           const Vector2f& along)
{
  float low = 0.f, high = 0.f, width = 0.f;
  for (const auto& other : hull) {
    const Vector2f to_other = other - corner;
    low = std::min (low, along.dot (to_other));
    high = std::max (high, along.dot (to_other));
    width = std::max (width, cross (along, to_other));
  }
  return (high - low) * width;
}

/** The lowest one of \a values, times \a sign, but for \a few. */
float
lowestBut (std::size_t few, const std::vector<float>& values, float sign)
{
  static_assert (trimmed_part * max_points_of_thing < trim_groups, "enough are found");
  std::array<float, max_points_of_thing> low;
  const auto end = low.begin() + static_cast<std::ptrdiff_t> (findLow (
                                     values.data(), values.size(), sign, low.data()));
  const auto selected = low.begin() + static_cast<std::ptrdiff_t> (few);
  std::nth_element (low.begin(), selected, end);
  return *selected;
}

} // namespace

CoordinateRange
trimmedRange (const std::vector<float>& values)
{
  const auto few =
      static_cast<std::size_t> (trimmed_part * static_cast<float> (values.size()));
  return {lowestBut (few, values, 1.f), -lowestBut (few, values, -1.f)};
}

Vector2f
GroundRectangle::find (const std::vector<Vector2f>& points,
                       const std::vector<Vector2f>& hull,
                       float sigma)
{
  findSmall (hull);
  if (rectangles_.size() == 1)
    return rectangles_.front().along;
  const float near = near_sigmas * sigma + near_m;
  auto best = rectangles_.begin();
  float closest = clearly_closer * closenessOf (*best, points, near);
  for (auto other = best + 1; other != rectangles_.end(); ++other) {
    const float closeness = closenessOf (*other, points, near);
    if (closeness > closest) {
      closest = closeness;
      best = other;
    }
  }
  return best->along;
}

/** Those along sides of the hull, the smallest first. */
void
GroundRectangle::findSmall (const std::vector<Vector2f>& hull)
{
  rectangles_.clear();
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Vector2f side = hull[(k + 1) % hull.size()] - hull[k];
    if (side.squaredNorm() == 0.f)
      continue;
    const Vector2f along = side.normalized();
    rectangles_.push_back ({along, areaAlong (hull, hull[k], along)});
  }
  if (rectangles_.empty())
    rectangles_.emplace_back();
  std::sort (rectangles_.begin(),
             rectangles_.end(),
             [] (const Rectangle& a, const Rectangle& b) { return a.area < b.area; });
  std::size_t count = 0;
  for (const Rectangle& rectangle : rectangles_) {
    const auto isAlike = [&] (const Rectangle& other) {
      return std::min (std::fabs (cross (other.along, rectangle.along)),
                       std::fabs (other.along.dot (rectangle.along))) < max_sine_alike;
    };
    const auto end = rectangles_.begin() + static_cast<std::ptrdiff_t> (count);
    if (rectangle.area <= max_area * rectangles_.front().area &&
        std::none_of (rectangles_.begin(), end, isAlike))
      rectangles_[count++] = rectangle;
  }
  rectangles_.resize (count);
}

float
GroundRectangle::closenessOf (const Rectangle& rectangle,
                              const std::vector<Vector2f>& points,
                              float near)
{
  const Vector2f& along = rectangle.along;
  const CoordinateRange y = rangeAlong (turned (along), points, every_third);
  across_.swap (coordinates_);
  const CoordinateRange x = rangeAlong (along, points, every_third);
  float closeness = 0.f;
  for (std::size_t i = 0; i < coordinates_.size(); ++i)
    closeness += 1.f / std::max (std::min (x.distanceToEnd (coordinates_[i]),
                                           y.distanceToEnd (across_[i])),
                                 near);
  return closeness;
}

CoordinateRange
GroundRectangle::rangeAlong (const Vector2f& direction,
                             const std::vector<Vector2f>& points,
                             std::size_t every)
{
  coordinates_.clear();
  for (std::size_t i = 0; i < points.size(); i += every)
    coordinates_.push_back (direction.dot (points[i]));
  return trimmedRange (coordinates_);
}

} // namespace rgbd_planes
} // namespace pcl
