// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pixel_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "plane_vectors-inl.h"

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

using Ints = hn::RebindToSigned<Floats>;

/** The \a number points, at most a vector, from \a from on; NaN follows. */
HWY_INLINE Points
loadPoints (const float* from, std::size_t stride, std::size_t number)
{
  Points p;
  if (stride == 4 && number == hn::Lanes (Floats())) {
    V unused;
    hn::LoadInterleaved4 (Floats(), from, p.x, p.y, p.z, unused);
    return p;
  }
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  float x[PlaneSamples::tile_size], y[PlaneSamples::tile_size],
      z[PlaneSamples::tile_size];
  std::fill (x, x + PlaneSamples::tile_size, nan);
  std::fill (y, y + PlaneSamples::tile_size, nan);
  std::fill (z, z + PlaneSamples::tile_size, nan);
  for (std::size_t k = 0; k < number; ++k) {
    x[k] = from[k * stride];
    y[k] = from[k * stride + 1];
    z[k] = from[k * stride + 2];
  }
  return {load (x), load (y), load (z)};
}

HWY_INLINE hn::Vec<Ints>
loadLabels (const std::uint32_t* labels, std::size_t number)
{
  std::int32_t values[PlaneSamples::tile_size] = {};
  std::copy_n (labels, number, values);
  return hn::LoadU (Ints(), values);
}

HWY_INLINE void
storeLabels (hn::Vec<Ints> values, std::uint32_t* labels, std::size_t number)
{
  std::int32_t copy[PlaneSamples::tile_size];
  hn::StoreU (values, Ints(), copy);
  std::copy_n (copy, number, labels);
}

HWY_INLINE V
squaredRange (const Points& p)
{
  return hn::MulAdd (p.x, p.x, hn::MulAdd (p.y, p.y, hn::Mul (p.z, p.z)));
}

HWY_INLINE V
sigma (V squared_range, const DepthNoise& noise)
{
  return hn::MulAdd (squared_range, set (noise.quadratic), set (noise.constant));
}

/** Calls \a body (offset in points from the first pixel, column, row, number of points)
 * for each vector of pixels. */
template <typename Body>
HWY_INLINE void
forEachVector (const TilePixels& pixels, const Body& body)
{
  const std::size_t lanes = hn::Lanes (Floats());
  const auto width = static_cast<std::size_t> (pixels.width);
  for (int v = 0; v < pixels.height; ++v)
    for (std::size_t u = 0; u < width; u += lanes)
      body (static_cast<std::size_t> (v) * pixels.image_width + u,
            u,
            v,
            std::min (lanes, width - u));
}

/** All bits set where the sample of a pixel in a row is compatible. */
HWY_INLINE Mask
compatiblePixels (const TilePlane& plane, int step, std::size_t u, int v)
{
  constexpr int side = PlaneSamples::tile_side;
  const int row = (plane.compatible >> (v / step * side)) & ((1 << side) - 1);
  if (row == (1 << side) - 1)
    return hn::MaskFromVec (hn::BitCast (Floats(), hn::Set (Ints(), -1)));
  std::int32_t values[PlaneSamples::tile_size];
  for (std::size_t k = 0; k < PlaneSamples::tile_size; ++k)
    values[k] = -((row >> (static_cast<int> (u + k) / step)) & 1);
  return hn::MaskFromVec (hn::BitCast (Floats(), hn::LoadU (Ints(), values)));
}

} // namespace

void
assignPixelsHere (const TilePixels& pixels,
                  const TilePlane* planes,
                  std::size_t number,
                  const DepthNoise& noise,
                  float max_sigmas,
                  std::uint32_t none,
                  std::uint32_t* labels)
{
  const V farthest =
      set (std::min (noise.max_range * noise.max_range, max_squared_range));
  forEachVector (pixels, [&] (std::size_t offset, std::size_t u, int v, std::size_t n) {
    const Points p =
        loadPoints (pixels.first + offset * pixels.stride, pixels.stride, n);
    const V squared_range = squaredRange (p);
    const Mask measured = hn::And (hn::Gt (squared_range, set (min_squared_range)),
                                   hn::Le (squared_range, farthest));
    const V deviation = sigma (squared_range, noise);
    const V relative = hn::Div (deviation, hn::Sqrt (squared_range));
    const V flattest = hn::Mul (deviation, set (min_view_cosine));
    V nearest = set (max_sigmas);
    auto label = hn::Set (Ints(), static_cast<std::int32_t> (none));
    for (std::size_t k = 0; k < number; ++k) {
      const PlaneEquation& plane = planes[k].equation;
      const V distance = hn::Abs (hn::Add (dot (plane, p), set (plane.d)));
      const V deviations =
          hn::Div (distance, hn::Max (hn::Mul (relative, set (plane.d)), flattest));
      const Mask on = hn::And (hn::And (measured, hn::Le (deviations, nearest)),
                               compatiblePixels (planes[k], pixels.step, u, v));
      nearest = hn::IfThenElse (on, deviations, nearest);
      label = hn::IfThenElse (
          hn::RebindMask (Ints(), on),
          hn::Set (Ints(), static_cast<std::int32_t> (planes[k].number)),
          label);
    }
    storeLabels (label, labels + offset, n);
  });
}

void
sumPixelsHere (const TilePixels& pixels,
               const std::uint32_t* labels,
               std::uint32_t label,
               const DepthNoise& noise,
               const double (&reference)[3],
               double (&sums)[10],
               double (&weighted)[10])
{
  Sums ones, weights;
  const auto wanted = hn::Set (Ints(), static_cast<std::int32_t> (label));
  forEachVector (pixels, [&] (std::size_t offset, std::size_t, int, std::size_t n) {
    Mask on =
        hn::RebindMask (Floats(), hn::Eq (loadLabels (labels + offset, n), wanted));
    if (n < hn::Lanes (Floats()))
      on = hn::And (on, hn::FirstN (Floats(), n));
    if (hn::AllFalse (Floats(), on))
      return;
    const Points p =
        loadPoints (pixels.first + offset * pixels.stride, pixels.stride, n);
    const V squared_range = squaredRange (p);
    const V deviation = sigma (squared_range, noise);
    const V weight = hn::IfThenElseZero (
        on, hn::Div (squared_range, hn::Mul (deviation, deviation)));
    const Points relative = {
        hn::IfThenElseZero (on, hn::Sub (p.x, set (static_cast<float> (reference[0])))),
        hn::IfThenElseZero (on, hn::Sub (p.y, set (static_cast<float> (reference[1])))),
        hn::IfThenElseZero (on,
                            hn::Sub (p.z, set (static_cast<float> (reference[2]))))};
    ones.add (relative, hn::IfThenElseZero (on, set (1.f)));
    weights.add (relative, weight);
  });
  totals (ones, sums);
  totals (weights, weighted);
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (assignPixelsHere);
HWY_EXPORT (sumPixelsHere);

void
assignPixels (const TilePixels& pixels,
              const TilePlane* planes,
              std::size_t number,
              const DepthNoise& noise,
              float max_sigmas,
              std::uint32_t none,
              std::uint32_t* labels)
{
  HWY_DYNAMIC_DISPATCH (assignPixelsHere)
  (pixels, planes, number, noise, max_sigmas, none, labels);
}

void
sumPixels (const TilePixels& pixels,
           const std::uint32_t* labels,
           std::uint32_t label,
           const DepthNoise& noise,
           const double (&reference)[3],
           double (&sums)[10],
           double (&weighted)[10])
{
  HWY_DYNAMIC_DISPATCH (sumPixelsHere)
  (pixels, labels, label, noise, reference, sums, weighted);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
