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
    usePoints<step> (points + 4 * step * i,
                     sensor,
                     [=, &sensor] (std::size_t k, const Points& loaded) HWY_ATTR {
                       const std::size_t channel = k * pixel_channels;
                       store (loaded.p, pixels, channel + cell_x, i);
                       const V reach = reciprocal (hn::Mul (
                           set (reach_sigmas), sigma (sensor, loaded.squared_range)));
                       store (hn::IfThenElseZero (loaded.measured, reach),
                              pixels[channel + cell_reach] + i);
                       store (hn::IfThenElse (loaded.measured,
                                              hn::Sqrt (loaded.squared_range),
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

/** The square of how much noise changes a range. */
HWY_INLINE V
squaredGate (V range, const SensorModel& sensor)
{
  const V gate = hn::Mul (set (gate_sigmas), sigma (sensor, hn::Mul (range, range)));
  return hn::Mul (gate, gate);
}

/** From points to their neighbours; zero where they lie on different surfaces. */
HWY_INLINE Vectors
tangents (const Pixels& from,
          const Pixels& to,
          V squared_step,
          V squared_gate,
          const SensorModel& sensor)
{
  const Vectors tangent = to.p - from.p;
  const V change = hn::Sub (to.range, from.range);
  constexpr float slope = gate_slope * gate_slope;
  // Also false where a range is infinite.
  const Mask near =
      hn::Or (hn::Lt (squared_step, squared_gate),
              hn::Lt (hn::Mul (set (1.f + slope), hn::Mul (change, change)),
                      hn::MulAdd (set (slope), dot (tangent, tangent), squared_gate)));
  const V max_change = set (2.f * sensor.max_depth_change_factor);
  const V limit = hn::MulAdd (max_change, from.range, max_change);
  return onlyWhere (hn::And (near, hn::Le (hn::Abs (change), limit)), tangent);
}

/** The sums of horizontal and of vertical tangents. */
struct CellSums {
  Vectors horizontal, vertical;
};

/** Of cells of one pixel. Surfaces seen at a flatter angle are told from steps by the next two
 * pixels: the range changes by the same from each to the next. */
HWY_INLINE CellSums
pixelSums (const PixelRow* pixels, std::size_t at, const SensorModel& sensor)
{
  const Pixels first = loadPixel (pixels[0], 0, at);
  const V squared_gate = squaredGate (first.range, sensor);
  const auto link = [&] (const Pixels& to, V third, V fourth) HWY_ATTR {
    const V change = hn::Sub (third, to.range);
    const V before = hn::Sub (change, hn::Sub (to.range, first.range));
    const V behind = hn::Sub (change, hn::Sub (fourth, third));
    return tangents (first,
                     to,
                     hn::Max (hn::Mul (before, before), hn::Mul (behind, behind)),
                     squared_gate,
                     sensor);
  };
  const auto range = [&] (std::size_t row, std::size_t column) HWY_ATTR {
    return load (pixels[row][pixel_range] + at + column);
  };
  return {link (loadPixel (pixels[0], 0, at + 1), range (0, 2), range (0, 3)),
          link (loadPixel (pixels[1], 0, at), range (2, 0), range (3, 0))};
}

/** The square of the step between the first two of four pixels in a line, in the mean of
 * two lines, of whose ranges these are the sums: how much more the range changes there than
 * between the last two. Slant has no part in that. Differences that the noise on slanted
 * surfaces makes too large are so in one direction only: without them, normals would turn
 * towards the sensor. */
HWY_INLINE V
squaredStep (V first, V second, V third, V fourth)
{
  const V change = hn::Sub (second, first);
  const V step = hn::Mul (set (0.5f), hn::Sub (change, hn::Sub (fourth, third)));
  return hn::Mul (step, step);
}

/** Of cells of 2 x 2 pixels. */
HWY_INLINE CellSums
cellSums (const PixelRow* pixels, std::size_t at, const SensorModel& sensor)
{
  const auto range = [&] (std::size_t row, std::size_t column) HWY_ATTR {
    const std::size_t channel = column % 2 * pixel_channels + pixel_range;
    return load (pixels[row][channel] + at + column / 2);
  };
  const auto inColumn = [&] (std::size_t column) HWY_ATTR {
    return hn::Add (range (0, column), range (1, column));
  };
  const auto inRow = [&] (std::size_t row)
                         HWY_ATTR { return hn::Add (range (row, 0), range (row, 1)); };
  const V c1 = inColumn (1), c2 = inColumn (2), c3 = inColumn (3);
  const V r1 = inRow (1), r2 = inRow (2), r3 = inRow (3);
  const V right = squaredStep (inColumn (0), c1, c2, c3);
  const V next_right = squaredStep (c1, c2, c3, inColumn (4));
  const V down = squaredStep (inRow (0), r1, r2, r3);
  const V next_down = squaredStep (r1, r2, r3, inRow (4));

  const Pixels first = loadPixel (pixels[0], 0, at);
  const Pixels second = loadPixel (pixels[0], pixel_channels, at);
  const Pixels third = loadPixel (pixels[1], 0, at);
  const Pixels fourth = loadPixel (pixels[1], pixel_channels, at);
  const V nearest = hn::Min (hn::Min (first.range, second.range),
                             hn::Min (third.range, fourth.range));
  const V squared_gate = squaredGate (nearest, sensor);
  const auto link =
      [&] (const Pixels& from, const Pixels& to, V squared_step)
          HWY_ATTR { return tangents (from, to, squared_step, squared_gate, sensor); };
  return {(link (first, second, right) +
           link (second, loadPixel (pixels[0], 0, at + 1), next_right)) +
              (link (third, fourth, right) +
               link (fourth, loadPixel (pixels[1], 0, at + 1), next_right)),
          (link (first, third, down) +
           link (third, loadPixel (pixels[2], 0, at), next_down)) +
              (link (second, fourth, down) +
               link (fourth, loadPixel (pixels[2], pixel_channels, at), next_down))};
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
    const auto [h, v] =
        step == 1 ? pixelSums (pixels, i, sensor) : cellSums (pixels, i, sensor);
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
