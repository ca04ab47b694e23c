// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/segmentation/impl/cluster_merging.h>
#include <pcl/segmentation/impl/plane_samples.h>
#include <pcl/segmentation/normal_space_grid.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Points with similar normals: the first stage of the segmentation (Holz et al.
 * 2011, section 4.1).
 *
 * A grid in normal space collects the points; neighbouring cells are merged while their
 * mean normals differ by no more than a threshold, best merges first.
 */
class PCL_RGBD_PLANES_EXPORTS NormalSpaceClusters {
public:
  static constexpr std::int32_t none = -1;

  /** \brief Clusters the seeds of \a samples; all others have the label \ref none.
   * \param[in] angular_threshold largest angle between the mean normals of merged
   * clusters, in radians; the cells of the grid are half as wide, at least 0.03
   * \param[in] min_cell_points cells with fewer points belong to no cluster
   */
  void
  compute (const PlaneSamples& samples,
           NormalSpaceGrid grid,
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

  /** \brief The number of points of each cluster. */
  const std::vector<std::size_t>&
  points () const
  {
    return points_;
  }

private:
  struct Cell {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    std::uint32_t points = 0;
  };

  struct Cluster {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero(),
                    mean_normal = Eigen::Vector3f::Zero();

    Cluster&
    operator+= (const Cluster& other)
    {
      sum += other.sum;
      mean_normal = sum.normalized();
      return *this;
    }
  };

  void
  layOutSphere (float cell_size);

  void
  addNeighboursOfVoxels ();

  void
  addNeighboursOnSphere ();

  /** \brief Fills the grid, \a cell_of (x, y, z) saying where a normal belongs. */
  template <typename CellOf>
  void
  fillGrid (const PlaneSamples& samples, std::size_t cells, const CellOf& cell_of);

  void
  startMerging (std::size_t min_cell_points);

  void
  addNeighbours (std::size_t cell, std::size_t other);

  void
  finishMerging (const PlaneSamples& samples, float angular_threshold);

  int cells_per_axis_ = 0;
  /** The first cell of each circle of latitude, and the end of the last one. */
  std::vector<std::size_t> latitudes_;
  std::vector<Cell> grid_;
  /** Grid index of each point, then its cluster. */
  std::vector<std::int32_t> labels_;
  /** The cluster of each cell of the grid. */
  std::vector<std::int32_t> cluster_of_cell_;
  std::vector<Cluster> cells_;
  /** The cell of the grid of each of these. */
  std::vector<std::size_t> places_;
  std::vector<std::int32_t> numbers_;
  ClusterMerging<Cluster> merging_;
  std::vector<Eigen::Vector3f> mean_normals_;
  std::vector<std::size_t> points_;
};

} // namespace rgbd_planes
} // namespace pcl
