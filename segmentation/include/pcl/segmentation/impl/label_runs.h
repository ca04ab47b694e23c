// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/types.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The label of points that lie on no plane. */
constexpr std::uint32_t unlabelled = std::numeric_limits<std::uint32_t>::max();

/** \brief Pixels of equal label next to each other in a row of an image. */
struct LabelRun {
  std::uint32_t label;
  /** The first pixel, counted row by row. */
  index_t begin;
  /** One past the last pixel. */
  index_t end;

  std::size_t
  size () const
  {
    return static_cast<std::size_t> (end - begin);
  }

  /** \brief Writes all pixels to \a list and moves it behind them. */
  void
  appendTo (index_t*& list) const
  {
    std::iota (list, list + size(), begin);
    list += size();
  }
};

/** \brief An image of labels as runs: what lists of pixels and connected parts are made
 * of, in far fewer steps than from pixels. */
class PCL_RGBD_PLANES_EXPORTS LabelRuns {
public:
  /** \brief Gives labels new numbers, and finds their runs.
   * \param[in,out] labels one for each pixel, row by row; \ref unlabelled has no runs
   * \param[in] width pixels of a row
   * \param[in] numbers the new number of each label, each once, or unlabelled
   */
  void
  find (std::vector<std::uint32_t>& labels,
        std::size_t width,
        const std::vector<std::uint32_t>& numbers);

  const std::vector<LabelRun>&
  runs () const
  {
    return runs_;
  }

  /** \brief The number of the first run of each row, and at last that of all runs. */
  const std::vector<std::size_t>&
  rows () const
  {
    return rows_;
  }

  /** \brief The number of pixels of each label. */
  const std::vector<std::size_t>&
  pixels () const
  {
    return pixels_;
  }

  std::size_t
  width () const
  {
    return width_;
  }

private:
  std::vector<LabelRun> runs_;
  std::vector<std::size_t> rows_;
  std::vector<std::size_t> pixels_;
  std::size_t width_ = 0;
};

} // namespace rgbd_planes
} // namespace pcl
