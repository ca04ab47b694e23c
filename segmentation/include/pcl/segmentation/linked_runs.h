// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/disjoint_sets.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Points next to each other in a row of an image. */
struct PointRun {
  std::uint32_t first = 0;
  std::uint32_t length = 0;
};

inline std::size_t
pointsOf (const std::vector<PointRun>& runs)
{
  return std::accumulate (
      runs.begin(),
      runs.end(),
      std::size_t{0},
      [] (std::size_t sum, const PointRun& run) { return sum + run.length; });
}

/** \brief What runs are made of: a bit for each point of a block of a row. */
struct RunBits {
  /** Points that are of a run. */
  std::uint16_t inside = 0;
  /** Those of them that go on with the run of the point before. */
  std::uint16_t linked = 0;
  /** Points that hang together with the one above, if both are of runs. */
  std::uint16_t to_above = 0;
};

/** \brief Runs of points that hang together, and which of them hang together from row to row,
 * in far fewer steps than point by point. */
class PCL_RGBD_PLANES_EXPORTS LinkedRuns {
public:
  static constexpr std::size_t block_size = 16;

  /** \brief Forgets all runs; rows to come have so many points. */
  void
  start (std::size_t width);

  /** \brief One for each block of the row to add next. */
  std::vector<RunBits>&
  bits ()
  {
    return rows_[next_].bits;
  }

  /** \brief Adds the row of bits(), whose first point has the number \a first. */
  void
  addRow (std::uint32_t first);

  /** \brief In the order of their points. */
  const std::vector<PointRun>&
  runs () const
  {
    return runs_;
  }

  /** \brief The first of the runs that hang together with \a run. */
  std::uint32_t
  root (std::uint32_t run)
  {
    return sets_.root (run);
  }

private:
  struct Row {
    std::uint32_t
    runAt (std::size_t block, std::size_t at) const;

    std::vector<RunBits> bits;
    /** The run of each point that starts one, and of the first one of each block. */
    std::vector<std::uint32_t> run_from;
  };

  void
  findRuns (std::uint32_t first, Row& row);

  void
  join (const Row& above, const Row& row);

  std::array<Row, 2> rows_;
  std::size_t next_ = 0;
  std::vector<PointRun> runs_;
  DisjointSets sets_; // of runs
};

} // namespace rgbd_planes
} // namespace pcl
