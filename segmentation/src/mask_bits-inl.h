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

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** As many as there are bits in a word, or in as many vectors as fill it. */
using Bytes = hn::CappedTag<std::uint8_t, bits_in_word>;

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
