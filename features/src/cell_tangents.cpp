// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cell_tangents.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "row_vectors-inl.h"
#include <hwy/cache_control.h>

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** Neighbouring points belong to one surface if their ranges differ by less than this
 * many deviations of depth, or if the surface is not seen at a flatter angle than this
 * slope, 76 degrees off its normal. */
constexpr float gate_sigmas = 3.5f;
constexpr float gate_slope = 4.f;

/** Rows of cells are read one by one, with pauses: those of the next one are step rows of points
 * further on. */
template <int step>
HWY_INLINE void
prefetchNext (const float* points, std::size_t cells)
{
  const float* next = points + step * 4 * step * cells;
  for (std::size_t line = 0; line < 4 * step * hn::Lanes (Floats()); line += 16)
    hwy::Prefetch (next + line);
}

HWY_INLINE Mask
isMeasured (V range)
{
  return hn::Lt (range, set (std::numeric_limits<float>::infinity()));
}

HWY_INLINE V
rangeOf (const Points& points)
{
  return hn::IfThenElse (points.measured,
                         hn::Sqrt (points.squared_range),
                         set (std::numeric_limits<float>::infinity()));
}

/** The deviation of depth at a range. */
HWY_INLINE V
deviationAt (V range, const SensorModel& sensor)
{
  return sigma (sensor, hn::Mul (range, range));
}

/** The square of how much noise changes a range. */
HWY_INLINE V
squaredGate (V range, const SensorModel& sensor)
{
  const V gate = hn::Mul (set (gate_sigmas), deviationAt (range, sensor));
  return hn::Mul (gate, gate);
}

HWY_INLINE void
storeCells (const Vectors& p,
            V range,
            const SensorModel& sensor,
            std::size_t at,
            const CellRow& row)
{
  store (p, row, cell_x, at);
  store (range, row[cell_range] + at);
  // 0 where the range is infinite.
  const V reach = hn::Mul (set (reach_sigmas), deviationAt (range, sensor));
  store (hn::IfThenElseZero (isMeasured (range), reciprocal (reach)),
         row[cell_reach] + at);
}

void
loadPixels (const float* points,
            std::size_t cells,
            const SensorModel& sensor,
            CellRow row)
{
  for (std::size_t i = 0; i < cells; i += hn::Lanes (Floats())) {
    const float* here = points + 4 * i;
    prefetchNext<1> (here, cells);
    usePoints<1> (
        here, sensor, [=, &sensor] (std::size_t, const Points& pixels) HWY_ATTR {
          storeCells (pixels.p, rangeOf (pixels), sensor, i, row);
        });
  }
}

/** The point of each cell is the mean of those pixels of it that are on the surface of the
 * nearest one. */
void
loadMeans (const float* points,
           const float* below,
           std::size_t cells,
           const SensorModel& sensor,
           CellRow row)
{
  const V zero = hn::Zero (Floats()), one = set (1.f);
  const Vectors none{zero, zero, zero};
  for (std::size_t i = 0; i < cells; i += hn::Lanes (Floats())) {
    // Without a value, GCC does not compile them for ARM.
    Vectors p[] = {none, none, none, none};
    V ranges[4];
    for (const std::size_t v : {0, 1}) {
      const float* here = (v == 0 ? points : below) + 8 * i;
      prefetchNext<2> (here, cells);
      usePoints<2> (here, sensor, [&] (std::size_t u, const Points& pixels) HWY_ATTR {
        p[2 * v + u] = pixels.p;
        ranges[2 * v + u] = rangeOf (pixels);
      });
    }
    const V nearest =
        hn::Min (hn::Min (ranges[0], ranges[1]), hn::Min (ranges[2], ranges[3]));
    const V squared_gate = squaredGate (nearest, sensor);
    Vectors sum = none;
    V range = zero, number = zero;
    for (std::size_t k = 0; k < 4; ++k) {
      const V change = hn::Sub (ranges[k], nearest);
      const Mask near = hn::Lt (hn::Mul (change, change), squared_gate);
      sum = sum + onlyWhere (near, p[k]);
      range = hn::Add (range, hn::IfThenElseZero (near, ranges[k]));
      number = hn::Add (number, hn::IfThenElseZero (near, one));
    }
    const V share = hn::Div (one, hn::Max (number, one));
    storeCells (sum * share,
                hn::IfThenElse (isMeasured (nearest), hn::Mul (range, share), nearest),
                sensor,
                i,
                row);
  }
}

struct Cells {
  Vectors p;
  V range;
};

HWY_INLINE Cells
loadCells (CellRow row, std::size_t at)
{
  return {load (row, cell_x, static_cast<std::ptrdiff_t> (at)),
          load (row[cell_range] + at)};
}

/** From points to their neighbours; zero where they lie on different surfaces. Surfaces seen at a
 * flatter angle are told from steps by the ranges of the next two cells: the range changes by the
 * same from each to the next. */
HWY_INLINE Vectors
tangentsBetween (const Cells& from,
                 const Cells& to,
                 V third,
                 V fourth,
                 V squared_gate,
                 const SensorModel& sensor)
{
  const Vectors tangent = to.p - from.p;
  const V change = hn::Sub (to.range, from.range);
  const V next_change = hn::Sub (third, to.range);
  const V before = hn::Sub (next_change, change);
  const V behind = hn::Sub (next_change, hn::Sub (fourth, third));
  const V squared_step = hn::Max (hn::Mul (before, before), hn::Mul (behind, behind));
  constexpr float slope = gate_slope * gate_slope;
  // Also false where a range is infinite.
  const Mask near =
      hn::Or (hn::Lt (squared_step, squared_gate),
              hn::Lt (hn::Mul (set (1.f + slope), hn::Mul (change, change)),
                      hn::MulAdd (set (slope), dot (tangent, tangent), squared_gate)));
  const V max_change = set (2.f * sensor.max_depth_change_factor);
  const V limit = hn::MulAdd (max_change, from.range, max_change);
  return onlyWhere (hn::And (near, hn::Le (hn::Abs (change), limit)), tangent);
}

void
computeTangentsOf (const CellRow* rows,
                   std::size_t cells,
                   const SensorModel& sensor,
                   float units,
                   CellTangentRow tangents)
{
  for (std::size_t i = 0; i < cells; i += hn::Lanes (Floats())) {
    const Cells here = loadCells (rows[0], i);
    const V squared_gate = squaredGate (here.range, sensor);
    const auto range = [&] (std::size_t row, std::size_t column) HWY_ATTR {
      return load (rows[row][cell_range] + i + column);
    };
    const Vectors h = tangentsBetween (here,
                                       loadCells (rows[0], i + 1),
                                       range (0, 2),
                                       range (0, 3),
                                       squared_gate,
                                       sensor);
    const Vectors v = tangentsBetween (
        here, loadCells (rows[1], i), range (2, 0), range (3, 0), squared_gate, sensor);
    store (h, tangents, 0, i);
    store (v, tangents, 3, i);
    // Next to the sensor, tangents can be longer than the range.
    const V squared_longest =
        hn::Max (hn::Mul (here.range, here.range), hn::Max (dot (h, h), dot (v, v)));
    store (hn::IfThenElseZero (isMeasured (here.range),
                               hn::Mul (set (units), reciprocalSqrt (squared_longest))),
           tangents[tangent_scale] + i);
  }
}

} // namespace

void
loadCellsHere (const std::array<const float*, 2>& points,
               std::size_t cells,
               int step,
               const SensorModel& sensor,
               const CellRow& row)
{
  if (step == 1)
    loadPixels (points[0], cells, sensor, row);
  else
    loadMeans (points[0], points[1], cells, sensor, row);
}

void
computeTangentsHere (const std::array<CellRow, 4>& rows,
                     std::size_t cells,
                     const SensorModel& sensor,
                     float units,
                     const CellTangentRow& tangents)
{
  computeTangentsOf (rows.data(), cells, sensor, units, tangents);
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (loadCellsHere);
HWY_EXPORT (computeTangentsHere);

void
loadCells (const std::array<const float*, 2>& points,
           std::size_t cells,
           int step,
           const SensorModel& sensor,
           const CellRow& row)
{
  HWY_DYNAMIC_DISPATCH (loadCellsHere) (points, cells, step, sensor, row);
}

void
computeTangents (const std::array<CellRow, 4>& rows,
                 std::size_t cells,
                 const SensorModel& sensor,
                 float units,
                 const CellTangentRow& tangents)
{
  HWY_DYNAMIC_DISPATCH (computeTangentsHere) (rows, cells, sensor, units, tangents);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
