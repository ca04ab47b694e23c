// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/cluster_merging.h>
#include <pcl/segmentation/point_use.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Points with similar normals: the first stage of the segmentation (Holz et al.
 * 2011, section 4.1).
 *
 * A voxel grid in normal space collects the points; neighbouring cells are merged while
 * their mean normals differ by no more than a threshold.
 */
class PCL_RGBD_PLANES_EXPORTS NormalSpaceClusters {
public:
  static constexpr std::int32_t none = -1;

  /** \brief Clusters the points that are to be.
   * \param[in] normals one for each point, of unit length
   * \param[in] use bits of \ref PointUse for each point
   * \param[in] angular_threshold largest angle between the mean normals of merged
   * clusters, in radians; the cells of the grid are half as wide, at least
   * 0.03
   * \param[in] min_cell_points cells with fewer points belong to no cluster
   */
  void
  compute (const OrganizedNormals& normals,
           const std::vector<std::uint8_t>& use,
           float angular_threshold,
           std::size_t min_cell_points);

  /** \brief The cluster of each point, or \ref none. */
  const std::vector<std::int32_t>&
  labels () const
  {
    return labels_;
  }

  /** \brief The mean normal of each cluster, of unit length. */
  const std::vector<Eigen::Vector3f>&
  meanNormals () const
  {
    return mean_normals_;
  }

private:
  struct Cell {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::size_t points = 0;

    Cell&
    operator+= (const Cell& other)
    {
      sum += other.sum;
      points += other.points;
      return *this;
    }
  };

  void
  fillGrid (const OrganizedNormals& normals,
            const std::vector<std::uint8_t>& use,
            float cell_size);

  void
  mergeCells (float angular_threshold, std::size_t min_cell_points);

  int cells_per_axis_ = 0;
  std::vector<Cell> grid_;
  /** Grid index of each point, then its cluster. */
  std::vector<std::int32_t> labels_;
  ClusterMerging<Cell> merging_;
  std::vector<Eigen::Vector3f> mean_normals_;
};

} // namespace rgbd_planes
} // namespace pcl
