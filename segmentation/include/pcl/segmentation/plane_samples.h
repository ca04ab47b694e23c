// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
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
   * \param[in] maximum_curvature points with a larger curvature start no cluster; normals
   * with more than half of it are not trusted
   */
  void
  compute (const OrganizedPoints& points,
           const OrganizedNormals& normals,
           const std::vector<std::uint8_t>& selected,
           const DepthNoise& noise,
           float maximum_curvature);

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

  /** \brief Calls \a body (tile) for the tiles that touch \a tile, and for itself. */
  template <typename Body>
  void
  forEachTileAround (std::size_t tile, const Body& body) const
  {
    const int u = static_cast<int> (tile) % tiles_u,
              v = static_cast<int> (tile) / tiles_u;
    for (int row = std::max (v - 1, 0); row <= std::min (v + 1, tiles_v - 1); ++row)
      for (int column = std::max (u - 1, 0); column <= std::min (u + 1, tiles_u - 1);
           ++column)
        body (static_cast<std::uint32_t> (row * tiles_u + column));
  }

  /** \brief A measured point of \a tile; (0, 0, 0) if there is none. */
  Eigen::Vector3f
  measuredPoint (std::size_t tile) const
  {
    const float* begin = &weight[tile * tile_size];
    const float* measured =
        std::find_if (begin, begin + tile_size - 1, [] (float w) { return w > 0.f; });
    const auto i = static_cast<std::size_t> (measured - weight.data());
    return {x[i], y[i], z[i]};
  }

  /** \brief The place of column \a u, row \a v of the samples in the arrays. */
  std::size_t
  at (int u, int v) const
  {
    const int tile = v / tile_side * tiles_u + u / tile_side;
    return static_cast<std::size_t> (tile) * tile_size +
           static_cast<std::size_t> (v % tile_side * tile_side + u % tile_side);
  }

  /** Pixels between samples, samples and tiles along both axes. */
  int step = 1, width = 0, height = 0, tiles_u = 0, tiles_v = 0;

  /** (0, 0, 0) where there is no point or normal. */
  std::vector<float> x, y, z, normal_x, normal_y, normal_z;
  /** Standard deviation of depth, and relative to the range; -1 where there is no
   * measurement or a plane took it. */
  std::vector<float> sigma, relative_sigma;
  /** Inverse of the squared relative standard deviation. */
  std::vector<float> weight;
  /** The least cosine between the normals of the point and of its plane; -1 where the
   * normal is not trusted. */
  std::vector<float> min_cosine;
  /** Not 0 where the point may start a cluster. */
  std::vector<std::uint8_t> is_seed;

  struct Neighbours {
    std::uint32_t left, above_left, above, above_right;
  };
  /** For each sample those beside it, or itself where the image ends. */
  std::vector<Neighbours> neighbours;

  bool
  isFree (std::size_t i) const
  {
    return sigma[i] >= 0.f;
  }

  /** \brief The samples that start clusters, of those that are free. */
  void
  findClustered (std::vector<std::uint32_t>& clustered) const;

private:
  void
  resize (int image_width, int image_height);

  void
  findNeighbours ();

  template <typename IsUsable>
  std::size_t
  findPixel (const OrganizedPoints& points,
             int u,
             int v,
             const IsUsable& isUsable) const;
};

} // namespace rgbd_planes
} // namespace pcl
