// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <hwy/base.h>

#include <pcl/segmentation/linked_runs.h>

#include <algorithm>

namespace pcl {
namespace rgbd_planes {

namespace {

std::uint32_t
lowestBit (unsigned bits)
{
  return static_cast<std::uint32_t> (hwy::Num0BitsBelowLS1Bit_Nonzero32 (bits));
}

} // namespace

void
LinkedRuns::start (std::size_t width)
{
  const std::size_t blocks = (width + block_size - 1) / block_size;
  for (Row& row : rows_) {
    row.bits.assign (blocks, {});
    row.run_at.resize (blocks * block_size);
  }
  runs_.clear();
}

void
LinkedRuns::addRow (std::uint32_t first)
{
  auto run = static_cast<std::uint32_t> (runs_.size());
  findRuns (first, rows_[next_]);
  sets_.resize (runs_.size());
  for (; run < runs_.size(); ++run)
    sets_.add (run);
  join (rows_[1 - next_], rows_[next_]);
  next_ = 1 - next_;
}

void
LinkedRuns::findRuns (std::uint32_t first, Row& row)
{
  for (std::size_t block = 0; block < row.bits.size(); ++block) {
    const unsigned linked = row.bits[block].linked;
    const std::size_t begin = block * block_size;
    for (unsigned rest = row.bits[block].inside; rest != 0;) {
      const std::uint32_t at = lowestBit (rest);
      const std::uint32_t end = at + 1 + lowestBit (~(linked >> (at + 1)));
      if (!(linked >> at & 1u))
        runs_.push_back ({first + static_cast<std::uint32_t> (begin) + at, 0});
      runs_.back().length += end - at;
      std::fill (&row.run_at[begin + at],
                 row.run_at.data() + begin + end,
                 static_cast<std::uint32_t> (runs_.size() - 1));
      rest &= ~0u << end;
    }
  }
}

void
LinkedRuns::join (const Row& above, const Row& row)
{
  for (std::size_t block = 0; block < row.bits.size(); ++block) {
    const RunBits &bits = row.bits[block], &bits_above = above.bits[block];
    const unsigned joined = bits.to_above & bits.inside & bits_above.inside;
    // Points that go on with the same two runs as those before join nothing new.
    unsigned joins = joined & ~(joined << 1 & bits.linked & bits_above.linked);
    for (; joins != 0; joins &= joins - 1) {
      const std::size_t at = block * block_size + lowestBit (joins);
      sets_.join (above.run_at[at], row.run_at[at]);
    }
  }
}

} // namespace rgbd_planes
} // namespace pcl
