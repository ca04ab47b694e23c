// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Finds the points of an organized cloud within a radius of any place.
 *
 * The image is cut into tiles of 4 x 4 pixels. A pyramid of boxes bounds the points of
 * each tile, of each 2 x 2 tiles, and so on up to the whole image; what the ball does
 * not reach is skipped. Nothing is assumed about the camera: the cloud need not be
 * projective.
 *
 * The points found are exactly those of pcl::KdTreeFLANN::radiusSearch: squared
 * distances are computed in float and must be smaller than the squared radius. Rounding
 * is monotonic, so no box is further than a point in it.
 */
class PCL_RGBD_PLANES_EXPORTS OrganizedBallSearch {
public:
  /** \brief Copies the measured points (isMeasured); the others are never found. */
  void
  setPoints (const OrganizedPoints& points);

  /** \brief Finds the points closer than \a radius to \a centre.
   * \param[in] centre x, y and z, finite
   * \param[in] radius more than 0, in the unit of the points
   * \param[out] found their indices, in no particular order
   */
  void
  search (const float* centre, float radius, std::vector<int>& found) const;

private:
  static constexpr int tile_size = 4;
  static constexpr std::size_t tile_points = tile_size * tile_size;

  struct Tile {
    std::array<std::array<float, tile_points>, 3> xyz;
  };

  struct Box {
    std::array<float, 3> low;
    std::array<float, 3> high;
  };

  /** An image of boxes; one box of level i + 1 bounds 2 x 2 boxes of level i. */
  struct Level {
    int width;
    int height;
    std::vector<Box> boxes;

    const Box&
    at (int u, int v) const
    {
      return boxes[static_cast<std::size_t> (v) * width + u];
    }
  };

  struct Ball {
    std::array<float, 3> centre;
    float squared_radius;
  };

  Tile
  loadTile (const OrganizedPoints& points, int tile_u, int tile_v) const;

  static Box
  bound (const Tile& tile);

  static Level
  halve (const Level& level);

  static bool
  reaches (const Ball& ball, const Box& box);

  void
  visit (
      std::size_t level, int u, int v, const Ball& ball, std::vector<int>& found) const;

  void
  scanTile (int tile_u, int tile_v, const Ball& ball, std::vector<int>& found) const;

  int width_ = 0;
  std::vector<Tile> tiles_;
  /** From the boxes of the tiles to the one box of the image. */
  std::vector<Level> levels_;
};

} // namespace rgbd_planes
} // namespace pcl
