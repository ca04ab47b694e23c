// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief A point with its normal from each step x step pixels of an image, in tiles of
 * 4 x 4 points: what planes are found on.
 *
 * Normals are averages over windows that are wider than a step, and so is the noise of
 * depth: the points between add nothing. Points lie tile after tile, row by row in a
 * tile, and each coordinate in an array of its own, so that the points of a tile fill
 * vectors. Tiles at the borders are filled up with points that are not measured.
 */
class PCL_RGBD_PLANES_EXPORTS PlaneSamples {
public:
  /** \brief Points along the side of a tile. */
  static constexpr int tile_side = 4;
  static constexpr std::size_t tile_size = 16;

  /** \brief Reads the points.
   * \param[in] points in a frame whose origin is the sensor
   * \param[in] normals one for each point
   * \param[in] selected not 0 for the points to look at; empty for all
   * \param[in] noise standard deviation of depth; points beyond its range are left out
   * \param[in] max_curvature points with a larger curvature start no cluster; normals
   * with more than half of it are not trusted
   */
  void
  compute (const OrganizedPoints& points,
           const OrganizedNormals& normals,
           const std::vector<std::uint8_t>& selected,
           const DepthNoise& noise,
           float max_curvature);

  /** \brief The number of points, with those that fill up tiles. */
  std::size_t
  size () const
  {
    return x.size();
  }

  std::size_t
  tiles () const
  {
    return size() / tile_size;
  }

  /** \brief Calls \a body (first, end) for each row of the tiles that touch \a tile, and
   * itself. */
  template <typename Body>
  void
  forEachRowAround (std::size_t tile, const Body& body) const
  {
    const auto [left, right, above, below] = around_[tile];
    const auto columns = static_cast<std::uint32_t> (tiles_u);
    const auto centre = static_cast<std::uint32_t> (tile);
    for (std::uint32_t row = centre - above * columns; row <= centre + below * columns;
         row += columns)
      body (row - left, row + right + 1);
  }

  /** \brief Calls \a body (tile) for all these tiles. */
  template <typename Body>
  void
  forEachTileAround (std::size_t tile, const Body& body) const
  {
    forEachRowAround (tile, [&body] (std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t other = first; other < end; ++other)
        body (other);
    });
  }

  /** \brief The nearest measured point of \a tile; (0, 0, 0) if there is none. */
  const Eigen::Vector3f&
  nearestPoint (std::size_t tile) const
  {
    return nearest_points_[tile];
  }

  /** \brief The place of column \a u, row \a v of the samples in the arrays. */
  std::size_t
  at (int u, int v) const
  {
    // Unsigned, divisions are shifts.
    constexpr auto side = static_cast<std::size_t> (tile_side);
    const auto column = static_cast<std::size_t> (u),
               row = static_cast<std::size_t> (v);
    const std::size_t tile =
        row / side * static_cast<std::size_t> (tiles_u) + column / side;
    return tile * tile_size + row % side * side + column % side;
  }

  /** \brief The column and row of the sample that is at a place in the arrays. */
  std::pair<int, int>
  placeOf (std::size_t i) const
  {
    const int tile = static_cast<int> (i / tile_size);
    const int in_tile = static_cast<int> (i % tile_size);
    return {tile % tiles_u * tile_side + in_tile % tile_side,
            tile / tiles_u * tile_side + in_tile / tile_side};
  }

  /** Pixels between samples, samples and tiles along both axes. */
  int step = 1, width = 0, height = 0, tiles_u = 0, tiles_v = 0;

  /** (0, 0, 0) where there is no point or normal; normals are towards the sensor. */
  std::vector<float> x, y, z, normal_x, normal_y, normal_z;
  /** That of the normals; anything where there is none. */
  std::vector<float> curvature;
  /** Standard deviation of depth, and relative to the range; -1 where there is no
   * measurement or a plane took it. */
  std::vector<float> sigma, relative_sigma;
  /** Inverse of the squared relative standard deviation. */
  std::vector<float> weight;
  /** The least cosine between the normals of the point and of its plane; -1 where the
   * normal is not trusted. */
  std::vector<float> min_cosine;
  /** The points that may start a cluster. */
  std::vector<std::uint32_t> seeds;

  bool
  isFree (std::size_t i) const
  {
    return sigma[i] >= 0.f;
  }

  /** \brief Points that planes took start no clusters any more. */
  void
  dropTakenSeeds ();

private:
  void
  resize (int image_width, int image_height);

  void
  findTilesAround ();

  template <typename IsUsable>
  std::size_t
  findPixel (const OrganizedPoints& points,
             int u,
             int v,
             const IsUsable& isUsable) const;

  void
  copyPixel (const OrganizedPoints& points,
             const OrganizedNormals& normals,
             std::size_t pixel,
             std::size_t i);

  void
  findNearestPoints ();

  /** Tiles beside a tile in each direction: 1, or 0 where the image ends. */
  struct Around {
    std::uint8_t left, right, above, below;
  };

  /** Column and row of a sample, and whether its middle pixel has a usable point. */
  struct Place {
    int u, v;
    bool has_point;
  };

  std::vector<Around> around_;
  std::vector<Eigen::Vector3f> nearest_points_;
  /** Samples whose middle pixel has no usable point, or no normal. */
  std::vector<Place> missing_;
};

} // namespace rgbd_planes
} // namespace pcl
