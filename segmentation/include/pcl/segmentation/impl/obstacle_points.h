// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/filters/obstacle_class.h>
#include <pcl/segmentation/impl/floor_plane.h>
#include <pcl/segmentation/impl/obstacle_clusters.h>
#include <pcl/segmentation/impl/pixel_angles.h>
#include <pcl/segmentation/impl/point_row.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The settings of ObstaclePoints. */
struct ObstaclePointParameters {
  DepthNoise noise = DepthNoise::kinectV1();
  /** Of the lowest obstacles that are told by their height, metres; those lower than three
   * standard deviations of depth may be missed. */
  float min_height = 0.01f;
  /** Of the lowest drop-offs, metres. */
  float min_drop = 0.03f;
};

/** \brief Points with what is known of them, and the floor that was found. */
struct ObstacleFrame {
  OrganizedPoints points;
  /** One for each point; NaN is unknown. */
  OrganizedNormals normals;
  const LabelledPlanes& planes;
  const FloorPlane& floor;
};

/** \brief Sums over points that may be floor, one for each column or cell of an image; as
 * long as vectors need that begin with the last one. */
struct FloorSums {
  std::vector<float> height;
  std::vector<float> variance; /**< of the height */
  std::vector<float> points;   /**< their number */
  std::vector<float> high; /**< the number of those high enough for a low obstacle */
};

/** \brief A row of cells: their sums, and 1 for those whose first point is on another surface.
 * Cell 0 is number 1, the cells around the row are empty. */
struct CellRow {
  FloorSums sums;
  std::vector<float> differ;
};

/** \brief What the points around the cells of a row tell; as long as vectors need. */
struct CellVerdicts {
  /** 1 for cells that a low obstacle may be in. */
  std::vector<std::uint8_t> are_high;
  /** 1 for cells that another surface may be in. */
  std::vector<std::uint8_t> are_other;
  std::vector<float> height; /**< mean */
  std::vector<float> limit;  /**< of the square of the mean height of floor */
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
 * count in standard deviations of depth instead. A plane that is too far off for that where
 * it is near, or where it meets the floor in the image, is another level: its points are
 * obstacles or drop-offs, also those that noise moves near to the floor.
 *
 * The points around a point are those of 3 x 3 cells of an image of 160 cells along its
 * longer side, each of 4 x 4 pixels in VGA.
 */
class PCL_RGBD_PLANES_EXPORTS ObstaclePoints {
public:
  /** \brief Starts with a frame. */
  void
  start (const ObstacleFrame& frame,
         const ObstaclePointParameters& parameters,
         const PixelAngles& angles);

  /** \brief Looks at the points of the next row.
   * \param[in] points_above any row for v = 0
   * \param[out] links of the points
   * \param[out] classes one for each point of the frame
   * \return the number of rows, from the first one on, whose classes are final:
   * unmeasured, floor, obstacle or drop_off
   */
  int
  addRow (const ObstacleFrame& frame,
          int v,
          const PointRow& points,
          const PointRow& points_above,
          RowLinks& links,
          std::vector<ObstacleClass>& classes);

  /** \brief No more rows wait to become final, with the one that is added. */
  int
  maxWaiting () const
  {
    return 2 * cell_size_;
  }

private:
  void
  prefetchNormals (const ObstacleFrame& frame, int v) const;

  /** Points of the row on other parts of the floor are floor unless they are too far off
   * for the error of depth, those on other levels are not. */
  void
  judgePlanes (const ObstacleFrame& frame,
               std::size_t first,
               std::vector<ObstacleClass>& classes) const;

  void
  sampleRow (const ObstacleFrame& frame, std::size_t first, CellRow& cells) const;

  void
  judgeRow (const ObstacleFrame& frame,
            int cell_v,
            std::vector<ObstacleClass>& classes);

  void
  judgeCell (const ObstacleFrame& frame,
             int cell_u,
             int cell_v,
             std::vector<ObstacleClass>& classes) const;

  /** The rows of cells before the first one and after the last one are empty. */
  CellRow&
  cellRow (int cell_v)
  {
    return cells_[(cell_v + 3) % 3];
  }

  /** Whether the normal of a point is not that of the floor. */
  bool
  isTurned (const ObstacleFrame& frame, std::size_t point) const;

  ObstaclePointParameters parameters_;
  PixelAngles angles_;
  int cell_size_ = 1;
  int width_ = 0;
  int cells_u_ = 0;
  std::vector<ObstacleClass> row_; // as long as its words
  FloorSums columns_;              // of the row of cells at hand
  CellRow cells_[3];               // in turn
  CellVerdicts verdicts_;
};

} // namespace rgbd_planes
} // namespace pcl
