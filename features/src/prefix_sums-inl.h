// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// Integral images, row by row, for the files that are compiled once for each set of
// instructions.

#if defined(PCL_RGBD_PLANES_PREFIX_SUMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_RGBD_PLANES_PREFIX_SUMS_INL_H
#undef PCL_RGBD_PLANES_PREFIX_SUMS_INL_H
#else
#define PCL_RGBD_PLANES_PREFIX_SUMS_INL_H
#endif

#include "row_vectors-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR
/** To each lane, the sum of all lanes up to it; to \a last, that of all lanes. */
HWY_INLINE I
prefixSums (I v, I& last)
{
  last = v;
  return v;
}
#else
/** To each lane in the second half of \a size lanes, the last lane of the first half. */
template <int size>
HWY_INLINE I
endOfFirstHalf (I v)
{
  constexpr Ints d;
  constexpr std::int32_t half = size / 2;
  HWY_ALIGN std::int32_t from[RowRing<float>::lanes];
  HWY_ALIGN std::int32_t is_second[RowRing<float>::lanes];
  for (std::int32_t i = 0; i < static_cast<std::int32_t> (hn::Lanes (d)); ++i) {
    is_second[i] = i & half ? -1 : 0;
    from[i] = i & half ? i / half * half - 1 : 0;
  }
  return hn::And (hn::Load (d, is_second),
                  hn::TableLookupLanes (v, hn::SetTableIndices (d, from)));
}

HWY_INLINE I
prefixSums (I v, I& last)
{
  constexpr Ints d;
  v = hn::Add (v, hn::ShiftLeftLanes<1> (d, v));
  v = hn::Add (v, hn::ShiftLeftLanes<2> (d, v));
  if constexpr (hn::MaxLanes (d) > 4)
    v = hn::Add (v, endOfFirstHalf<8> (v));
  if constexpr (hn::MaxLanes (d) > 8)
    v = hn::Add (v, endOfFirstHalf<16> (v));
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

/** Makes a row of integral images of a row of sums, and continues it. */
HWY_INLINE void
addUp (std::size_t cells,
       std::size_t margin,
       const std::int32_t* above,
       std::int32_t* integral)
{
  constexpr Ints d;
  I carry = hn::Zero (d);
  for (std::size_t i = 0; i < cells; i += hn::Lanes (d)) {
    I last;
    const I sum = prefixSums (hn::LoadU (d, integral + i), last);
    hn::StoreU (
        hn::Add (hn::LoadU (d, above + i), hn::Add (sum, carry)), d, integral + i);
    carry = hn::Add (carry, last);
  }
  for (std::size_t i = cells; i < cells + margin; i += hn::Lanes (d))
    hn::StoreU (hn::Add (hn::LoadU (d, above + i), carry), d, integral + i);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#endif
