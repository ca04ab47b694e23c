// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "flat_vectors.h"
#include "link_kernels.h"
#include "point_sample.h"

#include <pcl/segmentation/impl/object_box.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl {
namespace rgbd_planes {

namespace {

// What follows is in standard deviations of depth, as far as it shows in a direction.
/** Noise spreads a face of a box, or its top, by so much. */
constexpr float face_sigmas = 4.f;
/** Points so far below or above the top are not of it. */
constexpr float top_sigmas = 2.f;
/** What is known of the top after so many steps does not change much. */
constexpr int top_steps = 2;
/** The far end is not shifted by more. */
constexpr float far_sigmas = 3.f;
/** What is no deeper may be a front alone. */
constexpr float front_sigmas = 5.f;

/** So many points at least are of a face that is seen, and so many of a top. */
constexpr float min_front_part = 0.05f;
constexpr std::size_t min_top_points = 10;

/** The mean of some values. */
struct Mean {
  float sum = 0.f;
  float weight = 0.f;
  std::size_t count = 0;

  void
  add (float value, float w = 1.f)
  {
    sum += w * value;
    weight += w;
    ++count;
  }

  float
  value () const
  {
    return sum / weight;
  }
};

} // namespace

ObjectBox
ObjectBoxFinder::compute (const OrganizedPoints& points,
                          const pcl::Indices& indices,
                          const SupportSurface& support,
                          float bottom,
                          const DepthNoise& noise)
{
  projected_.clear();
  heights_.clear();
  sampleAtMost (indices, max_points_of_thing, [&] (std::size_t i) {
    projected_.push_back (support.project (points[i]));
    heights_.push_back (support.plane.distance (points[i]));
  });
  const float height = trimmedRange (heights_).high;
  border_ = projected_;
  convexHull (border_, hull_);
  const View view = viewFrom (support.plane.d, height, noise);
  // The first side of the two goes away from the camera.
  Eigen::Vector2f along = rectangle_.find (projected_, hull_, view.sigma);
  if (std::fabs (cross (along, view.away)) > std::fabs (along.dot (view.away)))
    along = turned (along);
  if (along.dot (view.away) < 0.f)
    along = -along;
  const Eigen::Vector2f across = turned (along);
  const CoordinateRange x =
      withoutNoise (rectangle_.rangeAlong (along, projected_), along, view);
  const CoordinateRange y = rectangle_.rangeAlong (across, projected_);

  ObjectBox box;
  const Eigen::Vector2f middle =
      0.5f * ((x.low + x.high) * along + (y.low + y.high) * across);
  box.center =
      support.unproject (middle) + 0.5f * (bottom + height) * support.plane.normal;
  box.axes << along.x() * support.axis_x + along.y() * support.axis_y,
      across.x() * support.axis_x + across.y() * support.axis_y, support.plane.normal;
  box.size = {x.high - x.low, y.high - y.low, height - bottom};
  const bool is_depth_known =
      box.size.x() > front_sigmas * view.sigma * along.dot (view.away);
  box.smallest_known_side =
      is_depth_known ? box.size.minCoeff() : box.size.tail<2>().minCoeff();
  return box;
}

ObjectBoxFinder::View
ObjectBoxFinder::viewFrom (float camera_height,
                           float height,
                           const DepthNoise& noise) const
{
  Eigen::Vector2f middle = Eigen::Vector2f::Zero();
  Mean heights;
  for (std::size_t i = 0; i < heights_.size(); ++i) {
    middle += projected_[i];
    heights.add (heights_[i]);
  }
  middle /= static_cast<float> (heights_.size());
  const float fall = camera_height - heights.value();
  const float squared_range = middle.squaredNorm() + fall * fall;
  View view;
  view.camera_height = camera_height;
  view.sigma = noise.sigmaAtSquare (squared_range);
  view.away = middle / std::sqrt (squared_range);
  view.rise = fall / std::sqrt (squared_range);
  const float spread = view.sigma * view.rise;
  Mean top;
  for (const float h : heights_)
    if (h >= height - face_sigmas * spread)
      top.add (h);
  view.top = top.value();
  view.top_margin = top_sigmas * spread;
  // The upper rows of a front pull the mean down, and those of a wall behind the thing up.
  for (int step = 0; step < top_steps; ++step) {
    Mean near;
    for (const float h : heights_)
      if (std::fabs (h - view.top) <= view.top_margin)
        near.add (h);
    if (near.count > 0)
      view.top = near.value();
  }
  return view;
}

CoordinateRange
ObjectBoxFinder::withoutNoise (const CoordinateRange& range,
                               const Eigen::Vector2f& direction,
                               const View& view)
{
  const float spread = view.sigma * direction.dot (view.away);
  Mean front;
  for (std::size_t i = 0; i < heights_.size(); ++i) {
    const float x = direction.dot (projected_[i]);
    if (heights_[i] < view.top - view.top_margin &&
        x <= range.low + face_sigmas * spread)
      front.add (x);
  }
  if (view.rise < LinkLimit::min_rise ||
      static_cast<float> (front.count) <
          min_front_part * static_cast<float> (heights_.size()))
    return range;

  // Where the rays meet the top is free of noise. A pixel sees the more of it, the further.
  Mean squared_depth;
  measured_.clear();
  met_.clear();
  for (std::size_t i = 0; i < heights_.size(); ++i) {
    const float fall = view.camera_height - heights_[i];
    const float x = direction.dot (projected_[i]);
    const float met = x * (view.camera_height - view.top) / fall;
    const float depth = met - front.value();
    if (std::fabs (heights_[i] - view.top) > view.top_margin || depth < 0.f)
      continue;
    measured_.push_back (x);
    met_.push_back (met);
    const float squared_range = projected_[i].squaredNorm() + fall * fall;
    squared_depth.add (depth * depth, squared_range * std::sqrt (squared_range));
  }
  if (met_.size() < min_top_points)
    return range;
  // All points but a few reach less far than the top where it is a small part of them. Noise
  // moves points further than it ends, and mixed pixels move where their rays meet it.
  const float furthest = std::max (
      range.high, std::min (trimmedRange (measured_).high, trimmedRange (met_).high));
  // From one end of what is seen evenly, the mean square is a third of that of the other end.
  const float far_end =
      std::clamp (front.value() + std::sqrt (3.f * squared_depth.value()),
                  furthest - far_sigmas * spread,
                  furthest + far_sigmas * spread);
  return {front.value(), 0.5f * (far_end + furthest)};
}

} // namespace rgbd_planes
} // namespace pcl
