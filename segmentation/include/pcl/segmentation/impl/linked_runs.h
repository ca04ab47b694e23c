// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/impl/disjoint_sets.h>

#include <algorithm>
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

  /** \brief From now on, these hang together. */
  void
  join (std::uint32_t run, std::uint32_t other)
  {
    sets_.join (run, other);
  }

  /** \brief Joins runs of rows of \a width points, all of which were added, where a gap of one
   * pixel in a row or a column keeps them apart and is_gap (before, after) is true of the points
   * at both sides of it. */
  template <typename IsGap>
  void
  bridge (std::uint32_t width, const IsGap& is_gap)
  {
    for (std::uint32_t k = 1; k < runs_.size(); ++k) {
      const std::uint32_t first = runs_[k].first;
      if (first == endOf (k - 1) + 1 && first % width >= 2 && is_gap (first - 2, first))
        sets_.join (k - 1, k);
    }
    std::uint32_t above = 0;
    for (std::uint32_t k = 0; k < runs_.size(); ++k) {
      const PointRun& run = runs_[k];
      while (endOf (above) + 2 * width <= run.first)
        ++above;
      for (std::uint32_t j = above; runs_[j].first + 2 * width < endOf (k); ++j)
        bridgeRows (j, k, 2 * width, is_gap);
    }
  }

private:
  struct Row {
    std::uint32_t
    runAt (std::size_t block, std::size_t at) const;

    std::vector<RunBits> bits;
    /** The run of each point that starts one, and of the first one of each block. */
    std::vector<std::uint32_t> run_from;
  };

  std::uint32_t
  endOf (std::uint32_t run) const
  {
    return runs_[run].first + runs_[run].length;
  }

  /** Where \a below has points \a step after those of \a above. */
  template <typename IsGap>
  void
  bridgeRows (std::uint32_t above,
              std::uint32_t below,
              std::uint32_t step,
              const IsGap& is_gap)
  {
    if (sets_.root (above) == sets_.root (below))
      return;
    const std::uint32_t end = std::min (endOf (above) + step, endOf (below));
    for (auto i = std::max (runs_[above].first + step, runs_[below].first); i < end;
         ++i)
      if (is_gap (i - step, i))
        return sets_.join (above, below);
  }

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
