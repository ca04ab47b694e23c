// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_source.h>
#include <pcl/apps/plane_evaluation.h>
#include <pcl/apps/plane_methods.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief A row of the table: a method at a resolution, pooled over all frames. */
struct PlaneResult {
  std::string method;
  /** "vga", "qvga" or "qqvga": every 1st, 2nd or 4th pixel. */
  std::string resolution;
  std::vector<double> milliseconds;
  PlaneEvaluation evaluation;
};

/** \brief Runs all methods on frames and scores the planes that they find. True planes
 * count from 1000 points per 640 x 480 pixels on, and methods drop smaller ones. */
class PlaneComparison {
public:
  /** \param[in] steps resolutions: every step-th pixel, of 1, 2 and 4 */
  explicit PlaneComparison (const std::vector<std::uint32_t>& steps);

  /** \brief Adds a frame of full resolution. AppError where it is too small. */
  void
  add (const Frame& frame);

  const std::vector<PlaneResult>&
  results () const
  {
    return results_;
  }

  /** \brief The table for people. */
  std::string
  table () const;

  /** \brief {"results": [{"method", "resolution", "ms_median", "planes_truth", ...}]};
   * figures that need truth are null where no frame has it. */
  std::string
  json () const;

private:
  struct Run {
    std::uint32_t step;
    PlaneMethod method;
    std::size_t points; // of the frame before
    PlaneSet found;
  };

  std::vector<Run> runs_;
  std::vector<PlaneResult> results_; // one for each run
};

} // namespace rgbd_planes
} // namespace pcl
