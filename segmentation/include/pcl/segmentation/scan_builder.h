// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/obstacle.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Collects points into a virtual scan (Holz et al. 2011, sections 2 and 5.1). */
class PCL_RGBD_PLANES_EXPORTS ScanBuilder {
public:
  /** \brief Starts anew.
   * \param[in,out] scan the result, which must outlive the additions; its memory is reused
   */
  void
  start (const ScanLimits& limits, VirtualScan& scan);

  /** \brief Adds points in the base frame, metres. Fastest where points follow each other
   * in direction. */
  void
  add (const float* x, const float* y, const float* z, std::size_t count);

  /** \brief Fills in the ranges. */
  void
  finish ();

private:
  /** The part of the plane that a direction stands for, between two unit vectors. */
  struct Sector {
    float right_x = 0.f, right_y = 0.f, left_x = 0.f, left_y = 0.f;

    bool
    contains (float x, float y) const
    {
      return right_x * y >= right_y * x && left_x * y < left_y * x;
    }
  };

  /** The direction of a point, or sectors_.size() - 1 where it is outside of all. */
  std::size_t
  find (float x, float y, std::size_t guess) const;

  VirtualScan* scan_ = nullptr;
  ScanLimits limits_;
  float squared_min_ = 0.f;
  float squared_max_ = 0.f;
  /** One for each direction, and one that contains nothing. */
  std::vector<Sector> sectors_;
  /** Of the closest point in each direction; the last one is of no use. */
  std::vector<float> squares_;
};

} // namespace rgbd_planes
} // namespace pcl
