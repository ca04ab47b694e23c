// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Of coordinates along a direction. */
struct CoordinateRange {
  float low = 0.f;
  float high = 0.f;

  float
  distanceToEnd (float x) const
  {
    return std::min (std::fabs (x - low), std::fabs (x - high));
  }
};

/** \brief The range of the values but for a few at either end, such as those of flying pixels.
 * \param[in] values at least one, and as many as there are sampled points of a thing at most
 */
CoordinateRange
trimmedRange (const std::vector<float>& values);

/** \brief Finds the rectangle on which a box stands, and keeps its buffers for the next one.
 *
 * It is the smallest one around the points, or one that is hardly larger but to whose sides the
 * points are clearly closer (X. Zhang et al., Efficient L-shape fitting for vehicle detection
 * using laser scanners, IV 2017): two sides of a thing are a triangle on the ground, around
 * which the rectangles along each of its three sides are equally large.
 */
class PCL_RGBD_PLANES_EXPORTS GroundRectangle {
public:
  /** \param[in] points on the plane, at least one
   * \param[in] hull their convex hull
   * \param[in] sigma standard deviation of depth, metres
   * \return the direction of one of its sides, a unit vector
   */
  Eigen::Vector2f
  find (const std::vector<Eigen::Vector2f>& points,
        const std::vector<Eigen::Vector2f>& hull,
        float sigma);

  /** \brief Where one of \a every points are along a direction, but for a few at either end. */
  CoordinateRange
  rangeAlong (const Eigen::Vector2f& direction,
              const std::vector<Eigen::Vector2f>& points,
              std::size_t every = 1);

private:
  struct Rectangle {
    Eigen::Vector2f along = Eigen::Vector2f::UnitX();
    float area = 0.f;
  };

  void
  findSmall (const std::vector<Eigen::Vector2f>& hull);

  float
  closenessOf (const Rectangle& rectangle,
               const std::vector<Eigen::Vector2f>& points,
               float near);

  std::vector<Rectangle> rectangles_;
  std::vector<float> coordinates_, across_;
};

} // namespace rgbd_planes
} // namespace pcl
