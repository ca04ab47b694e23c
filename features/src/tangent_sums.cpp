// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tangent_sums.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "prefix_sums-inl.h"
#include "row_vectors-inl.h"
#include <hwy/cache_control.h>

#include <limits>

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
          store (loaded.p, pixels, channel + pixel_x, i);
          store (hn::IfThenElse (
                     loaded.measured, hn::Sqrt (loaded.squared_range), infinite),
                 pixels[channel + pixel_range] + i);
          store (hn::Mul (set (gate_sigmas), sigma (sensor, loaded.squared_range)),
                 pixels[channel + pixel_gate] + i);
        });
  }
}

struct Pixels {
  Vectors p;
  V range;
  V gate;
};

HWY_INLINE Mask
isMeasured (const Pixels& pixels)
{
  return hn::Lt (pixels.range, set (std::numeric_limits<float>::infinity()));
}

HWY_INLINE Pixels
loadPixel (PixelRow row, std::size_t first, std::size_t at)
{
  return {load (row, first + pixel_x, static_cast<std::ptrdiff_t> (at)),
          load (row[first + pixel_range] + at),
          load (row[first + pixel_gate] + at)};
}

/** From points to their neighbours; zero where they lie on different surfaces. */
HWY_INLINE Vectors
tangents (const Pixels& from, const Pixels& to, V max_change)
{
  const Vectors tangent = to.p - from.p;
  const V change = hn::Sub (to.range, from.range);
  const V gate = hn::Min (from.gate, to.gate);
  constexpr float slope = gate_slope * gate_slope;
  // Also false where a range is infinite.
  const Mask near =
      hn::Lt (hn::Mul (set (1.f + slope), hn::Mul (change, change)),
              hn::MulAdd (set (slope), dot (tangent, tangent), hn::Mul (gate, gate)));
  const V limit = hn::MulAdd (max_change, from.range, max_change);
  return onlyWhere (hn::And (near, hn::Le (hn::Abs (change), limit)), tangent);
}

struct CellSums {
  Pixels point;
  Vectors horizontal;
  Vectors vertical;
};

/** The tangents that begin in the pixels of the cells, and a point of each. */
template <int step>
HWY_INLINE CellSums
cellSums (const PixelRow* pixels, std::size_t at, V max_change)
{
  const auto link = [=] (const Pixels& from, const Pixels& to)
                        HWY_ATTR { return tangents (from, to, max_change); };
  const Pixels first = loadPixel (pixels[0], 0, at);
  if constexpr (step == 1)
    return {first,
            link (first, loadPixel (pixels[0], 0, at + 1)),
            link (first, loadPixel (pixels[1], 0, at))};
  else {
    const Pixels second = loadPixel (pixels[0], pixel_channels, at);
    const Pixels third = loadPixel (pixels[1], 0, at);
    const Pixels fourth = loadPixel (pixels[1], pixel_channels, at);
    CellSums sums;
    sums.horizontal =
        (link (first, second) + link (second, loadPixel (pixels[0], 0, at + 1))) +
        (link (third, fourth) + link (fourth, loadPixel (pixels[1], 0, at + 1)));
    sums.vertical = (link (first, third) + link (third, loadPixel (pixels[2], 0, at))) +
                    (link (second, fourth) +
                     link (fourth, loadPixel (pixels[2], pixel_channels, at)));
    sums.point = fourth;
    for (const Pixels* better : {&third, &second, &first}) {
      const Mask measured = isMeasured (*better);
      sums.point = {choose (measured, better->p, sums.point.p),
                    hn::IfThenElse (measured, better->range, sums.point.range),
                    hn::IfThenElse (measured, better->gate, sums.point.gate)};
    }
    return sums;
  }
}

HWY_INLINE V
largestOf (const Vectors& a)
{
  return hn::Max (hn::Abs (a.x), hn::Max (hn::Abs (a.y), hn::Abs (a.z)));
}

template <int step>
void
sumTangentsOf (const PixelRow* pixels,
               std::size_t cells,
               const SensorModel& sensor,
               float units,
               std::size_t margin,
               TangentRow above,
               TangentRow integral,
               CellRow points)
{
  constexpr Ints d;
  const std::size_t lanes = hn::Lanes (d);
  const V max_change = set (2.f * sensor.max_depth_change_factor);
  for (std::size_t i = 0; i < cells; i += lanes) {
    const CellSums sums = cellSums<step> (pixels, i, max_change);
    const Pixels& point = sums.point;
    const Mask measured = isMeasured (point);
    store (point.p, points, cell_x, i);
    store (hn::IfThenElseZero (
               measured,
               hn::Mul (set (gate_sigmas / reach_sigmas), reciprocal (point.gate))),
           points[cell_reach] + i);
    // Next to the viewpoint, tangents can be longer than the range.
    const V longest = hn::Max (largestOf (sums.horizontal), largestOf (sums.vertical));
    const V scale = hn::IfThenElseZero (
        measured, hn::Mul (set (units), reciprocal (hn::Max (point.range, longest))));
    const auto storeSum = [&] (V sum, std::size_t channel) HWY_ATTR {
      hn::StoreU (hn::NearestInt (hn::Mul (sum, scale)), d, integral[channel] + i + 1);
    };
    storeSum (sums.horizontal.x, 0);
    storeSum (sums.horizontal.y, 1);
    storeSum (sums.horizontal.z, 2);
    storeSum (sums.vertical.x, 3);
    storeSum (sums.vertical.y, 4);
    storeSum (sums.vertical.z, 5);
  }
  for (std::size_t c = 0; c < tangent_channels; ++c)
    addUp (cells, margin, above[c] + 1, integral[c] + 1);
}

} // namespace

void
loadPixelsHere (const float* points,
                std::size_t cells,
                int step,
                const SensorModel& sensor,
                PixelRow pixels)
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
                 std::size_t margin,
                 TangentRow above,
                 TangentRow integral,
                 CellRow points)
{
  const auto sum_tangents = step == 1 ? &sumTangentsOf<1> : &sumTangentsOf<2>;
  sum_tangents (pixels, cells, sensor, units, margin, above, integral, points);
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
            PixelRow pixels)
{
  HWY_DYNAMIC_DISPATCH (loadPixelsHere) (points, cells, step, sensor, pixels);
}

void
sumTangents (const PixelRow* pixels,
             std::size_t cells,
             int step,
             const SensorModel& sensor,
             float units,
             std::size_t margin,
             TangentRow above,
             TangentRow integral,
             CellRow points)
{
  HWY_DYNAMIC_DISPATCH (sumTangentsHere)
  (pixels, cells, step, sensor, units, margin, above, integral, points);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
