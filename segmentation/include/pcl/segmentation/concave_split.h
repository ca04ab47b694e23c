// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/object_clusters.h>

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

  /** \brief Calls use (point, i), where i is the place of the cell of the point in the arrays.
   * Fastest where points follow each other in rows. */
  template <typename Use>
  void
  forEachPlace (const pcl::Indices& points, const Use& use) const
  {
    std::uint32_t row_begin = 0, row_length = 0, row_place = 0;
    for (const auto index : points) {
      const auto point = static_cast<std::uint32_t> (index);
      if (point - row_begin >= row_length) { // also where it is less than row_begin
        row_begin = point / width_ * width_;
        row_length = width_;
        row_place = first_ + (point / width_ >> shift_) * stride_;
      }
      use (point, row_place + ((point - row_begin) >> shift_));
    }
  }

  /** \brief From one row to the next. */
  std::uint32_t
  stride () const
  {
    return stride_;
  }

  std::size_t
  size () const
  {
    return owner.size();
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
  std::uint32_t width_ = 0, stride_ = 0, first_ = 0, shift_ = 0;
};

/** \brief Splits clusters of touching objects along concave edges and steps.
 *
 * Objects are convex for the most part, and where two of them touch, the surface of one
 * rises above the tangent plane of the other (Stein et al., Object Partitioning using Local
 * Convexity, 2014; here on pixels instead of supervoxels). A pixel is cut when, of two points
 * on opposite sides of it, one lies above the tangent plane of the other. What the cuts leave
 * connected are patches; large ones become clusters, and all other points join the patch
 * that is nearest along the image.
 */
class PCL_RGBD_PLANES_EXPORTS ConcaveSplit {
public:
  /** \brief Splits \a clusters into parts.
   *
   * A part that lies above the top of another one, where that is among the supporting planes,
   * rests on it.
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
           const std::vector<SupportPlane>& supports,
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
  joinUncut ();

  void
  startParts (const std::vector<ObjectCluster>& clusters);

  void
  growParts ();

  void
  collect (const std::vector<ObjectCluster>& clusters);

  std::uint32_t
  partWithPlane (const pcl::Indices& inliers);

  void
  settle (const OrganizedPoints& points,
          const std::vector<SegmentedPlane>& planes,
          const std::vector<SupportPlane>& supports);

  /** \brief Calls visit (j) for the neighbours of \a i that are of the same cluster. */
  template <typename Visit>
  void
  visitNeighbours (std::uint32_t i, const Visit& visit) const;

  ObjectParameters parameters_;
  ClusterImage image_;
  std::vector<std::uint32_t> places_;    // of the cells of all clusters in turn
  std::vector<std::size_t> first_place_; // of each cluster, and the end of the last one
  std::vector<std::uint32_t> first_part_; // of each cluster
  std::vector<std::uint8_t> cut_;
  DisjointSets sets_;
  std::vector<std::uint32_t> patch_size_; // at the root of each patch
  std::vector<std::uint32_t> part_;       // of each cell, from 1 on, or 0
  std::vector<std::size_t> part_support_;
  std::vector<std::uint32_t> queue_;
  std::vector<ObjectCluster> parts_;
  std::vector<std::size_t> plane_points_; // of a plane in each part
};

} // namespace rgbd_planes
} // namespace pcl
