// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/floor_plane.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {
namespace rgbd_planes {

namespace {

/** A level that lies lower by so many metres (and standard deviations of height, as below), and has
 * this part of the points of the one above it, is not a part of that. */
constexpr float min_step_m = 0.01f;
constexpr std::size_t part_of_points = 10;
/** It is the floor if it is nearer to z = 0 by so much, as a share of what the floor may be off. */
constexpr float min_nearer = 0.2f;
/** A level that is less tilted by so much, no farther from z = 0, and has half as many points, is
 * the floor before a ramp whose plane took some of it. */
constexpr float min_ramp = 0.05f;
/** Noise tilts even small planes of the floor by no more than this. */
constexpr float max_cos_tilted = 0.9962f; // 5 degrees
/** Points further from the floor are not on it. */
constexpr float off_sigmas = 3.f;
/** The smooth error of depth tilts small parts of a floor, as at the border of the image, by no
 * more than this, and moves them by no more than that. */
constexpr float min_cos_bent = 0.9f; // 26 degrees
constexpr float max_bend_m = 0.03f;
/** In the weighted mean, it bends parts of a floor by no more than so many standard deviations.
 * Those with a quarter of the points of the floor are too large for the top of a low thing, and
 * where there is no step to the floor, there is no low thing. */
constexpr float part_sigmas = 1.75f, large_part_sigmas = 2.7f;
/** Points of a level that are further from the floor are told from it one by one. */
constexpr float level_sigmas = 8.f;
/** Where planes meet in the image, the smooth error of depth is the same on both: unless there is
 * a step, their heights differ by no more than so many standard deviations of depth. If they
 * differ by less than the second number, there is none. */
constexpr float step_sigmas = 1.5f, no_step_sigmas = 0.8f;
/** They meet where samples are no more steps of the grid apart. */
constexpr int max_gap = 3;
/** A camera that is nearer cannot see a floor. */
constexpr float min_camera_height = 0.01f;

/** How far above the floor the ray to \a point meets \a plane. */
float
heightOnRay (const Eigen::Vector4f& plane,
             const Eigen::Vector4f& floor,
             const float* point)
{
  const float scale = plane[3] / (plane[3] - heightAbove (plane, point));
  return floor[3] + scale * (heightAbove (floor, point) - floor[3]);
}

} // namespace

void
FloorPlane::find (const OrganizedPoints& points,
                  const LabelledPlanes& planes,
                  const Eigen::Affine3f& camera_to_base,
                  const DepthNoise& noise,
                  float max_angle,
                  float max_height)
{
  const Eigen::Vector4f height = camera_to_base.matrix().row (2);
  samples_.assign (planes.coefficients.size(), {});
  sample (points, planes, noise);
  for (const auto& point : points_) {
    Samples& samples = samples_[point.plane];
    const float sigma = noise.sigmaAtSquare (squaredRange (point.point));
    samples.height += point.weight * heightAbove (height, point.point);
    samples.sigmas_in_base +=
        point.weight *
        heightOnRay (planes.coefficients[point.plane], height, point.point) / sigma;
    samples.weight += point.weight;
    samples.height_sigma +=
        point.weight * std::sqrt (heightVariance (point.point, height[3], noise));
    ++samples.points;
  }

  const Eigen::Vector3f base = camera_to_base.inverse().translation();
  // That of pi / 2 as a float is negative, as are those of ceilings.
  const float min_cosine = std::max (std::cos (max_angle), 0.f);
  float largest_weight = 0.f;
  std::size_t floor = samples_.size();
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    Samples& samples = samples_[k];
    const Eigen::Vector4f& plane = planes.coefficients[k];
    const float cosine = plane.head<3>().dot (height.head<3>());
    if (samples.points == 0 || plane[3] < min_camera_height || cosine < min_cosine)
      continue;
    // An error of the pose turns far points away from z = 0, one of the plane what is below
    // the robot.
    samples.tilt = std::acos (std::min (cosine, 1.f));
    samples.off_zero = std::min (std::abs (samples.height) / samples.weight,
                                 std::abs (heightAbove (plane, base.data())) / cosine);
    const float nearness = std::max (1.f - samples.off_zero / max_height, 0.f);
    const float weight = samples.weight * nearness * nearness;
    if (!(weight > largest_weight))
      continue;
    floor = k;
    largest_weight = weight;
  }
  found_ = floor < samples_.size();
  coefficients_.setZero();
  if (found_) {
    floor = lowerLevel (floor, max_height);
    coefficients_ = planes.coefficients[floor];
    compare (planes, noise, floor);
  }
  const bool is_above_zero = height[3] >= min_camera_height;
  reference_ = found_ || !is_above_zero ? coefficients_ : height;
}

/** A step, sill or platform before the robot weighs more than the floor that it stands on. */
std::size_t
FloorPlane::lowerLevel (std::size_t floor, float max_height) const
{
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    const Samples &upper = samples_[floor], &lower = samples_[k];
    const float step = upper.height / upper.weight - lower.height / lower.weight;
    const float min_step =
        std::max (min_step_m, large_part_sigmas * lower.height_sigma / lower.weight);
    const float nearer = std::max (min_step_m, min_nearer * max_height);
    const bool is_below = step > min_step && lower.off_zero + nearer < upper.off_zero &&
                          part_of_points * lower.points >= upper.points;
    const bool is_upright = lower.tilt + min_ramp < upper.tilt &&
                            lower.off_zero <= upper.off_zero &&
                            2 * lower.points >= upper.points;
    if (is_below || is_upright)
      floor = k;
  }
  return floor;
}

void
FloorPlane::sample (const OrganizedPoints& points,
                    const LabelledPlanes& planes,
                    const DepthNoise& noise)
{
  const auto width = static_cast<std::size_t> (points.width);
  const auto height = static_cast<std::size_t> (points.height);
  const std::size_t step_u = std::max<std::size_t> (width / 80, 1);
  const std::size_t step_v = std::max<std::size_t> (height / 60, 1);
  const float farthest = noise.maxSquaredRange();
  points_.resize ((width / step_u + 1) * (height / step_v + 1));
  last_in_column_.resize (width / step_u + 1);
  std::size_t count = 0;
  for (std::size_t v = step_v / 2; v < height; v += step_v)
    for (std::size_t u = step_u / 2; u < width; u += step_u) {
      const std::size_t i = v * width + u;
      const float squared_range = squaredRange (points[i]);
      // Without a branch, for which points are on planes cannot be foreseen.
      points_[count] = {points[i],
                        planes[i],
                        static_cast<int> (u / step_u),
                        static_cast<int> (v / step_v),
                        1.f / (squared_range * squared_range)};
      count +=
          static_cast<std::size_t> (planes[i] < planes.coefficients.size()) &
          static_cast<std::size_t> (squared_range > DepthNoise::min_squared_range) &
          static_cast<std::size_t> (squared_range <= farthest);
    }
  points_.resize (count);
}

void
FloorPlane::compare (const LabelledPlanes& planes,
                     const DepthNoise& noise,
                     std::size_t floor)
{
  for (std::size_t k = 0; k < samples_.size(); ++k)
    samples_[k].cosine = planes.coefficients[k].head<3>().dot (coefficients_.head<3>());
  for (const auto& point : points_) {
    if (point.plane == floor)
      continue;
    Samples& samples = samples_[point.plane];
    const float height = heightAbove (coefficients_, point.point);
    const float sigma = noise.sigmaAtSquare (squaredRange (point.point));
    const float height_sigma =
        std::sqrt (heightVariance (point.point, coefficients_[3], noise));
    const bool is_tilted = samples.cosine < max_cos_tilted;
    float limit = (is_tilted ? off_sigmas : level_sigmas) * height_sigma;
    if (is_tilted && samples.cosine > min_cos_bent)
      limit = std::min (std::max (limit, max_bend_m), off_sigmas * sigma);
    samples.off += std::abs (height) > limit;
    if (is_tilted)
      continue;
    const float level =
        heightOnRay (planes.coefficients[point.plane], coefficients_, point.point);
    samples.level += point.weight * level;
    samples.sigmas += point.weight * level / sigma;
  }
  addSteps (noise, floor);
  const auto isAtZero = [] (const Samples& samples) {
    return std::abs (samples.sigmas_in_base) < part_sigmas * samples.weight;
  };
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    Samples& samples = samples_[k];
    if (k == floor || samples.points == 0)
      continue;
    const bool is_tilted = samples.cosine < max_cos_tilted;
    const bool is_large = 4 * samples.points >= samples_[floor].points;
    const float sigmas = std::abs (samples.sigmas) / samples.weight;
    // A border is as long as the plane is wide.
    const bool is_beside = samples.borders * samples.borders >= samples.points;
    const float step = std::abs (samples.step) /
                       static_cast<float> (std::max<std::size_t> (samples.borders, 1));
    const bool is_step = is_beside && step > step_sigmas;
    const bool is_continuous = is_beside && step < no_step_sigmas;
    samples.is_other = is_tilted && 5 * samples.off > samples.points;
    const float limit = is_large || is_continuous ? large_part_sigmas : part_sigmas;
    // What is apart from the floor in the image is no top of a thing that stands there.
    const bool is_apart_at_zero =
        samples.borders == 0 && isAtZero (samples_[floor]) && isAtZero (samples);
    const bool is_near = is_tilted ? samples.cosine > min_cos_bent && !samples.is_other
                                   : is_apart_at_zero || sigmas < limit;
    samples.is_part = is_near && !is_step;
    const bool is_level = !is_tilted && !samples.is_part &&
                          (is_step || sigmas >= large_part_sigmas) &&
                          samples.off < samples.points;
    samples.level = is_level ? samples.level / samples.weight : 0.f;
  }
}

void
FloorPlane::addSteps (const DepthNoise& noise, std::size_t floor)
{
  const auto mayBePart = [&] (const Samples& samples) {
    return samples.cosine > min_cos_bent && samples.off < samples.points;
  };
  if (std::count_if (samples_.begin(), samples_.end(), mayBePart) < 2)
    return;
  const SampledPoint* last_in_row = nullptr;
  last_in_column_.assign (last_in_column_.size(), nullptr);
  for (const auto& point : points_) {
    if (!mayBePart (samples_[point.plane]))
      continue;
    for (const SampledPoint** last : {&last_in_row, &last_in_column_[point.u]}) {
      const SampledPoint* before = std::exchange (*last, &point);
      if (!before || (before->plane == floor) == (point.plane == floor) ||
          std::abs (point.u - before->u) + point.v - before->v > max_gap)
        continue;
      const bool is_floor = point.plane == floor;
      const SampledPoint& on_floor = is_floor ? point : *before;
      const SampledPoint& other = is_floor ? *before : point;
      Samples& samples = samples_[other.plane];
      samples.step += (heightAbove (coefficients_, other.point) -
                       heightAbove (coefficients_, on_floor.point)) /
                      noise.sigmaAtSquare (squaredRange (other.point));
      ++samples.borders;
    }
  }
}

} // namespace rgbd_planes
} // namespace pcl
