// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tangent_integrals.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "row_vectors-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** The integers nearest to \a a times \a b, of at most 23 bits with the sign: those of the
 * mantissa once 1.5 * 2^23 is added. NearestInt looks after larger ones, and takes three times as
 * long. */
HWY_INLINE I
nearestProduct (V a, V b)
{
  constexpr float shift = 0x1.8p23f;
  return hn::Sub (hn::BitCast (Ints(), hn::MulAdd (a, b, set (shift))),
                  hn::BitCast (Ints(), set (shift)));
}

#if HWY_TARGET == HWY_SCALAR
/** To each lane, the sum of all lanes up to it; to \a last, that of all lanes. */
HWY_INLINE I
prefixSums (I v, I& last)
{
  last = v;
  return v;
}
#else
/** Adds the last lane of the first half of \a size lanes to each lane of the second half. */
template <int size>
HWY_INLINE I
addFirstHalves (I v)
{
  constexpr Ints d;
  constexpr std::int32_t half = size / 2;
  HWY_ALIGN std::int32_t from[RowRing<float>::lanes];
  HWY_ALIGN std::int32_t is_second[RowRing<float>::lanes];
  for (std::int32_t i = 0; i < static_cast<std::int32_t> (hn::Lanes (d)); ++i) {
    is_second[i] = i & half ? -1 : 0;
    from[i] = i & half ? i / half * half - 1 : 0;
  }
  const I ends = hn::TableLookupLanes (v, hn::SetTableIndices (d, from));
  return hn::IfThenElse (
      hn::MaskFromVec (hn::Load (d, is_second)), hn::Add (v, ends), v);
}

HWY_INLINE I
prefixSums (I v, I& last)
{
  constexpr Ints d;
  v = hn::Add (v, hn::ShiftLeftLanes<1> (d, v));
  v = hn::Add (v, hn::ShiftLeftLanes<2> (d, v));
  if constexpr (hn::MaxLanes (d) > 4)
    v = addFirstHalves<8> (v);
  if constexpr (hn::MaxLanes (d) > 8)
    v = addFirstHalves<16> (v);
  if constexpr (hn::MaxLanes (d) > 4) {
    HWY_ALIGN std::int32_t from[RowRing<float>::lanes];
    std::fill_n (from, hn::Lanes (d), static_cast<std::int32_t> (hn::Lanes (d)) - 1);
    last = hn::TableLookupLanes (v, hn::SetTableIndices (d, from));
  }
  else {
    last = hn::Broadcast<3> (v);
  }
  return v;
}
#endif

/** Continues the integral image of one channel. */
HWY_INLINE void
addUpChannel (const float* sums,
              const float* scale,
              std::size_t cells,
              std::size_t margin,
              const std::int32_t* above,
              std::int32_t* integral)
{
  constexpr Ints d;
  I carry = hn::Zero (d);
  for (std::size_t i = 0; i < cells; i += hn::Lanes (d)) {
    I last;
    const I sum = prefixSums (nearestProduct (load (sums + i), load (scale + i)), last);
    hn::StoreU (
        hn::Add (hn::LoadU (d, above + i), hn::Add (sum, carry)), d, integral + i);
    carry = hn::Add (carry, last);
  }
  for (std::size_t i = cells; i < cells + margin; i += hn::Lanes (d))
    hn::StoreU (hn::Add (hn::LoadU (d, above + i), carry), d, integral + i);
}

} // namespace

void
addUpHere (const SumRow& sums,
           std::size_t cells,
           std::size_t margin,
           const TangentRow& above,
           const TangentRow& integral)
{
  for (std::size_t c = 0; c < tangent_channels; ++c)
    addUpChannel (sums[c], sums[sum_scale], cells, margin, above[c], integral[c]);
}

void
sumColumnsHere (const WindowRows& rows, std::size_t columns, const WindowColumns& sums)
{
  constexpr Ints d;
  for (std::size_t c = 0; c < tangent_channels; ++c) {
    const std::int32_t* top = rows.top[c];
    const std::int32_t* middle = rows.middle[c];
    const std::int32_t* below = (c < 3 ? rows.below : rows.below_vertical)[c];
    std::int32_t* whole = sums.whole[c];
    std::int32_t* lower = sums.lower[c];
    for (std::size_t i = 0; i < columns; i += hn::Lanes (d)) {
      const I sum = hn::LoadU (d, below + i);
      hn::StoreU (hn::Sub (sum, hn::LoadU (d, top + i)), d, whole + i);
      hn::StoreU (hn::Sub (sum, hn::LoadU (d, middle + i)), d, lower + i);
    }
  }
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (addUpHere);
HWY_EXPORT (sumColumnsHere);

void
addUp (const SumRow& sums,
       std::size_t cells,
       std::size_t margin,
       const TangentRow& above,
       const TangentRow& integral)
{
  HWY_DYNAMIC_DISPATCH (addUpHere) (sums, cells, margin, above, integral);
}

void
sumColumns (const WindowRows& rows, std::size_t columns, const WindowColumns& sums)
{
  HWY_DYNAMIC_DISPATCH (sumColumnsHere) (rows, columns, sums);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
