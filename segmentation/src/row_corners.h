// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/organized_view.h>
#include <pcl/types.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace pcl {
namespace rgbd_planes {

/** Whether the ray of \a p is between those of two others, nearly in one plane with them, as in
 * the rows of a pinhole camera; a laser scanner turns its rays on cones. */
inline bool
isBetween (const float* p, const float* first, const float* last)
{
  constexpr float max_sine = 0.02f;
  const auto ray = [] (const float* point) {
    return Eigen::Vector3f (point[0], point[1], point[2]).normalized();
  };
  const Eigen::Vector3f a = ray (first), b = ray (last), between = ray (p);
  const Eigen::Vector3f across = a.cross (b);
  const float cosine = a.dot (b);
  return std::fabs (across.dot (between)) <= max_sine * across.norm() &&
         a.dot (between) >= cosine && b.dot (between) >= cosine;
}

/** Calls use (p) for points between two of a row, so that the hull of all that agree is about
 * that of these. */
template <typename Iterator, typename Agrees, typename Use>
void
visitCornersBetween (const OrganizedPoints& points,
                     Iterator first,
                     Iterator last,
                     const Agrees& agrees,
                     const Use& use)
{
  const auto middle = std::find_if (first + (last - first) / 2, last, agrees);
  const auto at = [&] (Iterator i) { return points[static_cast<std::size_t> (*i)]; };
  if (middle == first || middle == last ||
      isBetween (at (middle), at (first), at (last)))
    return;
  use (at (middle));
  visitCornersBetween (points, first, middle, agrees, use);
  visitCornersBetween (points, middle, last, agrees, use);
}

/** Calls use (p) for those of the points \a inliers, in ascending order, that may be corners of
 * the hull of all for whose index agrees (index) is true: the first and the last of each row,
 * for a pinhole camera sees convex things as convex, and more where the rays of rows are in no
 * plane. */
template <typename Agrees, typename Use>
void
visitCornersOfRows (const OrganizedPoints& points,
                    const pcl::Indices& inliers,
                    const Agrees& agrees,
                    const Use& use)
{
  for (auto row = inliers.begin(); row != inliers.end();) {
    const auto longest =
        row + std::min<std::ptrdiff_t> (points.width, inliers.end() - row);
    const auto next_row = std::max (
        std::lower_bound (row, longest, (*row / points.width + 1) * points.width),
        row + 1);
    const auto first = std::find_if (row, next_row, agrees);
    if (first != next_row) {
      const auto last = std::find_if (std::make_reverse_iterator (next_row),
                                      std::make_reverse_iterator (first),
                                      agrees)
                            .base() -
                        1;
      use (points[static_cast<std::size_t> (*first)]);
      use (points[static_cast<std::size_t> (*last)]);
      visitCornersBetween (points, first, last, agrees, use);
    }
    row = next_row;
  }
}

} // namespace rgbd_planes
} // namespace pcl
