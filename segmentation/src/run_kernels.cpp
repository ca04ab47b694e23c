// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "run_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "plane_vectors-inl.h"
#include "run_kernels.h"

#include <utility>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

using Bytes = hn::CappedTag<std::uint8_t, LinkedRuns::block_size>;

/** The bits of a block, those for which is_one (i) is true of the bytes from i on. */
template <typename IsOne>
HWY_INLINE unsigned
bitsWhere (std::size_t block, const IsOne& is_one)
{
  unsigned bits = 0;
  for (std::size_t k = 0; k < LinkedRuns::block_size; k += hn::Lanes (Bytes()))
    bits |= static_cast<unsigned> (
                bitsOf (Bytes(), is_one (block * LinkedRuns::block_size + k)))
            << k;
  return bits;
}

} // namespace

void
findRunBitsHere (const std::uint8_t* places,
                 const std::uint8_t* places_above,
                 std::uint8_t outside,
                 const std::uint8_t* to_left,
                 const std::uint8_t* to_above,
                 const std::uint8_t* blocks,
                 std::vector<RunBits>& bits)
{
  const auto load = [] (const std::uint8_t* from)
                        HWY_ATTR { return hn::LoadU (Bytes(), from); };
  const auto isSet = [&] (const std::uint8_t* from)
                         HWY_ATTR { return hn::Ne (load (from), hn::Zero (Bytes())); };
  unsigned is_last_like_next = 0;
  for (std::size_t block = 0; block < bits.size(); ++block) {
    bits[block] = {};
    const unsigned is_first_like_last = std::exchange (is_last_like_next, 0);
    if (!blocks[block])
      continue;
    const unsigned inside = bitsWhere (block, [&] (std::size_t i) HWY_ATTR {
      return hn::Gt (load (places + i), hn::Set (Bytes(), outside));
    });
    const unsigned like_next = bitsWhere (block, [&] (std::size_t i) HWY_ATTR {
      return hn::Eq (load (places + i), load (places + i + 1));
    });
    const unsigned left =
        bitsWhere (block, [&] (std::size_t i) HWY_ATTR { return isSet (to_left + i); });
    const unsigned above = bitsWhere (block, [&] (std::size_t i) HWY_ATTR {
      return hn::And (isSet (to_above + i),
                      hn::Eq (load (places + i), load (places_above + i)));
    });
    const unsigned like_before = like_next << 1 | is_first_like_last;
    bits[block] = {static_cast<std::uint16_t> (inside),
                   static_cast<std::uint16_t> (inside & like_before & left),
                   static_cast<std::uint16_t> (above)};
    is_last_like_next = like_next >> (LinkedRuns::block_size - 1);
  }
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (findRunBitsHere);

void
findRunBits (const std::uint8_t* places,
             const std::uint8_t* places_above,
             std::uint8_t outside,
             const std::uint8_t* to_left,
             const std::uint8_t* to_above,
             const std::uint8_t* blocks,
             std::vector<RunBits>& bits)
{
  HWY_DYNAMIC_DISPATCH (findRunBitsHere)
  (places, places_above, outside, to_left, to_above, blocks, bits);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
