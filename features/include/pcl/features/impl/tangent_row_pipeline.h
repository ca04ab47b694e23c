// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/features/impl/row_ring.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace pcl {
namespace rgbd_planes {

struct NormalOutput;
struct TangentNormalParameters;

/** \brief What is known of the sensor. */
struct SensorModel {
  std::array<float, 3> origin{{0.f, 0.f, 0.f}};
  DepthNoise noise; // tells surfaces apart
  float max_depth_change_factor = 0.f;
};

/** \brief The grid on which TangentNormals computes, in cells of step x step pixels. */
struct TangentGrid {
  int step = 1;
  int width = 0;
  int height = 0;
  /** A smoothing area reaches this many cells to each side of a cell. */
  struct Area {
    int half_width = 1;
    int half_height = 1;
    /** The range from which on this area is used, where it depends on range. */
    float min_range = 0.f;
  };
  /** The areas to choose from, from small to large. */
  std::array<Area, 4> areas;
  std::size_t number_of_areas = 1;
  /** \brief In pixels. */
  struct Shift {
    int u = 1;
    int v = 1;
  };
  /** How far away the planes are that are averaged: first diagonally, then straight. */
  Shift diagonal;
  Shift straight;
};

/** \brief Computes the normals of some rows of a cloud. Each step works on rows of cells
 * and runs a few rows ahead of the next one, so that what it writes still is in the cache
 * when it is read:
 *
 * points -> cells -> integral images of tangents -> plane of the area around each cell
 * -> means of planes, where edge-aware: twice -> normals of points
 */
class TangentRowPipeline {
public:
  /** \brief Makes room for what run() does from row \a begin of cells on. */
  void
  start (const OrganizedPoints& points,
         const TangentNormalParameters& parameters,
         const TangentGrid& grid,
         int begin);

  /** \brief Writes the normals of the rows of cells from that of start() to before \a end;
   * allocates nothing.
   * \return the number of normals that are not NaN */
  std::size_t
  run (int end, const NormalOutput& output);

private:
  /** Planes as fitted, after the first, and after the second round of averaging. */
  static constexpr int plane_stages = 3;

  int
  lastStage () const;

  int
  rowsAround () const;

  void
  sumUpTo (int last);

  void
  fitRow (int y);

  void
  planesUpTo (int stage, int last);

  void
  averageRow (int stage, int y);

  ChannelRow<float>
  planesOf (int stage, int y);

  std::size_t
  write (int v, const NormalOutput& output);

  std::size_t
  writeRow (int v, float* normals);

  void
  copyNormals (const float* normals, int v, const NormalOutput& output);

  std::size_t
  blankBorder (int y, float* normals);

  const float*
  pointsOf (int v);

  OrganizedPoints points_;
  const TangentNormalParameters* parameters_ = nullptr;
  TangentGrid grid_;
  /** Made once: what was just written part by part takes long to be read as a whole. */
  SensorModel sensor_;
  int begin_ = 0; // of the rows of cells that are computed
  int padded_width_ = 0;
  int margin_ = 0;
  float units_ = 0.f;
  int next_cells_ = 0;
  int next_sum_ = 0;
  std::array<int, plane_stages> next_planes_{};

  RowRing<float> staged_points_;
  RowRing<float> no_points_;
  RowRing<float> cells_;
  RowRing<float> no_cells_;
  RowRing<float> cell_tangents_;
  RowRing<std::int32_t> tangents_;
  RowRing<std::int32_t> columns_;
  std::array<RowRing<float>, plane_stages> planes_;
  RowRing<float> no_planes_;
  RowRing<float> larger_;
  RowRing<float> normals_;
};

} // namespace rgbd_planes
} // namespace pcl
