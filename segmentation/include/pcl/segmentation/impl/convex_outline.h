// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The convex hull of points of a plane (Andrew's monotone chain, 1979) in O(n log n).
 * \param[in,out] points any order, repeated ones are fine; comes back sorted, without
 * most of those inside
 * \param[out] corners counterclockwise; fewer than 3 where the points lie on a line
 */
PCL_RGBD_PLANES_EXPORTS void
convexHull (std::vector<Eigen::Vector2f>& points,
            std::vector<Eigen::Vector2f>& corners);

/** \brief The convex hull of points of a plane, and which points lie within it or near
 * it. */
class PCL_RGBD_PLANES_EXPORTS ConvexOutline {
public:
  /** \brief Computes the hull.
   * \param[in,out] points as for convexHull()
   * \param[in] tolerance points so far outside count as inside; 0 or more
   */
  void
  compute (std::vector<Eigen::Vector2f>& points, float tolerance);

  /** \brief The corners of the hull, without the tolerance, counterclockwise; fewer than 3
   * where the points lie on a line. */
  const std::vector<Eigen::Vector2f>&
  corners () const
  {
    return corners_;
  }

  /** \brief The smallest rectangle along the axes that holds the hull and the tolerance; empty
   * without points. */
  const Eigen::AlignedBox2f&
  bounds () const
  {
    return bounds_;
  }

  /** \brief A line with a side: (x, y) is inside where a x + b y + c > 0. */
  struct Side {
    float a, b, c;
  };

  /** \brief The sides of an octagon inside: it holds most of what contains() holds, and
   * nothing else. Without a tolerance, it may hold nothing. */
  const std::array<Side, 8>&
  innerSides () const
  {
    return inner_sides_;
  }

  /** \brief Whether \a point lies in the hull or at most the tolerance outside; the
   * tolerance may fall short by 2 % at corners. */
  bool
  contains (const Eigen::Vector2f& point) const;

  /** \brief How far inside of the hull \a point lies, or negative if outside; linear in the
   * number of corners. The tolerance does not count. */
  float
  depthOf (const Eigen::Vector2f& point) const;

private:
  /** \brief A border from left to right, in steps of equal width. */
  struct Chain {
    struct Step {
      std::size_t edge = 0;        /**< that holds the left end */
      float low = 0.f, high = 0.f; /**< of the border */
    };

    void
    index (float left, float steps_per_unit);

    float
    at (float x, std::size_t edge) const;

    std::vector<Eigen::Vector2f> points;
    std::vector<Step> steps;
  };

  std::vector<Eigen::Vector2f> corners_;
  std::vector<Eigen::Vector2f> grown_;
  Chain lower_, upper_;
  Eigen::AlignedBox2f bounds_;
  float steps_per_unit_ = 0.f;
  std::array<Side, 8> inner_sides_{};
};

} // namespace rgbd_planes
} // namespace pcl
