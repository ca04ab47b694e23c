// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/row_ring.h>
#include <pcl/features/impl/tangent_row_pipeline.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace pcl {
namespace rgbd_planes {

// The steps of tangent_row_pipeline.cpp, each for one row of cells, with the vector
// instructions of the machine it runs on. A cell is one pixel (step 1) or 2 x 2 pixels
// (step 2); step pixels of a row of pixels belong to each of its cells. All points are
// relative to the sensor. Loops take the rows that they write by value: a compiler cannot tell
// that what they write is not the row itself, and would load it again and again.

/** The channels of a row of cells: the point, the reciprocal of the distance from it at which
 * planes no longer count (0: the cell has no point), the range (infinite without a point). */
enum CellChannel { cell_x, cell_y, cell_z, cell_reach, cell_range, cell_channels };

/** The channels of the planes of a row of cells: n * p = distance, and how much a plane
 * counts, from its window's bend; all are 0 where there is none. */
enum PlaneChannel {
  plane_x,
  plane_y,
  plane_z,
  plane_distance,
  plane_weight,
  plane_channels
};

/** Horizontal and vertical tangents, or sums of them. */
constexpr int tangent_channels = 6;

/** The tangents of a row of cells, and what makes a number of units of them. */
enum CellTangentChannel { tangent_scale = tangent_channels, cell_tangent_channels };

/** A cell counts up to so many units. */
constexpr float max_units = 1 << 22;

using CellTangentRow = ChannelRow<float>;
using CellRow = ChannelRow<float>;
using PlaneRow = ChannelRow<float>;
using TangentRow = ChannelRow<std::int32_t>;

/** The sums over a window need the rows of integral images above its first row, above
 * its middle row, and below its last row. Tangents lie between rows, hence one row of
 * vertical ones less. */
struct WindowRows {
  TangentRow top;
  TangentRow middle;
  TangentRow below_vertical;
  TangentRow below;
};

/** The sums over all rows of a window and over those of its lower half, in all columns up
 * to each. */
struct WindowColumns {
  TangentRow whole;
  TangentRow lower;
};

/** The planes that the points of a row of cells may lie on: first those of the cells
 * themselves, then those of the cells so many rows and columns away. */
template <std::size_t number>
using Candidates = std::array<PlaneRow, number>;

/** \brief Reads a row of cells from one row of points, of four floats each, or from two, if
 * \a step is 2. */
void
loadCells (const std::array<const float*, 2>& points,
           std::size_t cells,
           int step,
           const SensorModel& sensor,
           const CellRow& row);

/** \brief The tangents from each cell to the next one and to the one below. \a rows: that of
 * the cells and the next three. Tangents are relative to the range of the cell, or to the
 * longer of them if that is more, and counted in units of 1 / \a units, which must not be more
 * than max_units. */
void
computeTangents (const std::array<CellRow, 4>& rows,
                 std::size_t cells,
                 const SensorModel& sensor,
                 float units,
                 const CellTangentRow& tangents);

/** \brief Continues the integral images by one row, and by \a margin elements behind it. */
void
addUp (const CellTangentRow& tangents,
       std::size_t cells,
       std::size_t margin,
       const TangentRow& above,
       const TangentRow& integral);

/** \brief Sums the \a columns of a window of any width. */
void
sumColumns (const WindowRows& rows, std::size_t columns, const WindowColumns& sums);

/** \brief The plane of the window around each cell, through the point of the cell. */
void
fitPlanes (const WindowColumns& columns,
           std::ptrdiff_t half_width,
           std::size_t cells,
           const CellRow& points,
           const PlaneRow& planes);

/** \brief Puts those of \a larger windows in the place of planes that are less likely, or, if
 * \a min_range is not 0, of those of points this far away. */
void
chooseLarger (float min_range,
              std::size_t cells,
              const CellRow& points,
              const PlaneRow& larger,
              const PlaneRow& planes);

/** \brief The mean of the planes around each cell on which its point lies. */
void
averagePlanes (const Candidates<5>& candidates,
               std::size_t cells,
               const CellRow& points,
               const PlaneRow& planes);

/** The normal of a pixel as it is written: nx, ny, nz, 0, curvature, 0, 0, 0, as in
 * pcl::Normal; NaN where there is none. */
constexpr std::size_t normal_floats = 8;

/** \brief Gives each point of a row of pixels the normal of its cell's plane, or, if it
 * does not lie on that and \a candidates is not null, of the planes around.
 * \return the number of normals that are not NaN */
std::size_t
writeNormals (const float* points,
              std::size_t cells,
              int step,
              const SensorModel& sensor,
              const PlaneRow& planes,
              const Candidates<9>* candidates,
              float* normals);

} // namespace rgbd_planes
} // namespace pcl
