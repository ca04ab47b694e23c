// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// Bits of RowBits from vectors, for the files that are compiled once for each set of
// instructions.

#if defined(PCL_RGBD_PLANES_MASK_BITS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_RGBD_PLANES_MASK_BITS_INL_H
#undef PCL_RGBD_PLANES_MASK_BITS_INL_H
#else
#define PCL_RGBD_PLANES_MASK_BITS_INL_H
#endif

#include "plane_vectors-inl.h"
#include "row_bits.h"

#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** As many as there are bits in a word, or in as many vectors as fill it. */
using Bytes = hn::CappedTag<std::uint8_t, bits_in_word>;

/** A bit for each lane of a mask. */
template <typename D>
HWY_INLINE std::uint64_t
bitsOf (D d, hn::Mask<D> mask)
{
  constexpr std::size_t lanes = hn::MaxLanes (D());
  using Bits = std::conditional_t<
      lanes <= 8,
      std::uint8_t,
      std::conditional_t<
          lanes <= 16,
          std::uint16_t,
          std::conditional_t<lanes <= 32, std::uint32_t, std::uint64_t>>>;
  Bits bits;
  hn::StoreMaskBits (d, mask, reinterpret_cast<std::uint8_t*> (&bits));
  return bits;
}

/** \a value where \a bits are set, else 0. */
HWY_INLINE hn::Vec<Bytes>
bytesWhere (std::uint64_t bits, std::uint8_t value)
{
  const auto* bytes = reinterpret_cast<const std::uint8_t*> (&bits);
  return hn::IfThenElseZero (hn::LoadMaskBits (Bytes(), bytes),
                             hn::Set (Bytes(), value));
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#endif
