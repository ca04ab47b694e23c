// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Integral images of the tangents of an organized cloud (Holz et al. 2011,
 * section 3).
 *
 * Each pixel has two tangents, from its left to its right neighbour and from its upper
 * to its lower one; the pixel itself stands in for a neighbour that is missing or lies
 * on another surface. Tangents are divided by the range of the pixel, which makes them
 * independent of the unit, and summed as fixed-point numbers: integral images of
 * integers are exact, for sums wrap around and differences of them do not. Only the
 * rows that the current windows need are kept.
 */
class PCL_RGBD_PLANES_EXPORTS TangentIntegralImages {
public:
  /** \brief Sums of x, y, z and number of the horizontal tangents, then of the vertical
   * ones. */
  using Sums = std::array<std::uint32_t, 8>;

  /** \brief Starts a frame; \a points must outlive it.
   * \param[in] viewpoint where the sensor is, in the frame of the points
   * \param[in] max_depth_change_factor neighbours whose ranges differ by more than
   * 2 * factor * (range + 1 m) lie on different surfaces
   * \param[in] max_half_u, max_half_v half-sizes of the largest window; windows are
   * 2 * half + 1 pixels wide and high
   */
  void
  start (const OrganizedPoints& points,
         const std::array<float, 3>& viewpoint,
         float max_depth_change_factor,
         int max_half_u,
         int max_half_v);

  /** \brief Makes the windows around the pixels of row \a v available, and those above
   * no longer. Rows must be asked for one after the other. */
  void
  advance (int v);

  /** \brief The sums over all rows above row \a v, and over the columns left of the
   * index; width + 1 of them. */
  const Sums*
  above (int v) const
  {
    return row_pointers_[static_cast<std::size_t> (v)];
  }

private:
  struct RangedPoint {
    std::array<float, 3> p;
    float range; // 0: missing
    float gate;  // of ranges of neighbours on the same surface
    float scale; // of tangents to fixed-point numbers
  };

  void
  loadRow (int v, std::vector<RangedPoint>& row) const;

  void
  addTangent (const RangedPoint& before,
              const RangedPoint& at,
              const RangedPoint& after,
              std::uint32_t* sums) const;

  void
  appendRow (int v);

  OrganizedPoints points_;
  std::array<float, 3> viewpoint_{};
  float max_depth_change_factor_ = 0.f;
  int max_half_v_ = 0;
  float fixed_point_scale_ = 0.f;
  int appended_ = 0;
  /** The integral rows in use, in a ring, and where each row lies or lay. */
  std::vector<Sums> ring_;
  std::vector<Sums*> row_pointers_;
  /** The row before the next one to append, that one, and the one after it. */
  std::array<std::vector<RangedPoint>, 3> rows_;
};

} // namespace rgbd_planes
} // namespace pcl
