// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tile_parts.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "each_bit.h"
#include "sample_vectors-inl.h"

#include <pcl/segmentation/impl/tile_parts.h>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE unsigned
samplesOf (const std::int32_t* tile, std::int32_t owner)
{
  unsigned bits = 0;
  forEachVectorFrom (0, [&] (std::size_t i) {
    const auto is_own = hn::Eq (hn::LoadU (Ints(), tile + i), hn::Set (Ints(), owner));
    bits |= bitsOf (hn::RebindMask (Floats(), is_own)) << i;
  });
  return bits;
}

} // namespace

void
findTilePartsHere (const std::vector<std::int32_t>& owners,
                   std::vector<TilePart>& parts)
{
  parts.clear();
  for (std::size_t begin = 0; begin < owners.size(); begin += PlaneSamples::tile_size) {
    const std::int32_t* tile = &owners[begin];
    unsigned rest = 0xffff;
    while (rest != 0) {
      const std::size_t k = lowestBit (rest);
      const unsigned own = samplesOf (tile, tile[k]);
      rest &= ~own;
      if (tile[k] >= 0)
        parts.push_back ({static_cast<std::uint32_t> (tile[k]),
                          static_cast<std::uint32_t> (begin / PlaneSamples::tile_size),
                          own});
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

HWY_EXPORT (findTilePartsHere);

void
findTileParts (const std::vector<std::int32_t>& owners, std::vector<TilePart>& parts)
{
  HWY_DYNAMIC_DISPATCH (findTilePartsHere) (owners, parts);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
