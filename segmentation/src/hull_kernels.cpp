// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hull_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "hull_kernels.h"
#include "vectors-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

static_assert (hull_block % RowRing<float>::lanes == 0, "blocks are whole vectors");

/** In each lane, the largest value so far and the number of its point. */
struct Furthest {
  V value;
  I point;

  Furthest()
  : value (set (-std::numeric_limits<float>::infinity()))
  , point (hn::Zero (Ints()))
  {}

  HWY_INLINE void
  look (V values, I points)
  {
    const auto is_further = hn::Gt (values, value);
    value = hn::IfThenElse (is_further, values, value);
    point = hn::IfThenElse (hn::RebindMask (Ints(), is_further), points, point);
  }

  HWY_INLINE std::uint32_t
  ofAll () const
  {
    float values[hull_block];
    std::int32_t points[hull_block];
    hn::StoreU (value, Floats(), values);
    hn::StoreU (point, Ints(), points);
    std::size_t best = 0;
    for (std::size_t k = 1; k < hn::Lanes (Floats()); ++k)
      if (values[k] > values[best])
        best = k;
    return static_cast<std::uint32_t> (points[best]);
  }
};

} // namespace

std::array<std::uint32_t, 8>
findOctagonHere (const float* xy, std::size_t size)
{
  Furthest furthest[8];
  auto points = hn::Iota (Ints(), 0);
  for (std::size_t i = 0; i < size; i += hn::Lanes (Floats())) {
    V x, y;
    hn::LoadInterleaved2 (Floats(), xy + 2 * i, x, y);
    const V values[4] = {x, hn::Add (x, y), y, hn::Sub (y, x)};
    for (std::size_t k = 0; k < 4; ++k) {
      furthest[k].look (values[k], points);
      furthest[k + 4].look (hn::Neg (values[k]), points);
    }
    points =
        hn::Add (points, hn::Set (Ints(), static_cast<int> (hn::Lanes (Floats()))));
  }
  std::array<std::uint32_t, 8> octagon;
  for (std::size_t k = 0; k < 8; ++k)
    octagon[k] = furthest[k].ofAll();
  return octagon;
}

std::size_t
dropInsideHere (const float* octagon, float* xy, std::size_t size)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < size; i += hn::Lanes (Floats())) {
    V x, y;
    hn::LoadInterleaved2 (Floats(), xy + 2 * i, x, y);
    auto is_outside = hn::MaskFromVec (hn::Zero (Floats()));
    for (std::size_t k = 0; k < 8; ++k) {
      const float *a = octagon + 2 * k, *b = octagon + 2 * ((k + 1) % 8);
      if (a[0] == b[0] && a[1] == b[1])
        continue;
      const V left = hn::Mul (set (b[0] - a[0]), hn::Sub (y, set (a[1])));
      const V right = hn::Mul (set (b[1] - a[1]), hn::Sub (x, set (a[0])));
      is_outside = hn::Or (is_outside, hn::Le (left, right));
    }
    if (hn::AllFalse (Floats(), is_outside))
      continue;
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits (Floats(), is_outside, bytes);
    for (std::size_t k = 0; k < hn::Lanes (Floats()); ++k) {
      xy[2 * kept] = xy[2 * (i + k)];
      xy[2 * kept + 1] = xy[2 * (i + k) + 1];
      kept += bytes[k / 8] >> k % 8 & 1;
    }
  }
  return kept;
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (findOctagonHere);
HWY_EXPORT (dropInsideHere);

std::array<std::uint32_t, 8>
findOctagon (const float* xy, std::size_t size)
{
  return HWY_DYNAMIC_DISPATCH (findOctagonHere) (xy, size);
}

std::size_t
dropInside (const float* octagon, float* xy, std::size_t size)
{
  return HWY_DYNAMIC_DISPATCH (dropInsideHere) (octagon, xy, size);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
