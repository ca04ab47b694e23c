// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <hwy/base.h>

#include <cstddef>
#include <cstdint>

namespace pcl {
namespace rgbd_planes {

/** The position of the lowest bit of a word that has one. */
inline std::size_t
lowestBit (std::uint64_t word)
{
  return hwy::Num0BitsBelowLS1Bit_Nonzero64 (word);
}

/** Calls visit (position) for each bit of a word, from the lowest on. */
template <typename Visit>
void
forEachBit (std::uint64_t word, const Visit& visit)
{
  for (; word != 0; word &= word - 1)
    visit (lowestBit (word));
}

} // namespace rgbd_planes
} // namespace pcl
