// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/filters/obstacle_class.h>
#include <pcl/segmentation/impl/disjoint_sets.h>
#include <pcl/segmentation/impl/pixel_angles.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief A bit for each point of a row of an image, 64 to a word. */
using RowBits = std::vector<std::uint64_t>;

/** \brief The points of a row that are close to the one before, and to the one above them: the
 * distance between them is at most 5 cm, or two pixels where these are wider, and three standard
 * deviations of depth. */
struct RowLinks {
  RowBits to_left, to_above;
};

/** \brief The points of a row that are of a class. */
struct ClassBits {
  RowBits unmeasured, drop_off;
  RowBits thing;    // obstacle or excluded
  RowBits excluded; // of these; empty where no point is
};

/** \brief Connected obstacle points of an image.
 *
 * Neighbours in a row or column that are both obstacle or excluded, or both drop-off, are
 * connected where they are linked. So are those along a diagonal where neither has such a
 * neighbour in the row of the other, as on thin slanted things, and next neighbours but one where
 * the pixel between them is unmeasured. Excluded points are in no cluster; where they are
 * connected with others that are fewer than a quarter as many, these are taken for their rim and
 * foot, and excluded with them. Clusters are kept as runs, the parts of a row that belong to one.
 */
class PCL_RGBD_PLANES_EXPORTS ObstacleClusters {
public:
  /** Points \a first to \a first + \a length - 1 of the image. */
  struct Run {
    std::size_t first;
    std::size_t length;
    std::uint32_t cluster; /**< or \ref none; known in the end */
  };

  static constexpr std::uint32_t none = 0xffffffffu;

  /** \brief Starts with an image.
   * \param[in] angles of the image
   * \param[in] min_points the points of smaller clusters become specks
   * \param[in] small_points smaller clusters may turn out to be no obstacles
   * \param[in] has_excluded whether any points are excluded
   */
  void
  start (const OrganizedPoints& points,
         const DepthNoise& noise,
         const PixelAngles& angles,
         std::size_t min_points,
         std::size_t small_points,
         bool has_excluded);

  /** \brief Adds the next row.
   * \param[in] classes of its points
   * \param[in] links of its points; those of the first row to the one above are not looked
   * at
   */
  void
  addRow (const OrganizedPoints& points,
          const ObstacleClass* classes,
          const RowLinks& links);

  /** \brief Tells the clusters, after the last row.
   * \param[in,out] classes one for each point
   */
  void
  finish (std::vector<ObstacleClass>& classes);

  /** \brief After the last row, makes clusters floor; the others get other numbers.
   * \param[in] are_floor whether each cluster is
   * \param[in,out] classes one for each point
   */
  void
  makeFloor (const std::vector<bool>& are_floor, std::vector<ObstacleClass>& classes);

  /** \brief Whether a run may still turn out to be of no obstacle, after a row was added. */
  bool
  isSmall (std::size_t run)
  {
    return points_[sets_.root (static_cast<std::uint32_t> (run))] < small_points_;
  }

  /** \brief Row by row, from left to right. */
  const std::vector<Run>&
  runs () const
  {
    return runs_;
  }

  /** \brief The number of points of each cluster; those that begin further up come first. */
  const std::vector<std::size_t>&
  sizes () const
  {
    return sizes_;
  }

private:
  /** A row that was added: its classes and its runs. */
  struct Row {
    ClassBits classes;
    std::size_t first = 0; // of its points
    std::size_t runs = 0, end_of_runs = 0;
  };

  void
  findRuns (const OrganizedPoints& points, const RowBits& to_left, Row& row);

  /** Joins runs of two rows where one of \a candidates, points of the one below, is connected
   * with the point of the other one that is \a aside columns further right. */
  template <typename IsConnected>
  void
  joinRows (const Row& above,
            const Row& below,
            const RowBits& candidates,
            int aside,
            const IsConnected& isConnected);

  void
  joinDiagonals (const OrganizedPoints& points, const Row& above, const Row& below);

  DepthNoise noise_;
  PixelAngles angles_;
  std::size_t min_points_ = 0, small_points_ = 0;
  bool has_excluded_ = false;
  std::size_t width_ = 0;
  Row rows_[3]; // in turn
  std::size_t number_of_rows_ = 0;
  RowBits candidates_;
  RowBits linked_; // points of a row that are connected with the one above them
  std::vector<Run> runs_;
  DisjointSets sets_; // of runs, until clusters are numbered
  /** Of the sets of runs, whose roots have so many at least until all are known. */
  std::vector<std::size_t> points_;
  std::vector<std::size_t> excluded_points_; // not among these
  std::vector<std::size_t> sizes_;
  std::vector<std::uint32_t> numbers_; // of the clusters that are no floor
};

} // namespace rgbd_planes
} // namespace pcl
