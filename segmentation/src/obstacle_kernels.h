// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/segmentation/impl/obstacle_clusters.h>
#include <pcl/segmentation/impl/obstacle_points.h>
#include <pcl/segmentation/impl/point_row.h>

#include <algorithm>

namespace pcl {
namespace rgbd_planes {

// Thresholds in standard deviations of the height of a point. On simulated floors, no
// point exceeds the first, and 0.01 % of the windows the second: the warp of a Kinect's
// depth moves their means, though not their noise, as much as that of points.
constexpr float point_sigmas = 4.5f;
constexpr float window_sigmas = 2.75f;
/** A point is of a low obstacle, where there is one, from this part of the least height of an
 * obstacle on, if it exceeds so many standard deviations. */
constexpr float high_part = 0.25f, high_sigmas = 0.5f * window_sigmas;
/** Below the floor: real sensors also measure far depth too long, which bends floors
 * downwards by more than their noise. */
constexpr float drop_sigmas = 8.f;

/** The points around a point are looked at in cells of so many pixels to a side. */
inline int
cellSize (const OrganizedPoints& points)
{
  constexpr int cells_along = 160;
  return std::max (std::max (points.width, points.height) / cells_along, 1);
}

/** Neighbours that are further apart than the larger of these, and so many standard deviations of
 * depth, are not of the same thing. */
constexpr float max_gap_m = 0.05f, max_gap_pixels = 2.f;
constexpr float max_gap_sigmas = 3.f;

/** Tells what the points of a row are by their heights above the floor alone, adds those that
 * may be floor to the sums of their columns, and links neighbours.
 * \param[out] classes unmeasured, floor, obstacle or drop_off, as many as there are bits in
 * the words of the row
 */
void
classifyRow (const PointRow& row,
             const PointRow& row_above,
             const Eigen::Vector4f& floor,
             const ObstaclePointParameters& parameters,
             const PixelAngles& angles,
             ObstacleClass* classes,
             RowLinks& links,
             FloorSums& columns);

/** Tells which of \a size points of a row are of which class. */
void
findClasses (const ObstacleClass* classes, std::size_t size, ClassBits& found);

/** Moves sums of columns to the cells that they are in.
 * \param[in] cells their number
 * \param[out] sums of cell 0 are number 1
 */
void
sumCells (FloorSums& columns,
          std::size_t cell_size,
          std::size_t cells,
          FloorSums& sums);

/** What must be around a cell: measured points, and for an obstacle samples that differ or
 * a mean height. */
struct CellLimits {
  float points, samples, height;
};

/** Looks at the cells around those of a row.
 * \param[in] cells their number
 * \return whether there may be an obstacle in any of them
 */
bool
judgeCells (const CellRow& above,
            const CellRow& row,
            const CellRow& below,
            std::size_t cells,
            const CellLimits& limits,
            CellVerdicts& verdicts);

} // namespace rgbd_planes
} // namespace pcl
