// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/filters/obstacle_class.h>
#include <pcl/segmentation/disjoint_sets.h>
#include <pcl/segmentation/point_row.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Whether the points of an image are close to the one before, and to the one above
 * it: the distance between them is at most 5 cm and three standard deviations of depth. */
class PCL_RGBD_PLANES_EXPORTS ObstacleLinks {
public:
  void
  resize (const OrganizedPoints& points);

  /** \param[in] row_above any row for v = 0 */
  void
  addRow (int v,
          const PointRow& row,
          const PointRow& row_above,
          const DepthNoise& noise);

  bool
  toLeft (std::size_t point) const
  {
    return to_left_[point] != 0;
  }

  bool
  toAbove (std::size_t point) const
  {
    return to_above_[point] != 0;
  }

private:
  std::size_t width_ = 0;
  std::vector<std::uint8_t> to_left_, to_above_;
};

/** \brief Connected obstacle points of an image.
 *
 * Neighbours in a row or column that are both obstacle, or both drop-off, are connected
 * where they are linked. So are next neighbours but one where the pixel between them is unmeasured.
 * Clusters are kept as runs, the parts of a row that belong to one.
 */
class PCL_RGBD_PLANES_EXPORTS ObstacleClusters {
public:
  /** Points \a first to \a first + \a length - 1 of the image. */
  struct Run {
    std::size_t first;
    std::size_t length;
    std::uint32_t cluster; /**< or \ref none */
  };

  static constexpr std::uint32_t none = 0xffffffffu;

  /** \brief Finds the clusters.
   * \param[in] min_points the points of smaller clusters become specks
   * \param[in,out] classes one for each point
   */
  void
  compute (const OrganizedPoints& points,
           const ObstacleLinks& links,
           const DepthNoise& noise,
           std::size_t min_points,
           std::vector<ObstacleClass>& classes);

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
  void
  findRuns (const OrganizedPoints& points,
            const ObstacleLinks& links,
            const DepthNoise& noise,
            std::size_t row,
            const std::vector<ObstacleClass>& classes);

  template <typename AreConnected>
  void
  joinRows (std::pair<std::size_t, std::size_t> above,
            std::size_t below,
            std::size_t offset,
            const std::vector<ObstacleClass>& classes,
            const AreConnected& areConnected);

  void
  numberClusters (std::size_t min_points, std::vector<ObstacleClass>& classes);

  std::vector<Run> runs_;
  DisjointSets sets_;               // of runs, until clusters are numbered
  std::vector<std::size_t> points_; // of the sets of runs
  std::vector<std::size_t> sizes_;
};

} // namespace rgbd_planes
} // namespace pcl
