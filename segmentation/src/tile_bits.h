// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/impl/plane_samples.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace pcl {
namespace rgbd_planes {

// Sets of the samples of a tile, a bit for each.

/** The samples for whose value \a is_one (value) is true: compilers make vectors of the loop,
 * and a product moves the lowest bits of eight bytes into the highest byte. */
template <typename Value, typename IsOne>
unsigned
samplesWhere (const Value* values, const IsOne& is_one)
{
  std::uint8_t ones[PlaneSamples::tile_size];
  for (std::size_t k = 0; k < PlaneSamples::tile_size; ++k)
    ones[k] = is_one (values[k]);
  std::uint64_t words[2];
  static_assert (sizeof words == sizeof ones);
  std::memcpy (words, ones, sizeof words);
  constexpr std::uint64_t to_highest_byte = 0x0102040810204080;
  return static_cast<unsigned> (words[0] * to_highest_byte >> 56 |
                                words[1] * to_highest_byte >> 56 << 8);
}

/** Their number. Not all processors have an instruction for it, and compilers call a function
 * instead. */
inline std::size_t
count (unsigned samples)
{
  const unsigned of_two = samples - (samples >> 1 & 0x5555u);
  const unsigned of_four = (of_two & 0x3333u) + (of_two >> 2 & 0x3333u);
  const unsigned of_byte = (of_four + (of_four >> 4)) & 0x0f0fu;
  return (of_byte + (of_byte >> 8)) & 0x1fu;
}

/** \a samples moved to each side; what would leave the tile is lost. */
struct MovedSamples {
  unsigned left, right, up, down;
};

inline MovedSamples
movedSamples (unsigned samples)
{
  constexpr unsigned not_last = 0x7777, not_first = 0xeeee, all = 0xffff;
  return {(samples & not_first) >> 1,
          (samples & not_last) << 1,
          samples >> PlaneSamples::tile_side,
          samples << PlaneSamples::tile_side & all};
}

/** \a samples and those beside them. */
inline unsigned
dilate (unsigned samples)
{
  samples |= movedSamples (samples).left | movedSamples (samples).right;
  return samples | movedSamples (samples).up | movedSamples (samples).down;
}

/** Of the tile to the left, and of the three above, the samples that touch others. */
struct TouchedSamples {
  unsigned left, above[3];
};

inline TouchedSamples
samplesTouchedBy (unsigned samples)
{
  constexpr unsigned first_column = 0x1111, first_row = 0xf;
  const unsigned column = dilate (samples & first_column),
                 row = dilate (samples & first_row);
  return {(column & first_column) << 3,
          {(samples & 1u) << 15, (row & first_row) << 12, (samples & 8u) << 9}};
}

} // namespace rgbd_planes
} // namespace pcl
