// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "window_planes.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "row_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** The planes of windows of twice the size have less noise: they are taken for more likely
 * also if they count a little less. */
constexpr float larger_bonus = 1.2f;
/** Makes the products of two sums, of 30 bits each, so small that their squares are floats. */
constexpr float scale = 0x1p-60f;

/** The sums of three channels over the window, and over its right and its lower half. */
struct WindowSums {
  Vectors all, right_half, lower_half;
};

/** Of the columns behind \a left up to \a right; the right half begins behind \a center. */
HWY_INLINE WindowSums
sumWindow (const WindowColumns& columns,
           std::size_t first,
           std::ptrdiff_t left,
           std::ptrdiff_t center,
           std::ptrdiff_t right)
{
  constexpr Ints d;
  V all[3], right_half[3], lower_half[3];
  for (std::size_t c = 0; c < 3; ++c) {
    const std::int32_t* whole = columns.whole[first + c];
    const std::int32_t* lower = columns.lower[first + c];
    const auto upToRight = [=] (const std::int32_t* sums,
                                std::ptrdiff_t from) HWY_ATTR {
      return hn::ConvertTo (
          Floats(), hn::Sub (hn::LoadU (d, sums + right), hn::LoadU (d, sums + from)));
    };
    all[c] = upToRight (whole, left);
    right_half[c] = upToRight (whole, center);
    lower_half[c] = upToRight (lower, left);
  }
  return {{all[0], all[1], all[2]},
          {right_half[0], right_half[1], right_half[2]},
          {lower_half[0], lower_half[1], lower_half[2]}};
}

} // namespace

void
fitPlanesHere (const WindowColumns& columns,
               std::ptrdiff_t half_width,
               std::size_t cells,
               const CellRow& points,
               const PlaneRow& planes)
{
  constexpr Floats d;
  for (std::size_t at = 0; at < cells; at += hn::Lanes (d)) {
    const auto i = static_cast<std::ptrdiff_t> (at);
    const std::ptrdiff_t before = i - 1;
    const std::ptrdiff_t left = before - half_width, right = before + half_width;
    const WindowSums h = sumWindow (columns, 0, left, before, right);
    const WindowSums v = sumWindow (columns, 3, left, before, right + 1);
    const Vectors crossed = cross (h.all * set (scale), v.all);
    const Vectors p = load (points, cell_x, i);
    const V squared_length = dot (crossed, crossed);
    const V squared_h = dot (h.all, h.all), squared_v = dot (v.all, v.all);
    // Tangents that are zero or parallel span no surface.
    const Mask is_surface =
        hn::And (hn::Gt (load (points[cell_reach] + i), hn::Zero (d)),
                 hn::Gt (squared_length,
                         hn::Mul (hn::Mul (squared_h, set (1e-8f * scale)),
                                  hn::Mul (squared_v, set (scale)))));
    const V inverse = hn::IfThenElseZero (is_surface, reciprocalSqrt (squared_length));
    const V along = dot (crossed, p);
    const V towards_sensor = hn::CopySign (inverse, hn::Neg (along));
    store (crossed * towards_sensor, planes, plane_x, at);
    store (hn::Mul (along, towards_sensor), planes[plane_distance] + i);
    // The tangents of a window together have no part along the normal, so that its halves
    // have opposite ones. The bend between their means is four times that of one of them:
    // for the halves left and right, and for those up and down.
    const auto squared = [&] (const Vectors& half, const Vectors& other_half) HWY_ATTR {
      const V a = dot (half, crossed), b = dot (other_half, crossed);
      return hn::MulAdd (a, a, hn::Mul (b, b));
    };
    const V bend_h = squared (h.right_half, h.lower_half);
    const V bend_v = squared (v.right_half, v.lower_half);
    const V factor = hn::Mul (
        hn::Mul (inverse, inverse),
        hn::Mul (set (16.f * sharpness), reciprocal (hn::Mul (squared_h, squared_v))));
    const V bend = hn::MulAdd (bend_h, squared_v, hn::Mul (bend_v, squared_h));
    store (hn::IfThenElseZero (is_surface,
                               reciprocal (hn::MulAdd (factor, bend, set (1.f)))),
           planes[plane_weight] + i);
  }
}

void
chooseLargerHere (float min_range,
                  std::size_t cells,
                  const CellRow& points,
                  const PlaneRow& larger,
                  const PlaneRow& planes)
{
  constexpr Floats d;
  for (std::size_t at = 0; at < cells; at += hn::Lanes (d)) {
    const auto i = static_cast<std::ptrdiff_t> (at);
    const Vectors p = load (points, cell_x, i);
    const V weight = load (larger[plane_weight] + i);
    const V old_weight = load (planes[plane_weight] + i);
    const Mask better = min_range > 0.f
                            ? hn::Gt (dot (p, p), set (min_range * min_range))
                            : hn::Gt (hn::Mul (weight, set (larger_bonus)), old_weight);
    for (std::size_t c = 0; c < plane_channels; ++c)
      store (hn::IfThenElse (better, load (larger[c] + i), load (planes[c] + i)),
             planes[c] + i);
  }
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (fitPlanesHere);
HWY_EXPORT (chooseLargerHere);

void
fitPlanes (const WindowColumns& columns,
           std::ptrdiff_t half_width,
           std::size_t cells,
           const CellRow& points,
           const PlaneRow& planes)
{
  HWY_DYNAMIC_DISPATCH (fitPlanesHere) (columns, half_width, cells, points, planes);
}

void
chooseLarger (float min_range,
              std::size_t cells,
              const CellRow& points,
              const PlaneRow& larger,
              const PlaneRow& planes)
{
  HWY_DYNAMIC_DISPATCH (chooseLargerHere) (min_range, cells, points, larger, planes);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
