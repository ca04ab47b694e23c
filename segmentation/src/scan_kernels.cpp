// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scan_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "plane_vectors-inl.h"
#include "row_bits.h"
#include "scan_kernels.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {

namespace {

/** From the camera frame to the base frame. */
struct Motion {
  /** Rows of the matrix. */
  Eigen::Vector4f to_x, to_y, to_z;
  Eigen::Vector4f floor;

  static HWY_INLINE V
  valueAt (const Eigen::Vector4f& plane, const Points& p)
  {
    return signedDistance ({plane[0], plane[1], plane[2], plane[3]}, p);
  }

  HWY_INLINE Points
  operator() (const Points& p) const
  {
    return {valueAt (to_x, p), valueAt (to_y, p), valueAt (to_z, p)};
  }

  /** Where the rays meet the floor. */
  HWY_INLINE Points
  onFloor (const Points& p) const
  {
    const V camera_height = set (floor[3]);
    const V scale =
        hn::Div (camera_height, hn::Sub (camera_height, valueAt (floor, p)));
    return (*this) ({hn::Mul (scale, p.x), hn::Mul (scale, p.y), hn::Mul (scale, p.z)});
  }
};

/** The points of a vector that are between the borders of the sectors of their columns. */
HWY_INLINE Mask
areInSectors (const Points& p, const ScanColumns& columns, std::size_t i)
{
  const auto areLeftOf = [&] (const float* border_x, const float* border_y) {
    return hn::Ge (hn::Mul (load (border_x), p.y), hn::Mul (load (border_y), p.x));
  };
  return hn::AndNot (areLeftOf (&columns.left_x[i], &columns.left_y[i]),
                     areLeftOf (&columns.right_x[i], &columns.right_y[i]));
}

} // namespace

void
scanRunsHere (const PointRow& row,
              const Eigen::Affine3f& camera_to_base,
              const Eigen::Vector4f& floor,
              const ScanLimits& limits,
              const std::vector<ScanRun>& runs,
              ScanColumns& columns)
{
  const auto& m = camera_to_base.matrix();
  const Motion move{m.row (0), m.row (1), m.row (2), floor};
  // In (0, 0), points have no direction.
  const V nearest = set (std::numeric_limits<float>::min());
  const V farthest = set (limits.range_max * limits.range_max);
  const V max_height = set (limits.max_height);
  for (const ScanRun& run : runs) {
    const V begin = set (static_cast<float> (run.begin));
    const V end = set (static_cast<float> (run.end));
    const V infinity = set (std::numeric_limits<float>::infinity());
    V smallest = infinity, lowest = infinity, highest = hn::Neg (infinity);
    std::size_t i = run.begin / PointRow::block_size * PointRow::block_size;
    for (; i < run.end; i += hn::Lanes (Floats())) {
      const Points from = load (row, static_cast<std::ptrdiff_t> (i));
      const Points p = run.are_below_floor ? move.onFloor (from) : move (from);
      const V column = hn::Iota (Floats(), static_cast<float> (i));
      const Mask is_inside = hn::And (hn::Ge (column, begin), hn::Lt (column, end));
      const V square = hn::IfThenElse (
          is_inside, hn::MulAdd (p.x, p.x, hn::Mul (p.y, p.y)), hn::NaN (Floats()));
      smallest = hn::IfThenElse (hn::Lt (square, smallest), square, smallest);
      const V z = run.are_below_floor ? move (from).z : p.z;
      lowest = hn::IfThenElse (hn::And (is_inside, hn::Lt (z, lowest)), z, lowest);
      highest = hn::IfThenElse (hn::And (is_inside, hn::Gt (z, highest)), z, highest);

      const Mask is_in_range =
          hn::And (hn::And (hn::Ge (square, nearest), hn::Le (square, farthest)),
                   hn::Le (p.z, max_height));
      columns.in_range[i / bits_in_word] |= bitsOf (Floats(), is_in_range)
                                            << i % bits_in_word;
      const Mask is_in_sector = areInSectors (p, columns, i);
      const V closest = load (&columns.squares[i]);
      const Mask is_closer =
          hn::And (hn::And (is_in_range, is_in_sector), hn::Lt (square, closest));
      hn::StoreU (
          hn::IfThenElse (is_closer, square, closest), Floats(), &columns.squares[i]);
      const Mask is_stray = hn::AndNot (is_in_sector, is_in_range);
      if (hn::AllFalse (Floats(), is_stray))
        continue;
      columns.strays[i / bits_in_word] |= bitsOf (Floats(), is_stray)
                                          << i % bits_in_word;
      hn::BlendedStore (p.x, is_stray, Floats(), &columns.x[i]);
      hn::BlendedStore (p.y, is_stray, Floats(), &columns.y[i]);
    }
    *run.extent = {hn::GetLane (hn::MinOfLanes (Floats(), smallest)),
                   hn::GetLane (hn::MinOfLanes (Floats(), lowest)),
                   hn::GetLane (hn::MaxOfLanes (Floats(), highest))};
  }
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (scanRunsHere);

void
scanRuns (const PointRow& row,
          const Eigen::Affine3f& camera_to_base,
          const Eigen::Vector4f& floor,
          const ScanLimits& limits,
          const std::vector<ScanRun>& runs,
          ScanColumns& columns)
{
  HWY_DYNAMIC_DISPATCH (scanRunsHere)
  (row, camera_to_base, floor, limits, runs, columns);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
