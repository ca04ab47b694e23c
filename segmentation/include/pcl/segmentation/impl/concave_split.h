// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/impl/convex_outline.h>
#include <pcl/segmentation/impl/object_clusters.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief An image of cells of 1 x 1, 2 x 2, 4 x 4, ... pixels, with a point of a cluster in each.
 *
 * Each coordinate is in an array of its own with a margin around the image, so that loops
 * over blocks of cells fill vectors and need not look out for the border.
 */
class ClusterImage {
public:
  static constexpr std::uint32_t block_size = 16;
  static constexpr std::uint32_t margin = 5;

  /** \brief Leaves no cell with an owner. Cells are such that an image has less than 480 of them
   * in a row. */
  void
  resize (int width, int height);

  /** \brief The place in the arrays of the cell of a point. */
  std::uint32_t
  placeOf (std::uint32_t point) const
  {
    return first_ + (point / width_ >> shift_) * stride_ + (point % width_ >> shift_);
  }

  /** \brief Calls use (part, i) for the parts of a run that lie in different cells, where i is
   * the place of the cell in the arrays. */
  template <typename Use>
  void
  forEachCell (const PointRun& run, const Use& use) const
  {
    const std::uint32_t end = run.first + run.length;
    std::uint32_t place = placeOf (run.first);
    std::uint32_t next = run.first + step() - (run.first % width_ & (step() - 1));
    for (std::uint32_t point = run.first; point < end; point = next, next += step())
      use (PointRun{point, std::min (next, end) - point}, place++);
  }

  /** \brief Where the rows of the image begin, those of the margins left out. */
  std::uint32_t
  begin () const
  {
    return first_;
  }

  std::uint32_t
  end () const
  {
    return first_ + rows_ * stride_;
  }

  /** \brief From one row to the next. */
  std::uint32_t
  stride () const
  {
    return stride_;
  }

  /** \brief Pixels along the side of a cell. */
  std::uint32_t
  step () const
  {
    return 1u << shift_;
  }

  std::vector<float> x, y, z, normal_x, normal_y,
      normal_z;                     /**< where there is an owner */
  std::vector<std::uint32_t> owner; /**< the cluster of each cell, from 1 on, or 0 */

private:
  std::uint32_t width_ = 0, rows_ = 0, stride_ = 0, first_ = 0, shift_ = 0;
};

/** \brief Splits clusters of touching objects along concave edges and steps.
 *
 * Objects are convex for the most part, and where two of them touch, the surface of one
 * rises above the tangent plane of the other (Stein et al., Object Partitioning using Local
 * Convexity, 2014; here on pixels instead of supervoxels). A pixel is cut when, of two points
 * on opposite sides of it, one lies above the tangent plane of the other. What the cuts leave
 * connected are patches. Those with the points of an object, and 20 cells, become clusters, and
 * all other points join the patch that is nearest along the image.
 */
class PCL_RGBD_PLANES_EXPORTS ConcaveSplit {
public:
  /** \brief Splits \a clusters into parts.
   *
   * A part that lies above the top of another one, or of several of equal height, where that is
   * among the supporting planes, rests on it.
   * \param[in] normals one for each point; those that are NaN cut nothing
   * \param[in] pixel_angle the angle between the rays of neighbouring pixels, radians
   * \param[in] planes all planes that were found
   * \param[in] supports the horizontal ones among them, from the highest to the lowest
   */
  void
  compute (const OrganizedPoints& points,
           const OrganizedNormals& normals,
           float pixel_angle,
           const std::vector<SegmentedPlane>& planes,
           const std::vector<SupportSurface>& supports,
           const ObjectParameters& parameters,
           const std::vector<ObjectCluster>& clusters);

  /** \brief Cluster by cluster. */
  const std::vector<ObjectCluster>&
  parts () const
  {
    return parts_;
  }

private:
  void
  layOut (const OrganizedPoints& points,
          const OrganizedNormals& normals,
          const std::vector<ObjectCluster>& clusters);

  void
  findPatches (float pixel_angle);

  void
  countParts (std::size_t clusters);

  void
  startParts ();

  void
  growParts ();

  void
  collect (const std::vector<ObjectCluster>& clusters);

  bool
  isSplit (std::size_t cluster) const
  {
    return first_part_[cluster + 1] - first_part_[cluster] > 1;
  }

  std::uint32_t
  partAt (std::uint32_t i) const;

  void
  countPlanePoints (const pcl::Indices& inliers);

  void
  settle (const OrganizedPoints& points,
          const std::vector<SegmentedPlane>& planes,
          const std::vector<SupportSurface>& supports);

  /** \brief Connected cells of a cluster that are not cut. */
  struct Patch {
    std::uint32_t cells = 0;
    std::uint32_t part = 0; // if it starts one of several parts of its cluster
  };

  ObjectParameters parameters_;
  ClusterImage image_;
  LinkedRuns runs_;                       // of cells that are not cut
  std::vector<Patch> patches_;            // at their first runs
  std::vector<std::uint32_t> first_part_; // of each cluster, from 1 on, and one more
  std::vector<std::uint32_t> part_; // of each cell of clusters that are split, or 0
  std::vector<std::uint32_t> queue_;
  std::vector<ObjectCluster> parts_;
  std::vector<std::size_t> plane_points_; // of a plane in each part
  std::vector<Eigen::Vector2f> on_top_;   // its points on one of them
  ConvexOutline top_;
};

} // namespace rgbd_planes
} // namespace pcl
