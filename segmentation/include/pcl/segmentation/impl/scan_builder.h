// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/impl/point_row.h>
#include <pcl/segmentation/obstacle.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief For each column of an image, the sector of a scan that its last point was in, and
 * the square of the range of its closest point in that sector. */
struct ScanColumns {
  /** Unit vectors along the borders of the sectors. */
  std::vector<float> right_x, right_y, left_x, left_y;
  std::vector<float> squares;
  /** A bit for each point at hand that is within the limits of the scan, 64 to a word. */
  std::vector<std::uint64_t> in_range;
  /** The same for those that are in another sector, and these points. */
  std::vector<std::uint64_t> strays;
  std::vector<float> x, y;
};

/** \brief Where points are in the base frame. */
struct Extent {
  /** The square of the distance of the nearest point from the z axis. */
  float nearest_square = std::numeric_limits<float>::infinity();
  float lowest = std::numeric_limits<float>::infinity();
  float highest = -std::numeric_limits<float>::infinity();
};

/** \brief Points \a begin to \a end - 1 of a row of an image. */
struct ScanRun {
  std::size_t begin, end;
  /** They count where their rays meet the floor, but for their heights. */
  bool are_below_floor;
  Extent* extent; // result
};

/** \brief Collects points into a virtual scan (Holz et al. 2011, sections 2 and 5.1).
 *
 * A point is in its own direction, and in those half way to the points beside it in its run.
 */
class PCL_RGBD_PLANES_EXPORTS ScanBuilder {
public:
  /** \brief Starts anew.
   * \param[in] columns of the image
   * \param[in,out] scan the result, which must outlive the additions; its memory is reused
   */
  void
  start (const ScanLimits& limits, std::size_t columns, VirtualScan& scan);

  /** \brief Adds points of a row of an image.
   *
   * Fastest where the points of a column have the same direction for some rows.
   * \param[in] floor where rays of points below it meet it
   */
  void
  add (const PointRow& row,
       const Eigen::Affine3f& camera_to_base,
       const Eigen::Vector4f& floor,
       const std::vector<ScanRun>& runs);

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

  /** That of points in what is left of a turn, less than an increment. */
  std::size_t
  noSector () const
  {
    return sectors_.size() - 1;
  }

  /** The direction of a point, or noSector(). */
  std::size_t
  find (float x, float y, std::size_t column) const;

  void
  turnColumn (std::size_t column, std::size_t sector);

  /** Notes whether there are directions between a column and the next one. */
  void
  noteGap (std::size_t column);

  /** Closes the gaps between points of a run that are more than a direction apart. */
  void
  closeGaps (const ScanRun& run);

  /** Gives the directions between a column and the next one what these found. */
  void
  fillBetween (std::size_t column);

  VirtualScan* scan_ = nullptr;
  ScanLimits limits_;
  /** All directions of a turn, from the first one of the scan on, so that points beyond its
   * limits are looked up as seldom as others; and noSector(), which contains nothing. */
  std::vector<Sector> sectors_;
  /** Of the closest point in each direction; that of noSector() is of no use. */
  std::vector<float> squares_;
  ScanColumns columns_;
  std::vector<std::size_t> column_sectors_;
  /** A bit for each column that noteGap() found directions after, 64 to a word. */
  std::vector<std::uint64_t> gaps_;
};

} // namespace rgbd_planes
} // namespace pcl
