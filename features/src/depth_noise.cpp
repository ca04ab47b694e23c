// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/console/print.h>
#include <pcl/features/depth_noise.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Rectangles along the longer side of the image, every second of which is looked at. */
constexpr std::size_t rectangles_in_a_row = 80;
constexpr std::ptrdiff_t min_rectangles = 100;
/** The median of a normal distribution's sizes, in standard deviations. */
constexpr float median_size = 0.6745f;

/** The error of the rectangle of \a side pixels from point \a first on, in standard deviations;
 * not finite where a corner is missing or beyond the range of the noise. */
float
errorOfRectangle (const OrganizedPoints& points,
                  const DepthNoise& noise,
                  std::size_t first,
                  std::size_t side)
{
  const float max_square = noise.maxSquaredRange();
  // Not finite where it is missing: 0 / 0, inf / inf.
  const auto inverseRange = [&points, max_square] (std::size_t i) {
    const float square = squaredRange (points[i]);
    return square <= max_square ? std::sqrt (square) / square
                                : std::numeric_limits<float>::infinity();
  };
  const std::size_t down = side * static_cast<std::size_t> (points.width);
  const float square = squaredRange (points[first]);
  // That of an inverse range is sigma / range^2, to first order.
  const float sigma = 2.f * noise.sigma (square) / square;
  return std::abs (inverseRange (first) - inverseRange (first + side) -
                   inverseRange (first + down) + inverseRange (first + down + side)) /
         sigma;
}

} // namespace

DepthNoise
noiseIn (const OrganizedPoints& points, const DepthNoise& noise)
{
  if (!noise.is_least)
    return noise;
  const auto width = static_cast<std::size_t> (points.width),
             height = static_cast<std::size_t> (points.height);
  const std::size_t side =
      std::max<std::size_t> (1, std::max (width, height) / rectangles_in_a_row);
  std::array<float, (rectangles_in_a_row + 1) * (rectangles_in_a_row + 1)> errors;
  auto end = errors.begin();
  for (std::size_t v = 0; v + side < height; v += 2 * side)
    for (std::size_t u = 0; u + side < width; u += 2 * side) {
      *end = errorOfRectangle (points, noise, v * width + u, side);
      end += std::isfinite (*end);
    }
  if (end - errors.begin() < min_rectangles)
    return noise;
  const auto median = errors.begin() + (end - errors.begin()) / 2;
  std::nth_element (errors.begin(), median, end);
  DepthNoise result = noise.times (std::max (1.f, *median / median_size));
  result.is_least = false;
  return result;
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
  if (!(value.normal_scatter >= 1.f &&
        value.normal_scatter <= DepthNoise::max_normal_scatter)) {
    PCL_ERROR ("[pcl::%s::setDepthNoise] Normals scatter 1 to %g times as far as a "
               "Kinect's, got %g. Keeping what was set.\n",
               class_name.c_str(),
               DepthNoise::max_normal_scatter,
               value.normal_scatter);
    return;
  }
  noise = value;
}

} // namespace rgbd_planes
} // namespace pcl
