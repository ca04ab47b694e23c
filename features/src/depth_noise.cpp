// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/console/print.h>
#include <pcl/features/depth_noise.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Rectangles along the longer side of the image, every second of which is looked at. */
constexpr int rectangles_in_a_row = 80;
constexpr std::size_t min_rectangles = 100;
/** The median of a normal distribution's sizes, in standard deviations. */
constexpr float median_size = 0.6745f;

/** The error of a rectangle, in standard deviations; NaN where a corner is missing. */
float
errorOfRectangle (const OrganizedPoints& points,
                  const DepthNoise& noise,
                  std::size_t first,
                  std::size_t right,
                  std::size_t down)
{
  float inverse[4], squared_range = 0.f;
  const std::size_t corners[4] = {
      first + right + down, first + right, first + down, first};
  for (std::size_t k = 0; k < 4; ++k) {
    squared_range = squaredRange (points[corners[k]]);
    inverse[k] = 1.f / std::sqrt (squared_range);
  }
  // That of each inverse range, to first order, is sigma / range^2; four of them differ twice as much.
  const float sigma = 2.f * noise.sigma (squared_range) / squared_range;
  return std::abs (inverse[0] - inverse[1] - inverse[2] + inverse[3]) / sigma;
}

} // namespace

DepthNoise
noiseIn (const OrganizedPoints& points, const DepthNoise& noise)
{
  if (!noise.is_least)
    return noise;
  const int side =
      std::max (1, std::max (points.width, points.height) / rectangles_in_a_row);
  std::array<float, (rectangles_in_a_row + 1) * (rectangles_in_a_row + 1)> errors;
  std::size_t number = 0;
  for (int v = 0; v + side < points.height; v += 2 * side)
    for (int u = 0; u + side < points.width; u += 2 * side) {
      const auto width = static_cast<std::size_t> (points.width);
      const float error = errorOfRectangle (points,
                                            noise,
                                            static_cast<std::size_t> (v) * width +
                                                static_cast<std::size_t> (u),
                                            static_cast<std::size_t> (side),
                                            static_cast<std::size_t> (side) * width);
      errors[number] = error;
      number += std::isfinite (error);
    }
  if (number < min_rectangles)
    return noise;
  const auto median = errors.begin() + static_cast<std::ptrdiff_t> (number / 2);
  std::nth_element (
      errors.begin(), median, errors.begin() + static_cast<std::ptrdiff_t> (number));
  const float factor = std::max (1.f, *median / median_size);
  return {factor * noise.constant, factor * noise.quadratic, noise.max_range};
}

void
setDepthNoise (const std::string& class_name,
               const DepthNoise& value,
               DepthNoise& noise)
{
  const float sigma = value.sigma (1.f);
  if (!(value.constant >= 0.f && value.quadratic >= 0.f && sigma > 0.f &&
        std::isfinite (sigma) && value.max_range > 0.f)) {
    PCL_ERROR ("[pcl::%s::setDepthNoise] The noise must be more than 0 m and the range "
               "as well, got %g m + %g m z^2 up to %g m. Keeping what was set.\n",
               class_name.c_str(),
               value.constant,
               value.quadratic,
               value.max_range);
    return;
  }
  noise = value;
}

} // namespace rgbd_planes
} // namespace pcl
