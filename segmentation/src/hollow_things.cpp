// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "flat_vectors.h"

#include <pcl/segmentation/impl/hollow_things.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

using Eigen::Vector2f;

/** Rims are in so many lines of the image. */
constexpr std::ptrdiff_t min_lines = 5;
/** They are level, walls are thin, and the inside is so far behind in the middle; metres. */
constexpr float max_tilt = 0.01f;
constexpr float max_wall = 0.015f;
constexpr float min_depth = 0.02f;
/** How far behind it is at the ends, in parts of that. */
constexpr float max_end = 0.7f;
/** Plates that are equally wide have the other one beside such a part of them. */
constexpr float min_common = 0.7f;
/** The inside of a bowl is so far behind the ends of its rim, in radii. */
constexpr float min_bulge = 0.4f;

} // namespace

void
HollowThings::find (const OrganizedPoints& points,
                    float pixel_angle,
                    const OcclusionSteps& occlusions,
                    const std::vector<SupportSurface>& supports,
                    const std::vector<ObjectCluster>& clusters,
                    DisjointSets& sets)
{
  points_ = points;
  pixel_angle_ = pixel_angle;
  occlusions_ = &occlusions;
  is_inside_.assign (clusters.size(), false);
  const auto& steps = occlusions.steps();
  for (auto first = steps.begin(), last = first; first != steps.end(); first = last) {
    const std::size_t front = first->front, behind = first->behind;
    last = std::find_if (first, steps.end(), [&] (const OcclusionStep& step) {
      return step.front != front || step.behind != behind;
    });
    support_ = &supports[clusters[front].support];
    if (clusters[front].support != clusters[behind].support || !isHollow (first, last))
      continue;
    is_inside_[behind] = true;
    sets.join (static_cast<std::uint32_t> (front), static_cast<std::uint32_t> (behind));
  }
}

bool
HollowThings::isHollow (Steps first, Steps last)
{
  if (last - first >= min_lines && isFoot (first, last))
    return true;
  // Where more is between, something else may hide the rim.
  const auto isClose = [&] (const OcclusionStep& step) {
    return step.skipped <= occlusions_->maxGap();
  };
  first = std::find_if (first, last, isClose);
  while (last != first && !isClose (*(last - 1)))
    --last;
  return last - first >= min_lines &&
         std::fabs (medianHeight (first, last, &OcclusionStep::edge) -
                    medianHeight (first, last, &OcclusionStep::highest)) <= max_tilt &&
         (isRim (first, last) || areWalls (first, last));
}

/** Whether the step is large in the middle, and small at both ends. */
bool
HollowThings::isRim (Steps first, Steps last)
{
  const auto depth = [this] (Steps begin, Steps end) {
    return median (begin, end, [] (const OcclusionStep& step) { return step.depth; });
  };
  const std::ptrdiff_t lines = last - first;
  const std::ptrdiff_t end = std::clamp<std::ptrdiff_t> (lines / 10, 1, 3);
  const float middle = depth (first + lines / 3, last - lines / 3);
  return middle >= min_depth && depth (first, first + end) <= max_end * middle &&
         depth (last - end, last) <= max_end * middle;
}

/** Whether two plates are equally wide, and the one in front shows no top and is no inside. */
bool
HollowThings::areWalls (Steps first, Steps last)
{
  const auto thicknessOf = [&] (const OcclusionStep& step) {
    const float* edge = points_[step.edge];
    const Vector2f place = support_->project (edge);
    float sum = 0.f, count = 1.f;
    occlusions_->forEachBelow (step, [&] (std::uint32_t i) {
      sum += (support_->project (points_[i]) - place).norm();
      ++count;
    });
    // In the mean, half a pixel of a top is lost.
    const Eigen::Map<const Eigen::Vector3f> ray (edge);
    return sum / count + 0.5f * pixel_angle_ * ray.squaredNorm() /
                             std::fabs (support_->plane.normal.dot (ray));
  };
  const auto areMostOf = [&] (std::size_t cluster) {
    return static_cast<float> (last - first) >=
           min_common * static_cast<float> (occlusions_->linesOf (cluster));
  };
  return !is_inside_[first->front] && areMostOf (first->front) &&
         areMostOf (first->behind) && median (first, last, thicknessOf) <= max_wall;
}

/** Whether the inside of a bowl is behind, and what is in front within the circle of its rim. */
bool
HollowThings::isFoot (Steps first, Steps last)
{
  const auto ends = occlusions_->lowestAtEnds (first->behind);
  const Vector2f left = support_->project (points_[ends[0]]);
  const Vector2f right = support_->project (points_[ends[1]]);
  const Vector2f center = 0.5f * (left + right), across = right - left;
  const float radius = 0.5f * across.norm();
  Vector2f away = turned (across).normalized();
  away *= away.dot (center) > 0.f ? 1.f : -1.f;
  const auto bulgeOf = [&] (const OcclusionStep& step) {
    return away.dot (support_->project (points_[step.lowest]) - center);
  };
  const auto distanceOf = [&] (const OcclusionStep& step) {
    return (support_->project (points_[step.edge]) - center).norm();
  };
  const float top = medianHeight (first, last, &OcclusionStep::highest);
  return std::fabs (heightOf (ends[0]) - top) <= max_tilt &&
         std::fabs (heightOf (ends[1]) - top) <= max_tilt &&
         median (first, last, bulgeOf) >= min_bulge * radius &&
         median (first, last, distanceOf) <= radius &&
         medianHeight (first, last, &OcclusionStep::edge) <= top + max_tilt;
}

float
HollowThings::heightOf (std::uint32_t point) const
{
  return support_->plane.distance (points_[point]);
}

template <typename Number>
float
HollowThings::median (Steps first, Steps last, const Number& number)
{
  numbers_.resize (static_cast<std::size_t> (last - first));
  std::transform (first, last, numbers_.begin(), number);
  const auto middle =
      numbers_.begin() + static_cast<std::ptrdiff_t> (numbers_.size() / 2);
  std::nth_element (numbers_.begin(), middle, numbers_.end());
  return *middle;
}

float
HollowThings::medianHeight (Steps first,
                            Steps last,
                            std::uint32_t OcclusionStep::*point)
{
  return median (
      first, last, [&] (const OcclusionStep& step) { return heightOf (step.*point); });
}

} // namespace rgbd_planes
} // namespace pcl
