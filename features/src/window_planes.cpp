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

/** The differences of rows of integral images: sums over the columns to the left. */
HWY_INLINE void
subtractRows (std::size_t elements,
              const std::int32_t* below,
              const std::int32_t* above,
              std::int32_t* differences)
{
  constexpr Ints d;
  for (std::size_t i = 0; i < elements; i += hn::Lanes (d))
    hn::StoreU (hn::Sub (hn::LoadU (d, below + i), hn::LoadU (d, above + i)),
                d,
                differences + i);
}

/** The sums of three channels from column \a left to \a right. */
HWY_INLINE Vectors
sumBetween (TangentRow row,
            std::size_t first,
            std::ptrdiff_t left,
            std::ptrdiff_t right)
{
  constexpr Ints d;
  const auto sum = [=] (const std::int32_t* channel) HWY_ATTR {
    return hn::ConvertTo (
        Floats(),
        hn::Sub (hn::LoadU (d, channel + right), hn::LoadU (d, channel + left)));
  };
  return {sum (row[first]), sum (row[first + 1]), sum (row[first + 2])};
}

} // namespace

void
fitPlanesHere (WindowRows rows,
               std::size_t cells,
               std::size_t margin,
               CellRow points,
               FitBuffers buffers,
               PlaneRow planes)
{
  constexpr Floats d;
  const TangentRow whole = buffers.whole, lower_half = buffers.lower_half;
  const ChannelRow<float> inverse_lengths = buffers.inverse_lengths;
  for (std::size_t c = 0; c < tangent_channels; ++c) {
    // In front of a row, all sums are 0.
    const std::size_t elements = cells + margin;
    const std::int32_t* below = (c < 3 ? rows.below : rows.below_vertical)[c];
    subtractRows (elements, below, rows.top[c], whole[c]);
    subtractRows (elements, below, rows.middle[c], lower_half[c]);
  }

  for (std::size_t at = 0; at < cells; at += hn::Lanes (d)) {
    const auto i = static_cast<std::ptrdiff_t> (at);
    const std::ptrdiff_t left = i - rows.half_width, right = i + rows.half_width;
    const Vectors h = sumBetween (whole, 0, left, right);
    const Vectors v = sumBetween (whole, 3, left, right + 1);
    const Vectors crossed = cross (h, v);
    const Vectors p = load (points, cell_x, i);
    const V squared_length = dot (crossed, crossed);
    const V squared_h = dot (h, h), squared_v = dot (v, v);
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
    store (hn::Mul (squared_v, inverse), inverse_lengths[0] + i);
    store (hn::Mul (squared_h, inverse), inverse_lengths[1] + i);
    store (n, planes, plane_x, at);
    store (dot (n, p), planes[plane_distance] + i);
  }

  for (std::size_t at = 0; at < cells; at += hn::Lanes (d)) {
    const auto i = static_cast<std::ptrdiff_t> (at);
    const std::ptrdiff_t left = i - rows.half_width, right = i + rows.half_width;
    const Vectors n = load (planes, plane_x, i);
    // The tangents of a window together have no part along the normal, so that its halves
    // have opposite ones. The bend between their means is four times that of one of them:
    // for the halves left and right, and for those up and down.
    const auto squared = [=] (const Vectors& half, const Vectors& other_half) HWY_ATTR {
      const V a = dot (half, n), b = dot (other_half, n);
      return hn::MulAdd (a, a, hn::Mul (b, b));
    };
    const V bend_h = squared (sumBetween (whole, 0, i, right),
                              sumBetween (lower_half, 0, left, right));
    const V bend_v = squared (sumBetween (whole, 3, i, right + 1),
                              sumBetween (lower_half, 3, left, right + 1));
    const V squared_bend =
        hn::Mul (set (16.f),
                 hn::MulAdd (bend_h,
                             load (inverse_lengths[0] + i),
                             hn::Mul (bend_v, load (inverse_lengths[1] + i))));
    store (hn::IfThenElseZero (
               isPlane (n),
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
fitPlanes (WindowRows window,
           std::size_t cells,
           std::size_t margin,
           CellRow points,
           FitBuffers buffers,
           PlaneRow planes)
{
  HWY_DYNAMIC_DISPATCH (fitPlanesHere)
  (window, cells, margin, points, buffers, planes);
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
