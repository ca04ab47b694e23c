// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Of some points on one plane, how many lie nearer to the sensor than another plane
 * does along their viewing ray, and how many farther away. */
struct SideCounts {
  std::size_t nearer = 0, farther = 0;
};

/** \brief What is seen on both sides of the line in which two planes intersect. */
enum class SeenPlane {
  /** It is not known, or one surface hides the other. */
  unknown,
  /** The plane that is nearer to the sensor, as in the corner of a room. */
  nearer,
  /** The one that is farther away, as at the edge of a box. */
  farther
};

/** \brief Tells which planes meet in a line from points that clearly lie on one of them.
 *
 * There, the line of intersection says where one ends and the other begins: far away, where
 * noise is as large as the distance between the planes, it does so better than depth.
 */
class PCL_RGBD_PLANES_EXPORTS PlaneIntersections {
public:
  /** \brief Forgets all planes. */
  void
  clear ();

  /** \brief Adds points on plane \a own, and where they lie relative to plane \a other. */
  void
  add (std::uint32_t own, std::uint32_t other, const SideCounts& points);

  /** \brief Looks for the planes that meet, and forgets the points; without, all is
   * unknown. */
  void
  find ();

  /** \brief What is seen of two planes, in any order. */
  SeenPlane
  between (std::uint32_t a, std::uint32_t b) const
  {
    const std::size_t pair = placeOf (std::min (a, b), std::max (a, b));
    return pair != none ? pairs_[pair].seen : SeenPlane::unknown;
  }

private:
  static constexpr auto none = std::numeric_limits<std::size_t>::max();

  /** Two planes a < b, the pair of the same a that was added before, and points on
   * either. */
  struct Pair {
    std::uint32_t a, b;
    std::size_t before;
    SideCounts of_a, of_b;
    SeenPlane seen = SeenPlane::unknown;
  };

  /** The place of a pair a < b, or \ref none. */
  std::size_t
  placeOf (std::uint32_t a, std::uint32_t b) const
  {
    std::size_t pair = a < last_of_.size() ? last_of_[a] : none;
    while (pair != none && pairs_[pair].b != b)
      pair = pairs_[pair].before;
    return pair;
  }

  std::vector<Pair> pairs_;
  /** The pair of each a that was added last. */
  std::vector<std::size_t> last_of_;
};

} // namespace rgbd_planes
} // namespace pcl
