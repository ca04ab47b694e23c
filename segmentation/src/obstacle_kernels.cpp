// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "obstacle_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "obstacle_kernels.h"
#include "plane_vectors-inl.h"
#include "row_bits.h"

#include <algorithm>
#include <numeric>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** As many as there are bits in a word, or in as many vectors as fill it. */
using Bytes = hn::CappedTag<std::uint8_t, bits_in_word>;

/** \a value where \a bits are set, else 0. */
HWY_INLINE hn::Vec<Bytes>
bytesWhere (std::uint64_t bits, std::uint8_t value)
{
  const auto* bytes = reinterpret_cast<const std::uint8_t*> (&bits);
  return hn::IfThenElseZero (hn::LoadMaskBits (Bytes(), bytes),
                             hn::Set (Bytes(), value));
}

HWY_INLINE void
add (V value, float* sum)
{
  hn::StoreU (hn::Add (load (sum), value), Floats(), sum);
}

/** Points of which the heights above the floor tell something. */
struct Heights {
  V height;
  V variance_at_1m; // of the height, times the square of the range
  Mask measured, obstacle, drop_off, high;

  HWY_INLINE
  Heights (const Points& p,
           V squared_range,
           V sigma,
           V farthest,
           const Eigen::Vector4f& floor,
           const ObstaclePointParameters& parameters)
  {
    measured = isUsable (squared_range, farthest);
    height = signedDistance ({floor[0], floor[1], floor[2], floor[3]}, p);
    const V scaled_sigma = hn::Mul (set (floor[3]), sigma);
    variance_at_1m = hn::Mul (scaled_sigma, scaled_sigma);
    const V square = hn::Mul (hn::Mul (height, height), squared_range);
    const auto exceeds = [&] (float sigmas) {
      return hn::And (measured,
                      hn::Gt (square, hn::Mul (set (sigmas * sigmas), variance_at_1m)));
    };
    obstacle =
        hn::And (exceeds (point_sigmas), hn::Gt (height, set (parameters.min_height)));
    drop_off =
        hn::And (exceeds (drop_sigmas), hn::Lt (height, set (-parameters.min_drop)));
    high = hn::And (exceeds (high_sigmas),
                    hn::Gt (height, set (high_part * parameters.min_height)));
  }
};

HWY_INLINE void
addFloor (const Heights& heights, V squared_range, std::size_t i, FloorSums& columns)
{
  const Mask may_be_floor =
      hn::AndNot (hn::Or (heights.obstacle, heights.drop_off), heights.measured);
  if (hn::AllFalse (Floats(), may_be_floor))
    return;
  const V variance = hn::Div (heights.variance_at_1m, squared_range);
  const V one = set (1.f);
  add (hn::IfThenElseZero (may_be_floor, heights.height), &columns.height[i]);
  add (hn::IfThenElseZero (may_be_floor, variance), &columns.variance[i]);
  add (hn::IfThenElseZero (may_be_floor, one), &columns.points[i]);
  add (hn::IfThenElseZero (hn::And (may_be_floor, heights.high), one),
       &columns.high[i]);
}

} // namespace

void
classifyRowHere (const PointRow& row,
                 const PointRow& row_above,
                 const Eigen::Vector4f& floor,
                 const ObstaclePointParameters& parameters,
                 const PixelAngles& angles,
                 ObstacleClass* classes,
                 RowLinks& links,
                 FloorSums& columns)
{
  const V farthest = set (parameters.noise.maxSquaredRange());
  for (std::size_t word = 0; word < links.to_left.size(); ++word) {
    std::uint64_t measured = 0, obstacle = 0, drop_off = 0, to_left = 0, to_above = 0;
    const std::size_t first = word * bits_in_word;
    const std::size_t size = std::min (bits_in_word, row.size() - first);
    for (std::size_t k = 0; k < size; k += hn::Lanes (Floats())) {
      const auto i = static_cast<std::ptrdiff_t> (first + k);
      const Points p = load (row, i);
      const V squared_range = squaredLength (p);
      const V sigma = sigmaOf (parameters.noise, squared_range);
      const Heights heights (p, squared_range, sigma, farthest, floor, parameters);
      measured |= bitsOf (Floats(), heights.measured) << k;
      obstacle |= bitsOf (Floats(), heights.obstacle) << k;
      drop_off |= bitsOf (Floats(), heights.drop_off) << k;
      addFloor (heights, squared_range, first + k, columns);

      const V pixels = hn::Mul (set (max_gap_pixels), hn::Sqrt (squared_range));
      const auto closeTo = [&] (const Points& q, float angle) {
        const V gap = hn::Max (set (max_gap_m), hn::Mul (set (angle), pixels));
        const V limit = hn::MulAdd (set (max_gap_sigmas), sigma, gap);
        return bitsOf (Floats(), hn::Le (squaredLength (p - q), hn::Mul (limit, limit)))
               << k;
      };
      to_left |= closeTo (load (row, i - 1), angles.in_row);
      to_above |= closeTo (load (row_above, i), angles.in_column);
    }
    links.to_left[word] = to_left;
    links.to_above[word] = to_above;
    auto* to = reinterpret_cast<std::uint8_t*> (classes) + first;
    for (std::size_t k = 0; k < bits_in_word; k += hn::Lanes (Bytes()))
      hn::StoreU (hn::Add (bytesWhere (measured >> k, 1),
                           hn::Add (bytesWhere (obstacle >> k, 1),
                                    bytesWhere (drop_off >> k, 2))),
                  Bytes(),
                  to + k);
  }
}

void
findClassesHere (const ObstacleClass* classes, std::size_t size, ClassBits& found)
{
  std::uint8_t rest[bits_in_word] = {};
  for (std::size_t word = 0; word < found.thing.size(); ++word) {
    const std::size_t first = word * bits_in_word;
    const auto* from = reinterpret_cast<const std::uint8_t*> (classes) + first;
    if (size - first < bits_in_word) {
      std::copy (from, from + (size - first), rest);
      from = rest;
    }
    const auto bitsWith = [&] (ObstacleClass what) {
      std::uint64_t bits = 0;
      for (std::size_t k = 0; k < bits_in_word; k += hn::Lanes (Bytes()))
        bits |= bitsOf (Bytes(),
                        hn::Eq (hn::LoadU (Bytes(), from + k),
                                hn::Set (Bytes(), static_cast<std::uint8_t> (what))))
                << k;
      return bits;
    };
    found.unmeasured[word] = bitsWith (ObstacleClass::unmeasured);
    found.drop_off[word] = bitsWith (ObstacleClass::drop_off);
    found.thing[word] = bitsWith (ObstacleClass::obstacle);
    if (found.excluded.empty())
      continue;
    found.excluded[word] = bitsWith (ObstacleClass::excluded);
    found.thing[word] |= found.excluded[word];
  }
}

void
sumCellsHere (FloorSums& columns,
              std::size_t cell_size,
              std::size_t cells,
              FloorSums& sums)
{
  const auto sumUp = [=] (std::vector<float>& values, float* cell_sums) {
    std::size_t size = cell_size;
    for (; size % 2 == 0; size /= 2)
      for (std::size_t i = 0; i < cells * size / 2; i += hn::Lanes (Floats())) {
        V even, odd;
        hn::LoadInterleaved2 (Floats(), &values[2 * i], even, odd);
        hn::StoreU (hn::Add (even, odd), Floats(), &values[i]);
      }
    if (size == 1)
      std::copy_n (values.begin(), cells, cell_sums);
    else
      for (std::size_t cell = 0; cell < cells; ++cell)
        cell_sums[cell] =
            std::accumulate (&values[cell * size], &values[cell * size] + size, 0.f);
    std::fill (values.begin(), values.end(), 0.f);
  };
  sumUp (columns.height, &sums.height[1]);
  sumUp (columns.variance, &sums.variance[1]);
  sumUp (columns.points, &sums.points[1]);
  sumUp (columns.high, &sums.high[1]);
}

bool
judgeCellsHere (const CellRow& above,
                const CellRow& row,
                const CellRow& below,
                std::size_t cells,
                const CellLimits& limits,
                CellVerdicts& verdicts)
{
  Mask any = hn::MaskFromVec (hn::Zero (Floats()));
  for (std::size_t i = 0; i < cells; i += hn::Lanes (Floats())) {
    const auto sumAround = [i] (const std::vector<float>& a,
                                const std::vector<float>& b,
                                const std::vector<float>& c) {
      V sum = hn::Zero (Floats());
      for (std::size_t k = i; k < i + 3; ++k)
        sum =
            hn::Add (sum, hn::Add (load (&a[k]), hn::Add (load (&b[k]), load (&c[k]))));
      return sum;
    };
    const auto around = [&] (std::vector<float> FloorSums::*values) {
      return sumAround (above.sums.*values, row.sums.*values, below.sums.*values);
    };
    const V points = around (&FloorSums::points);
    const V height = hn::Div (around (&FloorSums::height), points);
    const V limit = hn::Div (
        hn::Mul (set (window_sigmas * window_sigmas), around (&FloorSums::variance)),
        points);
    const Mask is_high = hn::And (hn::Gt (height, set (limits.height)),
                                  hn::Gt (hn::Mul (height, height), limit));
    const Mask is_other = hn::Ge (sumAround (above.differ, row.differ, below.differ),
                                  set (limits.samples));
    const V none = hn::Zero (Floats());
    const Mask may_be = hn::And (hn::Ge (points, set (limits.points)),
                                 hn::Or (hn::Gt (load (&row.sums.high[i + 1]), none),
                                         hn::Gt (load (&row.differ[i + 1]), none)));
    storeBytes (intOf (hn::And (may_be, is_high), 1), &verdicts.are_high[i]);
    storeBytes (intOf (hn::And (may_be, is_other), 1), &verdicts.are_other[i]);
    hn::StoreU (height, Floats(), &verdicts.height[i]);
    hn::StoreU (limit, Floats(), &verdicts.limit[i]);
    any = hn::Or (any, hn::And (may_be, hn::Or (is_high, is_other)));
  }
  return !hn::AllFalse (Floats(), any);
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (classifyRowHere);
HWY_EXPORT (findClassesHere);
HWY_EXPORT (sumCellsHere);
HWY_EXPORT (judgeCellsHere);

void
classifyRow (const PointRow& row,
             const PointRow& row_above,
             const Eigen::Vector4f& floor,
             const ObstaclePointParameters& parameters,
             const PixelAngles& angles,
             ObstacleClass* classes,
             RowLinks& links,
             FloorSums& columns)
{
  HWY_DYNAMIC_DISPATCH (classifyRowHere)
  (row, row_above, floor, parameters, angles, classes, links, columns);
}

void
findClasses (const ObstacleClass* classes, std::size_t size, ClassBits& found)
{
  HWY_DYNAMIC_DISPATCH (findClassesHere) (classes, size, found);
}

void
sumCells (FloorSums& columns, std::size_t cell_size, std::size_t cells, FloorSums& sums)
{
  HWY_DYNAMIC_DISPATCH (sumCellsHere) (columns, cell_size, cells, sums);
}

bool
judgeCells (const CellRow& above,
            const CellRow& row,
            const CellRow& below,
            std::size_t cells,
            const CellLimits& limits,
            CellVerdicts& verdicts)
{
  return HWY_DYNAMIC_DISPATCH (judgeCellsHere) (
      above, row, below, cells, limits, verdicts);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
