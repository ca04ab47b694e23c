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

/** The sums of three channels over the window, and over its right and its lower half. */
struct WindowSums {
  Vectors all, right_half, lower_half;
};

/** From those of the columns to the left of columns \a left, \a center and \a right. */
HWY_INLINE WindowSums
sumWindow (const WindowRows& rows,
           TangentRow rows_below,
           std::size_t first,
           std::ptrdiff_t left,
           std::ptrdiff_t center,
           std::ptrdiff_t right)
{
  constexpr Ints d;
  V all[3], right_half[3], lower_half[3];
  for (std::size_t c = 0; c < 3; ++c) {
    const std::int32_t* top = rows.top[first + c];
    const std::int32_t* middle = rows.middle[first + c];
    const std::int32_t* below = rows_below[first + c];
    const auto toRight = [=] (const std::int32_t* row, std::ptrdiff_t from) HWY_ATTR {
      return hn::Sub (hn::LoadU (d, row + right), hn::LoadU (d, row + from));
    };
    const auto between = [=] (I above, I under) HWY_ATTR {
      return hn::ConvertTo (Floats(), hn::Sub (under, above));
    };
    const I whole = toRight (below, left);
    all[c] = between (toRight (top, left), whole);
    lower_half[c] = between (toRight (middle, left), whole);
    right_half[c] = between (toRight (top, center), toRight (below, center));
  }
  return {{all[0], all[1], all[2]},
          {right_half[0], right_half[1], right_half[2]},
          {lower_half[0], lower_half[1], lower_half[2]}};
}

} // namespace

void
fitPlanesHere (WindowRows rows, std::size_t cells, CellRow points, PlaneRow planes)
{
  constexpr Floats d;
  for (std::size_t at = 0; at < cells; at += hn::Lanes (d)) {
    const auto i = static_cast<std::ptrdiff_t> (at);
    const std::ptrdiff_t left = i - rows.half_width, right = i + rows.half_width;
    const WindowSums h = sumWindow (rows, rows.below, 0, left, i, right);
    const WindowSums v = sumWindow (rows, rows.below_vertical, 3, left, i, right + 1);
    const Vectors crossed = cross (h.all, v.all);
    const Vectors p = load (points, cell_x, i);
    const V squared_length = dot (crossed, crossed);
    const V squared_h = dot (h.all, h.all), squared_v = dot (v.all, v.all);
    const V product = hn::Mul (squared_h, squared_v);
    // Tangents that are zero or parallel span no surface.
    const Mask is_surface =
        hn::And (hn::Gt (load (points[cell_reach] + i), hn::Zero (d)),
                 hn::Gt (squared_length, hn::Mul (set (1e-8f), product)));
    const V towards_sensor = hn::CopySign (set (1.f), hn::Neg (dot (crossed, p)));
    const Vectors n =
        onlyWhere (is_surface,
                   crossed * hn::Mul (towards_sensor, reciprocalSqrt (squared_length)));
    const V inverse = reciprocal (product);
    store (n, planes, plane_x, at);
    store (dot (n, p), planes[plane_distance] + i);
    // The tangents of a window together have no part along the normal, so that its halves
    // have opposite ones. The bend between their means is four times that of one of them:
    // for the halves left and right, and for those up and down.
    const auto squared = [=] (const Vectors& half, const Vectors& other_half) HWY_ATTR {
      const V a = dot (half, n), b = dot (other_half, n);
      return hn::MulAdd (a, a, hn::Mul (b, b));
    };
    const V bend_h = squared (h.right_half, h.lower_half);
    const V bend_v = squared (v.right_half, v.lower_half);
    const V squared_bend =
        hn::Mul (hn::Mul (set (16.f), inverse),
                 hn::MulAdd (bend_h, squared_v, hn::Mul (bend_v, squared_h)));
    store (hn::IfThenElseZero (
               is_surface,
               reciprocal (hn::MulAdd (set (sharpness), squared_bend, set (1.f)))),
           planes[plane_weight] + i);
  }
}

void
chooseLargerHere (float min_range,
                  std::size_t cells,
                  CellRow points,
                  PlaneRow larger,
                  PlaneRow planes)
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
fitPlanes (WindowRows window, std::size_t cells, CellRow points, PlaneRow planes)
{
  HWY_DYNAMIC_DISPATCH (fitPlanesHere) (window, cells, points, planes);
}

void
chooseLarger (float min_range,
              std::size_t cells,
              CellRow points,
              PlaneRow larger,
              PlaneRow planes)
{
  HWY_DYNAMIC_DISPATCH (chooseLargerHere) (min_range, cells, points, larger, planes);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
