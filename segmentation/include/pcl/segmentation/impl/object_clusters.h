// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/impl/linked_runs.h>
#include <pcl/segmentation/impl/pixel_lines.h>
#include <pcl/segmentation/impl/point_row.h>
#include <pcl/segmentation/impl/support_planes.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace rgbd_planes {

struct LinkLimit;

/** \brief Points that may be of one object. */
struct ObjectCluster {
  std::vector<PointRun> runs; /**< in ascending order */
  std::size_t support = 0;    /**< the plane under them, among the supporting ones */
  /** How high above that they begin, of what rests on another thing. */
  float bottom = 0.f;
  bool is_part = false; /**< of something that is no object */
};

/** \brief Collects the points above supporting planes and clusters them along the image,
 * linear in their number (Holz et al. 2011, section 5.1).
 *
 * Planes on objects support nothing here. Things may reach beyond the hull, for they hide a
 * corner of the plane where they stand on it. Those that hang together with what lies further
 * outside, lower, or too high are no objects, nor is what goes on above most of its top, such as
 * the legs of a table, has its top hidden behind something nearer, or stands where the plane
 * ends and has its top cut by the image, such as a wall, nor what is low and passes into its
 * plane without a step, such as a bump that noise makes. Things may touch a plane of the
 * background, such as a wall, if they stand out from it.
 */
class PCL_RGBD_PLANES_EXPORTS ObjectClusters {
public:
  /** \param[in] selected not 0 for the points to look at; empty for all of them
   * \param[in] supports of the same points
   */
  void
  compute (const OrganizedPoints& points,
           const std::vector<std::uint8_t>& selected,
           const SupportPlanes& supports,
           const ObjectParameters& parameters);

  /** \brief In the order of their first points. */
  const std::vector<ObjectCluster>&
  clusters () const
  {
    return clusters_;
  }

  /** \brief The angle between the rays of neighbouring pixels, in radians. */
  float
  pixelAngle () const
  {
    return pixel_angle_;
  }

  /** \brief Whether the image ends where a thing may go on. */
  bool
  isTruncated (const std::vector<PointRun>& runs) const;

  /** \brief From pixel \a i to the one beside it whose ray points highest. */
  std::ptrdiff_t
  stepUpwards (std::uint32_t i) const
  {
    return rgbd_planes::stepUpwards (points_, bases_.back()->plane.normal, i);
  }

private:
  /** \brief Where a point is: from \ref above on, above that one of the bases, over its hull or
   * its surroundings. */
  enum Place : std::uint8_t { nowhere, outside, above };

  /** \brief What decides whether a cluster is an object, in points. */
  struct Sums {
    std::size_t points = 0;
    /** The columns and rows in which they lie. */
    Eigen::AlignedBox2i pixels;
    /** Those that are higher than noise, until they are enough. */
    std::size_t clear = 0;
    /** Those that are too high for a bump of the plane, until they are enough; counted, as all
     * that follows, of what is large and clear. */
    std::size_t high = 0;
    /** Those over the hull. */
    std::size_t over_hull = 0;
    /** Those that hang together with one outside. */
    std::size_t leaks = 0;
    /** Those that hang together with one of a plane behind; where there are any, */
    std::size_t at_background = 0;
    /** those that are on no such plane for certain, nor on the supporting one. */
    std::size_t off_background = 0;
    /** Those with nothing above them in the image that is above the same plane, nor on the
     * same surface beside that: what leans has sides. */
    std::size_t tops = 0;
    /** Of these, those that end at something nearer, or do not end there. */
    std::size_t going_on = 0;
    /** Those above which the plane goes on without a step. */
    std::size_t passing = 0;
    /** Those at the border of the image. */
    std::size_t at_border = 0;
    /** Those above which the image ends. If these are most tops, */
    std::size_t cut_tops = 0;
    /** those clearly inside of the hull. */
    std::size_t well_inside = 0;
    std::size_t support = 0;
    std::size_t cluster = 0;
  };

  void
  markBackground ();

  LinkLimit
  linkLimit () const;

  void
  findRuns (const std::vector<std::uint8_t>& selected);

  void
  bridgeGaps (const LinkLimit& limit);

  void
  joinAcrossBases (const LinkLimit& limit);

  void
  findMeetings (const LinkLimit& limit);

  void
  runsOf (std::uint32_t root, std::vector<PointRun>& thing);

  void
  moveTo (const std::vector<PointRun>& thing, std::uint8_t place);

  bool
  isOver (const std::vector<PointRun>& thing, const SupportSurface& base) const;

  bool
  standsBeside (const std::vector<PointRun>& on_higher,
                const std::vector<PointRun>& on_lower,
                const SupportSurface& higher,
                const SupportSurface& lower) const;

  void
  settleRow (std::uint32_t first, const std::vector<std::uint8_t>& selected);

  Place
  settle (std::uint32_t i, std::size_t base) const;

  Place
  settleBeside (std::uint32_t i) const;

  /** \brief Over the plane as the camera bends it. */
  float
  heightAbove (const SupportSurface& support, std::uint32_t v, std::uint32_t u) const
  {
    return support.plane.distance (points_[v * width_ + u]) -
           support.warp.row (static_cast<int> (v))[u / PointRow::block_size];
  }

  float
  heightAbove (const SupportSurface& support, std::uint32_t i) const
  {
    return heightAbove (support, i / width_, i % width_);
  }

  void
  sumUp ();

  void
  findSets ();

  std::size_t
  pointsBeyond (float sigmas, const PointRun& run, const SupportSurface& support) const;

  std::size_t
  pointsOffBackground (const PointRun& run, const SupportSurface& support) const;

  std::size_t
  pointsOverHull (const PointRun& run, const SupportSurface& support) const;

  std::size_t
  pointsWellInside (const PointRun& run, const SupportSurface& support) const;

  std::size_t
  pointsAtBorder (const PointRun& run, std::ptrdiff_t step) const;

  std::size_t
  pointsAtBorder (const PointRun& run) const;

  static bool
  isHigh (const Sums& sums);

  static bool
  isBump (const Sums& sums);

  static bool
  isCutAbove (const Sums& sums);

  static bool
  isTruncated (std::size_t at_border);

  /** \brief Calls visit (i) for the points of a run at its ends, and those in another place
   * than the point above or below in the image. */
  template <typename Visit>
  void
  visitMargin (const PointRun& run, const Visit& visit) const;

  void
  lookAtMargin (const PointRun& run,
                std::ptrdiff_t up,
                const LinkLimit& limit,
                Sums& sums) const;

  void
  countLeak (std::uint32_t i,
             const PointRun& run,
             const LinkLimit& limit,
             Sums& sums) const;

  void
  countTop (std::uint32_t i,
            std::ptrdiff_t up,
            const LinkLimit& limit,
            Sums& sums) const;

  bool
  hasNoStep (std::uint32_t i, std::uint32_t k, const SupportSurface& support) const;

  bool
  isLarge (const Sums& sums) const;

  bool
  isClear (const Sums& sums) const;

  bool
  isObject (const Sums& sums) const;

  void
  collect ();

  OrganizedPoints points_;
  std::uint32_t width_ = 0; // of the image
  const SupportPlanes* supports_ = nullptr;
  ObjectParameters parameters_;
  float pixel_angle_ = 0.f;
  std::vector<const SupportSurface*> bases_; // those that are not on an object
  std::vector<std::uint8_t> is_background_;
  PointRow rows_[2];
  std::vector<std::uint8_t> has_above_; // of the blocks of a row
  std::vector<std::uint8_t> to_left_,
      to_above_; // of its points: whether they are close
  std::vector<std::uint8_t> place_;
  LinkedRuns runs_;
  /** Two runs each that hang together but for their bases. */
  std::vector<std::pair<std::uint32_t, std::uint32_t>> meetings_;
  std::vector<PointRun> on_higher_, on_lower_; // of a meeting
  std::vector<std::uint32_t> set_of_run_;
  std::vector<Sums> sums_; // of sets
  std::vector<ObjectCluster> clusters_;
};

} // namespace rgbd_planes
} // namespace pcl
