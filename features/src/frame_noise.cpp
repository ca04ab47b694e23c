// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/console/print.h>
#include <pcl/features/impl/frame_noise.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Rectangles along the longer side of the image, every second of which is looked at. */
constexpr std::size_t rectangles_in_a_row = 80;
/** So many are across an image of few rows. */
constexpr std::size_t rectangles_across = 5;
constexpr std::ptrdiff_t min_rectangles = 100;
/** Depth with more noise, in parts of the range, tells nothing. */
constexpr float max_noise_share = 0.1f;
/** The median of a normal distribution's sizes, in standard deviations. */
constexpr float median_size = 0.6745f;

/** The error of the rectangle with the corners \a first, \a right pixels further along a row, and
 * \a down pixels further along columns, in standard deviations; not finite where one of them is
 * missing, not \a selected, or beyond the range of the noise. */
float
errorOfRectangle (const OrganizedPoints& points,
                  const std::vector<std::uint8_t>& selected,
                  const DepthNoise& noise,
                  std::size_t first,
                  std::size_t right,
                  std::size_t down)
{
  const float max_square = noise.maxSquaredRange();
  // Not finite where it is missing: 0 / 0, inf / inf.
  const auto inverseRange = [&, max_square] (std::size_t i) {
    const float square = squaredRange (points[i]);
    return square <= max_square && (selected.empty() || selected[i])
               ? std::sqrt (square) / square
               : std::numeric_limits<float>::infinity();
  };
  const float square = squaredRange (points[first]);
  // That of an inverse range is sigma / range^2, to first order.
  const float sigma = 2.f * noise.sigmaAtSquare (square) / square;
  return std::abs (inverseRange (first) - inverseRange (first + right) -
                   inverseRange (first + down) + inverseRange (first + right + down)) /
         sigma;
}

/** Less the range in which depth tells nothing. */
DepthNoise
withinItsLimit (DepthNoise noise)
{
  noise.max_range = std::min (noise.max_range, max_noise_share / noise.quadratic);
  return noise;
}

} // namespace

DepthNoise
noiseIn (const OrganizedPoints& points,
         const std::vector<std::uint8_t>& selected,
         const DepthNoise& noise)
{
  DepthNoise result = withinItsLimit (noise);
  if (!noise.is_least)
    return result;
  const auto width = static_cast<std::size_t> (points.width),
             height = static_cast<std::size_t> (points.height);
  const auto sizeAlong = [&] (std::size_t side) {
    return std::clamp<std::size_t> (
        std::max (width, height) / rectangles_in_a_row,
        1,
        std::max<std::size_t> (side / rectangles_across, 1));
  };
  const std::size_t size_u = sizeAlong (width), size_v = sizeAlong (height);
  std::array<float, (rectangles_in_a_row + 1) * (rectangles_in_a_row + 1)> errors;
  auto end = errors.begin();
  // Where many pixels are missing, the rectangles between those count as well, and then others, of
  // which corners are in odd columns and rows.
  for (unsigned k = 0; k < 16 && end - errors.begin() < min_rectangles; ++k) {
    const bool between_u = k & 1, between_v = k & 2, others_u = k & 4, others_v = k & 8;
    if ((others_u && size_u == 1) || (others_v && size_v == 1))
      continue;
    const std::size_t first_u = between_u * size_u + others_u * (size_u / 2 | 1);
    const std::size_t first_v = between_v * size_v + others_v * (size_v / 2 | 1);
    for (std::size_t v = first_v; v + size_v < height; v += 2 * size_v)
      for (std::size_t u = first_u; u + size_u < width; u += 2 * size_u) {
        *end = errorOfRectangle (
            points, selected, result, v * width + u, size_u, size_v * width);
        end += std::isfinite (*end);
      }
  }
  if (end - errors.begin() < min_rectangles)
    return result;
  const auto median = errors.begin() + (end - errors.begin()) / 2;
  std::nth_element (errors.begin(), median, end);
  const float ratio = std::clamp (*median / median_size, 1.f, DepthNoise::max_ratio);
  result = withinItsLimit (result.times (ratio));
  result.is_least = false;
  return result;
}

void
setDepthNoise (const std::string& class_name,
               const DepthNoise& value,
               DepthNoise& noise)
{
  const float sigma = value.sigmaAtSquare (1.f);
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
