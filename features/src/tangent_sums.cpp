// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tangent_sums.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "row_vectors-inl.h"
#include <hwy/cache_control.h>

#include <limits>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** Neighbouring points belong to one surface if their ranges differ by less than this
 * many deviations of depth, or if the surface is not seen at a flatter angle than this
 * slope, 76 degrees off its normal. */
constexpr float gate_sigmas = 3.5f;
constexpr float gate_slope = 4.f;

template <int step>
void
loadPixelsOf (const float* points,
              std::size_t cells,
              const SensorModel& sensor,
              PixelRow pixels)
{
  const V infinite = set (std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < cells; i += hn::Lanes (Floats())) {
    // The rows of an image are read one by one, with pauses.
    const float* next = points + 4 * step * (cells + i);
    for (std::size_t line = 0; line < 4 * step * hn::Lanes (Floats()); line += 16)
      hwy::Prefetch (next + line);
    usePoints<step> (
        points + 4 * step * i,
        sensor,
        [=, &sensor] (std::size_t k, const Points& loaded) HWY_ATTR {
          const std::size_t channel = k * pixel_channels;
          store (loaded.p, pixels, channel + cell_x, i);
          const V reach = reciprocal (
              hn::Mul (set (reach_sigmas), sigma (sensor, loaded.squared_range)));
          store (hn::IfThenElseZero (loaded.measured, reach),
                 pixels[channel + cell_reach] + i);
          store (hn::IfThenElse (loaded.measured,
                                 hn::Mul (loaded.squared_range,
                                          reciprocalSqrt (loaded.squared_range)),
                                 infinite),
                 pixels[channel + pixel_range] + i);
        });
  }
}

struct Pixels {
  Vectors p;
  V range;
};

HWY_INLINE Mask
isMeasured (V range)
{
  return hn::Lt (range, set (std::numeric_limits<float>::infinity()));
}

HWY_INLINE Pixels
loadPixel (PixelRow row, std::size_t first, std::size_t at)
{
  return {load (row, first + cell_x, static_cast<std::ptrdiff_t> (at)),
          load (row[first + pixel_range] + at)};
}

/** From points to their neighbours; zero where they lie on different surfaces. */
HWY_INLINE Vectors
tangents (const Pixels& from, const Pixels& to, const SensorModel& sensor)
{
  const Vectors tangent = to.p - from.p;
  const V change = hn::Sub (to.range, from.range);
  const V nearer = hn::Min (from.range, to.range);
  const V gate = hn::Mul (set (gate_sigmas), sigma (sensor, hn::Mul (nearer, nearer)));
  constexpr float slope = gate_slope * gate_slope;
  // Also false where a range is infinite.
  const Mask near =
      hn::Lt (hn::Mul (set (1.f + slope), hn::Mul (change, change)),
              hn::MulAdd (set (slope), dot (tangent, tangent), hn::Mul (gate, gate)));
  const V max_change = set (2.f * sensor.max_depth_change_factor);
  const V limit = hn::MulAdd (max_change, from.range, max_change);
  return onlyWhere (hn::And (near, hn::Le (hn::Abs (change), limit)), tangent);
}

/** The sums of horizontal and of vertical tangents. */
struct CellSums {
  Vectors horizontal, vertical;
};

template <int step>
HWY_INLINE CellSums
cellSums (const PixelRow* pixels, std::size_t at, const SensorModel& sensor)
{
  const auto link = [&] (const Pixels& from, const Pixels& to)
                        HWY_ATTR { return tangents (from, to, sensor); };
  const Pixels first = loadPixel (pixels[0], 0, at);
  if constexpr (step == 1)
    return {link (first, loadPixel (pixels[0], 0, at + 1)),
            link (first, loadPixel (pixels[1], 0, at))};
  else {
    const Pixels second = loadPixel (pixels[0], pixel_channels, at);
    const Pixels third = loadPixel (pixels[1], 0, at);
    const Pixels fourth = loadPixel (pixels[1], pixel_channels, at);
    return {
        (link (first, second) + link (second, loadPixel (pixels[0], 0, at + 1))) +
            (link (third, fourth) + link (fourth, loadPixel (pixels[1], 0, at + 1))),
        (link (first, third) + link (third, loadPixel (pixels[2], 0, at))) +
            (link (second, fourth) +
             link (fourth, loadPixel (pixels[2], pixel_channels, at)))};
  }
}

/** Writes a point of each cell, the first that is not missing. \return the range of it */
HWY_INLINE V
storeCellPoint (const PixelRow* pixels, std::size_t at, const CellRow& points)
{
  Pixels point = loadPixel (pixels[1], pixel_channels, at);
  V reach = load (pixels[1][pixel_channels + cell_reach] + at);
  for (const auto& [row, first] : {std::pair (1, 0), {0, pixel_channels}, {0, 0}}) {
    const Pixels better = loadPixel (pixels[row], first, at);
    const Mask measured = isMeasured (better.range);
    point = {choose (measured, better.p, point.p),
             hn::IfThenElse (measured, better.range, point.range)};
    reach =
        hn::IfThenElse (measured, load (pixels[row][first + cell_reach] + at), reach);
  }
  store (point.p, points, cell_x, at);
  store (hn::IfThenElseZero (isMeasured (point.range), reach), points[cell_reach] + at);
  return point.range;
}

template <int step>
void
sumTangentsOf (const PixelRow* pixels,
               std::size_t cells,
               const SensorModel& sensor,
               float units,
               SumRow sums,
               const CellRow& points)
{
  for (std::size_t i = 0; i < cells; i += hn::Lanes (Floats())) {
    V range;
    if constexpr (step == 1)
      range = load (pixels[0][pixel_range] + i);
    else
      range = storeCellPoint (pixels, i, points);
    const auto [h, v] = cellSums<step> (pixels, i, sensor);
    store (h, sums, 0, i);
    store (v, sums, 3, i);
    // Next to the sensor, tangents can be longer than the range.
    const V squared_longest =
        hn::Max (hn::Mul (range, range), hn::Max (dot (h, h), dot (v, v)));
    store (hn::IfThenElseZero (isMeasured (range),
                               hn::Mul (set (units), reciprocalSqrt (squared_longest))),
           sums[sum_scale] + i);
  }
}

} // namespace

void
loadPixelsHere (const float* points,
                std::size_t cells,
                int step,
                const SensorModel& sensor,
                const PixelRow& pixels)
{
  const auto load_pixels = step == 1 ? &loadPixelsOf<1> : &loadPixelsOf<2>;
  load_pixels (points, cells, sensor, pixels);
}

void
sumTangentsHere (const PixelRow* pixels,
                 std::size_t cells,
                 int step,
                 const SensorModel& sensor,
                 float units,
                 const SumRow& sums,
                 const CellRow& points)
{
  const auto sum_tangents = step == 1 ? &sumTangentsOf<1> : &sumTangentsOf<2>;
  sum_tangents (pixels, cells, sensor, units, sums, points);
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (loadPixelsHere);
HWY_EXPORT (sumTangentsHere);

void
loadPixels (const float* points,
            std::size_t cells,
            int step,
            const SensorModel& sensor,
            const PixelRow& pixels)
{
  HWY_DYNAMIC_DISPATCH (loadPixelsHere) (points, cells, step, sensor, pixels);
}

void
sumTangents (const PixelRow* pixels,
             std::size_t cells,
             int step,
             const SensorModel& sensor,
             float units,
             const SumRow& sums,
             const CellRow& points)
{
  HWY_DYNAMIC_DISPATCH (sumTangentsHere)
  (pixels, cells, step, sensor, units, sums, points);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
