// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "tangent_rows.h"

#include <pcl/features/impl/tangent_normals.h>
#include <pcl/features/impl/tangent_row_pipeline.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/** The first and the last cell of a row have no tangents on one side that could tell a
 * bend: they take the weight of their neighbours. */
void
copyBendToBorders (const PlaneRow& planes, int width)
{
  if (width < 3)
    return;
  for (const auto& [border, inside] : {std::pair (0, 1), {width - 1, width - 2}})
    if (planes[plane_weight][border] > 0.f && planes[plane_weight][inside] > 0.f)
      planes[plane_weight][border] = planes[plane_weight][inside];
}

} // namespace

std::size_t
TangentRowPipeline::run (int end, const NormalOutput& output)
{
  std::size_t valid = 0;
  for (int y = begin_; y < end; ++y) {
    planesUpTo (lastStage(), y + rowsAround());
    const int below = std::min ((y + 1) * grid_.step, points_.height);
    for (int v = y * grid_.step; v < below; ++v)
      valid += write (v, output);
  }
  return valid;
}

int
TangentRowPipeline::lastStage() const
{
  return parameters_->edge_aware ? plane_stages - 1 : 0;
}

/** Where a cell has several points, each looks at the planes around, see write(). */
int
TangentRowPipeline::rowsAround() const
{
  return parameters_->edge_aware && grid_.step > 1 ? grid_.straight.v : 0;
}

void
TangentRowPipeline::start (const OrganizedPoints& points,
                           const TangentNormalParameters& parameters,
                           const TangentGrid& grid,
                           int begin)
{
  points_ = points;
  parameters_ = &parameters;
  grid_ = grid;
  sensor_.origin = parameters.sensor_origin;
  // So that deviations of depth, and their reciprocals, are floats at any range.
  sensor_.noise.constant = std::clamp (parameters.noise.constant, 1e-30f, 1e30f);
  sensor_.noise.quadratic = std::min (parameters.noise.quadratic, 1e6f);
  sensor_.max_depth_change_factor =
      static_cast<float> (grid.step) * parameters.max_depth_change_factor;
  begin_ = begin;
  padded_width_ = RowRing<float>::roundUp (grid_.width);
  const auto largest = grid_.areas[grid_.number_of_areas - 1];
  const int area = (2 * largest.half_width + 1) * (2 * largest.half_height + 1);
  units_ =
      std::min (static_cast<float> (1 << 30) / static_cast<float> (area), max_units);

  const int shift_u = std::max (grid_.diagonal.u, grid_.straight.u);
  // So many rows above and below does the step after each stage look at.
  const std::array<int, plane_stages> rows_around{
      {parameters.edge_aware ? grid_.diagonal.v : 0,
       parameters.edge_aware ? grid_.straight.v : 0,
       rowsAround()}};
  const int ahead = rows_around[0] + rows_around[1] + largest.half_height;
  margin_ = RowRing<float>::roundUp (largest.half_width + 1);
  staged_points_.reset (2, 1, 4 * grid_.step * padded_width_, 0, nan);
  no_points_.reset (1, 1, 4 * grid_.step * padded_width_, 0, nan);
  cells_.reset (ahead + 4, cell_channels, padded_width_, 3, infinity);
  no_cells_.reset (1, cell_channels, padded_width_, 3, infinity);
  tangents_.reset (
      2 * largest.half_height + 2, tangent_channels, padded_width_, margin_, 0);
  cell_tangents_.reset (1, cell_tangent_channels, padded_width_, 0, 0.f);
  columns_.reset (2, tangent_channels, padded_width_, margin_, 0);
  for (std::size_t stage = 0; stage < planes_.size(); ++stage)
    planes_[stage].reset (
        2 * rows_around[stage] + 1, plane_channels, padded_width_, shift_u, 0.f);
  no_planes_.reset (1, plane_channels, padded_width_, shift_u, 0.f);
  larger_.reset (1, plane_channels, padded_width_, 0, 0.f);
  normals_.reset (
      1, 1, static_cast<int> (normal_floats) * grid_.step * padded_width_, 0, 0.f);

  const int before_second = begin - rows_around[2];
  const int before_first = before_second - rows_around[1];
  next_planes_ = {{std::max (before_first - rows_around[0], 0),
                   std::max (before_first, 0),
                   std::max (before_second, 0)}};
  next_sum_ = std::max (next_planes_[0] - largest.half_height, 0);
  next_cells_ = next_sum_;
  tangents_.fill (next_sum_, 0);
}

/** The points of a row of pixels, four floats each, and points that are missing up to
 * whole vectors of cells; those of two rows in a row stay. */
const float*
TangentRowPipeline::pointsOf (int v)
{
  if (v >= points_.height)
    return no_points_[0][0];
  const float* row =
      points_[static_cast<std::size_t> (v) * static_cast<std::size_t> (points_.width)];
  const bool in_place = points_.stride == 4 &&
                        reinterpret_cast<std::uintptr_t> (row) % 16 == 0 &&
                        points_.width == padded_width_ * grid_.step;
  if (in_place)
    return row;
  float* staged = staged_points_[v][0];
  for (int u = 0; u < points_.width; ++u)
    std::memcpy (staged + 4 * u,
                 row + static_cast<std::size_t> (u) * points_.stride,
                 3 * sizeof (float));
  std::fill (staged + 4 * points_.width, staged + 4 * grid_.step * padded_width_, nan);
  return staged;
}

void
TangentRowPipeline::sumUpTo (int last)
{
  const auto cells = static_cast<std::size_t> (padded_width_);
  for (const int end = std::min (last + 1, grid_.height); next_sum_ < end;
       ++next_sum_) {
    for (; next_cells_ <= std::min (next_sum_ + 3, grid_.height - 1); ++next_cells_) {
      const int v = next_cells_ * grid_.step;
      loadCells ({{pointsOf (v), grid_.step == 2 ? pointsOf (v + 1) : nullptr}},
                 cells,
                 grid_.step,
                 sensor_,
                 cells_[next_cells_]);
    }
    const auto row = [&] (int y) {
      return y < grid_.height ? cells_[y] : no_cells_[0];
    };
    computeTangents ({{row (next_sum_),
                       row (next_sum_ + 1),
                       row (next_sum_ + 2),
                       row (next_sum_ + 3)}},
                     cells,
                     sensor_,
                     units_,
                     cell_tangents_[0]);
    addUp (cell_tangents_[0],
           cells,
           static_cast<std::size_t> (margin_),
           tangents_[next_sum_],
           tangents_[next_sum_ + 1]);
  }
}

void
TangentRowPipeline::fitRow (int y)
{
  const auto cells = static_cast<std::size_t> (padded_width_);
  sumUpTo (y + grid_.areas[grid_.number_of_areas - 1].half_height);
  const PlaneRow planes = planes_[0][y];
  for (std::size_t i = 0; i < grid_.number_of_areas; ++i) {
    const auto& area = grid_.areas[i];
    const int top = std::max (y - area.half_height, 0);
    const int below = std::min (y + area.half_height + 1, grid_.height);
    const WindowRows window{tangents_[top],
                            tangents_[(top + below) / 2],
                            tangents_[std::min (y + area.half_height, grid_.height)],
                            tangents_[below]};
    const WindowColumns columns{columns_[0], columns_[1]};
    const PlaneRow fitted = i == 0 ? planes : larger_[0];
    sumColumns (window, cells + static_cast<std::size_t> (margin_), columns);
    fitPlanes (columns, area.half_width, cells, cells_[y], fitted);
    if (i > 0)
      chooseLarger (parameters_->scale_selection ? 0.f : area.min_range,
                    cells,
                    cells_[y],
                    fitted,
                    planes);
  }
  copyBendToBorders (planes, grid_.width);
}

/** Averages the planes of a row of cells over those around: diagonally and straight in turn,
 * for the price of half of all. */
void
TangentRowPipeline::averageRow (int stage, int y)
{
  const bool diagonal = stage == 1;
  const auto [du, dv] = diagonal ? grid_.diagonal : grid_.straight;
  planesUpTo (stage - 1, y + dv);
  const PlaneRow above = planesOf (stage - 1, y - dv);
  const PlaneRow own = planesOf (stage - 1, y);
  const PlaneRow below = planesOf (stage - 1, y + dv);
  const Candidates<5> around =
      diagonal
          ? Candidates<5>{{own,
                           above.shifted (-du),
                           above.shifted (du),
                           below.shifted (-du),
                           below.shifted (du)}}
          : Candidates<5>{{own, above, own.shifted (-du), own.shifted (du), below}};
  averagePlanes (around,
                 static_cast<std::size_t> (padded_width_),
                 cells_[y],
                 planes_[static_cast<std::size_t> (stage)][y]);
}

/** Computes the planes of a stage up to row \a last. */
void
TangentRowPipeline::planesUpTo (int stage, int last)
{
  int& next = next_planes_[static_cast<std::size_t> (stage)];
  for (const int end = std::min (last + 1, grid_.height); next < end; ++next)
    if (stage == 0)
      fitRow (next);
    else
      averageRow (stage, next);
}

/** The planes of row \a y of cells, or none outside of the image. */
ChannelRow<float>
TangentRowPipeline::planesOf (int stage, int y)
{
  const bool inside = y >= 0 && y < grid_.height;
  return inside ? planes_[static_cast<std::size_t> (stage)][y] : no_planes_[0];
}

} // namespace rgbd_planes
} // namespace pcl
