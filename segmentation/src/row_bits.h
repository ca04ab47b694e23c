// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "each_bit.h"

#include <pcl/segmentation/impl/obstacle_clusters.h>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace pcl {
namespace rgbd_planes {

constexpr std::size_t bits_in_word = 64;

inline std::size_t
wordsFor (std::size_t points)
{
  return (points + bits_in_word - 1) / bits_in_word;
}

/** The first point from \a point on whose bit is set; beyond the row without any. */
inline std::size_t
nextBit (const RowBits& bits, std::size_t point)
{
  std::size_t k = point / bits_in_word;
  if (k >= bits.size())
    return std::numeric_limits<std::size_t>::max();
  const std::uint64_t rest = bits[k] >> point % bits_in_word;
  if (rest != 0)
    return point + lowestBit (rest);
  while (++k < bits.size())
    if (bits[k] != 0)
      return k * bits_in_word + lowestBit (bits[k]);
  return std::numeric_limits<std::size_t>::max();
}

/** A word whose bits are those of \a bits for the points \a aside columns further right than its
 * own, or further left where that is less than 0. */
inline std::uint64_t
moved (const RowBits& bits, std::size_t k, int aside)
{
  if (aside == 0)
    return bits[k];
  if (aside < 0) {
    const std::uint64_t before = k > 0 ? bits[k - 1] : 0;
    return bits[k] << -aside | before >> (bits_in_word + aside);
  }
  const std::uint64_t after = k + 1 < bits.size() ? bits[k + 1] : 0;
  return bits[k] >> aside | after << (bits_in_word - aside);
}

} // namespace rgbd_planes
} // namespace pcl
