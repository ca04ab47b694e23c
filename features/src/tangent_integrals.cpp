// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tangent_integrals.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "row_vectors-inl.h"

#include <algorithm>
#include <array>

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

/** A vector of each of the channels that are added up together: one step of all of them after
 * another, as each step waits for the one before. */
using Channels = std::array<I, 3>;

#if HWY_TARGET == HWY_SCALAR
HWY_INLINE void
prefixSums (Channels&)
{}

HWY_INLINE I
lastLane (I v)
{
  return v;
}
#else
/** Adds the last lane of the first half of \a size lanes to each lane of the second half. */
template <int size>
HWY_INLINE void
addFirstHalves (Channels& channels)
{
  constexpr Ints d;
  constexpr std::int32_t half = size / 2;
  HWY_ALIGN std::int32_t from[RowRing<float>::lanes];
  HWY_ALIGN std::int32_t is_second[RowRing<float>::lanes];
  for (std::int32_t i = 0; i < static_cast<std::int32_t> (hn::Lanes (d)); ++i) {
    is_second[i] = i & half ? -1 : 0;
    from[i] = i & half ? i / half * half - 1 : 0;
  }
  const auto second = hn::MaskFromVec (hn::Load (d, is_second));
  const auto ends = hn::SetTableIndices (d, from);
  for (I& v : channels)
    v = hn::Add (v, hn::IfThenElseZero (second, hn::TableLookupLanes (v, ends)));
}

/** To each lane, the sum of all lanes up to it. */
HWY_INLINE void
prefixSums (Channels& channels)
{
  constexpr Ints d;
  for (I& v : channels)
    v = hn::Add (v, hn::ShiftLeftLanes<1> (d, v));
  for (I& v : channels)
    v = hn::Add (v, hn::ShiftLeftLanes<2> (d, v));
  if constexpr (hn::MaxLanes (d) > 4)
    addFirstHalves<8> (channels);
  if constexpr (hn::MaxLanes (d) > 8)
    addFirstHalves<16> (channels);
}

HWY_INLINE I
lastLane (I v)
{
  constexpr Ints d;
  if constexpr (hn::MaxLanes (d) > 4) {
    HWY_ALIGN std::int32_t from[RowRing<float>::lanes];
    std::fill_n (from, hn::Lanes (d), static_cast<std::int32_t> (hn::Lanes (d)) - 1);
    return hn::TableLookupLanes (v, hn::SetTableIndices (d, from));
  }
  else {
    return hn::Broadcast<3> (v);
  }
}
#endif

/** Continues the integral images of three channels. */
HWY_INLINE void
addUpChannels (std::size_t first,
               CellTangentRow tangents,
               std::size_t cells,
               std::size_t margin,
               TangentRow above,
               TangentRow integral)
{
  constexpr Ints d;
  constexpr std::size_t number = std::tuple_size<Channels>::value;
  const I zero = hn::Zero (d);
  Channels carry{{zero, zero, zero}}, v = carry;
  for (std::size_t i = 0; i < cells; i += hn::Lanes (d)) {
    const V scale = load (tangents[tangent_scale] + i);
    for (std::size_t c = 0; c < number; ++c)
      v[c] = nearestProduct (load (tangents[first + c] + i), scale);
    prefixSums (v);
    for (std::size_t c = 0; c < number; ++c) {
      hn::StoreU (
          hn::Add (hn::LoadU (d, above[first + c] + i), hn::Add (v[c], carry[c])),
          d,
          integral[first + c] + i);
      carry[c] = hn::Add (carry[c], lastLane (v[c]));
    }
  }
  for (std::size_t i = cells; i < cells + margin; i += hn::Lanes (d))
    for (std::size_t c = 0; c < number; ++c)
      hn::StoreU (hn::Add (hn::LoadU (d, above[first + c] + i), carry[c]),
                  d,
                  integral[first + c] + i);
}

} // namespace

void
addUpHere (const CellTangentRow& tangents,
           std::size_t cells,
           std::size_t margin,
           const TangentRow& above,
           const TangentRow& integral)
{
  for (const std::size_t first : {0, 3})
    addUpChannels (first, tangents, cells, margin, above, integral);
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
addUp (const CellTangentRow& tangents,
       std::size_t cells,
       std::size_t margin,
       const TangentRow& above,
       const TangentRow& integral)
{
  HWY_DYNAMIC_DISPATCH (addUpHere) (tangents, cells, margin, above, integral);
}

void
sumColumns (const WindowRows& rows, std::size_t columns, const WindowColumns& sums)
{
  HWY_DYNAMIC_DISPATCH (sumColumnsHere) (rows, columns, sums);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
