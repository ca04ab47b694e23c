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
/** Points so far below the top are not of it. */
constexpr float top_sigmas = 2.f;
/** The far end is not shifted by more. */
constexpr float far_sigmas = 3.f;
/** What is no deeper may be a front alone. */
constexpr float front_sigmas = 5.f;

/** So many points at least are of a face that is seen, and so many of a top. */
constexpr float min_front_part = 0.05f;
constexpr std::size_t min_top_points = 20;

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
  view.below_top = view.top - top_sigmas * spread;
  return view;
}

CoordinateRange
ObjectBoxFinder::withoutNoise (const CoordinateRange& range,
                               const Eigen::Vector2f& direction,
                               const View& view) const
{
  const float spread = view.sigma * direction.dot (view.away);
  Mean front;
  for (std::size_t i = 0; i < heights_.size(); ++i) {
    const float x = direction.dot (projected_[i]);
    if (heights_[i] < view.below_top && x <= range.low + face_sigmas * spread)
      front.add (x);
  }
  if (view.rise < LinkLimit::min_rise ||
      static_cast<float> (front.count) <
          min_front_part * static_cast<float> (heights_.size()))
    return range;

  // Where the rays meet the top is free of noise. A pixel sees the more of it, the further.
  Mean top;
  for (std::size_t i = 0; i < heights_.size(); ++i) {
    const float fall = view.camera_height - heights_[i];
    const float x =
        direction.dot (projected_[i]) * (view.camera_height - view.top) / fall;
    if (heights_[i] < view.below_top || x < front.value())
      continue;
    const float squared_range = projected_[i].squaredNorm() + fall * fall;
    top.add (x, squared_range * std::sqrt (squared_range));
  }
  if (top.count < min_top_points)
    return range;
  const float mirrored = 2.f * top.value() - front.value();
  const float far_end = std::clamp (
      mirrored, range.high - far_sigmas * spread, range.high + far_sigmas * spread);
  return {front.value(), 0.5f * (far_end + range.high)};
}

} // namespace rgbd_planes
} // namespace pcl
