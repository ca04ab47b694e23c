// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "each_bit.h"

#include <pcl/segmentation/impl/linked_runs.h>

namespace pcl {
namespace rgbd_planes {

namespace {

std::size_t
highestBit (unsigned bits)
{
  return 31 - hwy::Num0BitsAboveMS1Bit_Nonzero32 (bits);
}

} // namespace

void
LinkedRuns::start (std::size_t width)
{
  const std::size_t blocks = (width + block_size - 1) / block_size;
  for (Row& row : rows_) {
    row.bits.assign (blocks, {});
    row.run_from.resize (blocks * block_size);
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
  std::size_t open = runs_.size();
  for (std::size_t block = 0; block < row.bits.size(); ++block, first += block_size) {
    const RunBits& bits = row.bits[block];
    if (bits.inside == 0)
      continue;
    const unsigned linked_after =
        block + 1 < row.bits.size() ? row.bits[block + 1].linked : 0;
    const unsigned linked_to = (bits.linked | linked_after << block_size) >> 1;
    std::uint32_t* run_from = &row.run_from[block * block_size];
    *run_from = static_cast<std::uint32_t> (runs_.size() - 1);
    forEachBit (bits.inside & ~unsigned{bits.linked}, [&] (std::size_t at) {
      run_from[at] = static_cast<std::uint32_t> (runs_.size());
      runs_.push_back ({first + static_cast<std::uint32_t> (at), 0});
    });
    forEachBit (bits.inside & ~linked_to, [&] (std::size_t at) {
      runs_[open].length =
          first + static_cast<std::uint32_t> (at) + 1 - runs_[open].first;
      ++open;
    });
  }
}

std::uint32_t
LinkedRuns::Row::runAt (std::size_t block, std::size_t at) const
{
  const unsigned starts = (bits[block].inside & ~unsigned{bits[block].linked}) | 1u;
  return run_from[block * block_size + highestBit (starts & ((2u << at) - 1u))];
}

void
LinkedRuns::join (const Row& above, const Row& row)
{
  unsigned is_last_joined = 0;
  for (std::size_t block = 0; block < row.bits.size(); ++block) {
    const RunBits &bits = row.bits[block], &bits_above = above.bits[block];
    const unsigned joined = bits.to_above & bits.inside & bits_above.inside;
    // Points that go on with the same two runs as those before join nothing new.
    const unsigned joined_before = joined << 1 | is_last_joined;
    forEachBit (joined & ~(joined_before & bits.linked & bits_above.linked),
                [&] (std::size_t at) {
                  sets_.join (above.runAt (block, at), row.runAt (block, at));
                });
    is_last_joined = joined >> (block_size - 1);
  }
}

} // namespace rgbd_planes
} // namespace pcl
