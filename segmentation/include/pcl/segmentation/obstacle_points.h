// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/filters/obstacle_class.h>
#include <pcl/segmentation/floor_plane.h>
#include <pcl/segmentation/point_row.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

struct ObstaclePointParameters {
  DepthNoise noise;
  /** Of the lowest obstacles, metres; those lower than three standard deviations of the
   * height of a point may be missed. */
  float min_height = 0.01f;
  /** Of the lowest drop-offs, metres. */
  float min_drop = 0.03f;
  /** Points whose normal is further from that of the floor are on something else;
   * radians. */
  float normal_angle = 0.6f;
};

/** \brief Points with what is known of them, and the floor that was found. */
struct ObstacleFrame {
  OrganizedPoints points;
  /** One for each point; NaN is unknown. */
  OrganizedNormals normals;
  const LabelledPlanes& planes;
  const FloorPlane& floor;
};

/** \brief The points of a row, and sums over the points of each column in a few rows that
 * may be floor; all as long as a PointRow. */
struct ObstacleRow {
  /** \brief Sets all sums to 0 where the size changes. */
  void
  resize (std::size_t points_in_row);

  std::vector<float> height;
  std::vector<float>
      variance; /**< of the height; NaN or Inf where nothing is measured */
  std::vector<std::uint8_t> what; /**< unmeasured, floor, obstacle or drop_off */

  std::vector<float> height_sum;
  std::vector<float> variance_sum;
  std::vector<float> points;
  std::vector<float> high; /**< points high enough for a low obstacle */
};

/** \brief Tells the floor from all else, point by point (Holz et al. 2011, section 5.1).
 *
 * A point is an obstacle when it is further above the floor than noise explains; when the
 * mean height of the points around it, which has less noise, is that of a low obstacle; or
 * when most points around it, and itself, are on a plane that differs from the floor or
 * have another normal, however low they are. Points clearly below the floor are drop-offs.
 *
 * Noise that is independent from point to point moves points along their rays, and heights
 * above a floor seen flat by little of that. The smooth error of depth can bend away a piece
 * of a floor that furniture parts from the rest: on planes that are likely that, heights
 * count in standard deviations of depth instead.
 *
 * The points around a point are those of 3 x 3 cells of an image of 160 cells in a row,
 * each of 4 x 4 pixels in VGA.
 */
class PCL_RGBD_PLANES_EXPORTS ObstaclePoints {
public:
  /** \brief Starts with a frame that has a floor. */
  void
  start (const ObstacleFrame& frame, const ObstaclePointParameters& parameters);

  /** \brief Looks at the points of the next row.
   * \param[out] classes one for each point of the frame
   */
  void
  addRow (const ObstacleFrame& frame,
          int v,
          const PointRow& points,
          std::vector<ObstacleClass>& classes);

  /** \brief Tells what the points are: unmeasured, floor, obstacle or drop_off. */
  void
  finish (const ObstacleFrame& frame, std::vector<ObstacleClass>& classes) const;

private:
  /** Sums over the points of a cell that may be floor. */
  struct Cell {
    float height = 0.f;
    float variance = 0.f; // of the height
    float points = 0.f;
    float high = 0.f;   // points high enough for a low obstacle
    float differ = 0.f; // 1 where its first point is on another surface
  };

  /** Points of the row on other parts of the floor are floor unless they are too far off
   * for the error of depth. */
  void
  acceptParts (const ObstacleFrame& frame,
               std::size_t first,
               std::vector<ObstacleClass>& classes) const;

  void
  sumColumns (Cell* cells);

  void
  sampleRow (const ObstacleFrame& frame, std::size_t first, Cell* cells) const;

  /** The cells around a cell, and itself. */
  Cell
  window (int cell_u, int cell_v) const;

  void
  judgeCell (const ObstacleFrame& frame,
             int cell_u,
             int cell_v,
             std::vector<ObstacleClass>& classes) const;

  /** Whether a point has another normal than the floor, or its plane differs and
   * \a height is positive. */
  bool
  isOtherSurface (const ObstacleFrame& frame, std::size_t point, float height) const;

  ObstaclePointParameters parameters_;
  float min_cos_ = 1.f;
  int cell_size_ = 1;
  int width_ = 0;
  int cells_u_ = 0;
  int cells_v_ = 0;
  std::vector<Cell> cells_;
  ObstacleRow row_;
};

} // namespace rgbd_planes
} // namespace pcl
