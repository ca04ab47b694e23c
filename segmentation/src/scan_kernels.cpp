// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scan_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "mask_bits-inl.h"
#include "scan_kernels.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {

namespace {

/** Points in the base frame. */
struct BasePoints {
  V x, y, z;
};

HWY_INLINE V
valueAt (const Eigen::Vector4f& plane, const Points& p)
{
  return hn::Add (dot (PlaneEquation{plane[0], plane[1], plane[2], 0.f}, p),
                  set (plane[3]));
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
  const Eigen::Matrix4f m = camera_to_base.matrix();
  const V nearest = set (limits.range_min * limits.range_min);
  const V farthest = set (limits.range_max * limits.range_max);
  for (const ScanRun& run : runs) {
    V smallest = set (std::numeric_limits<float>::infinity());
    const V begin = set (static_cast<float> (run.begin)),
            end = set (static_cast<float> (run.end));
    for (std::size_t i = run.begin / PointRow::block_size * PointRow::block_size;
         i < run.end;
         i += hn::Lanes (Floats())) {
      const Points p = load (row, static_cast<std::ptrdiff_t> (i));
      V x = valueAt (m.row (0), p), y = valueAt (m.row (1), p),
        z = valueAt (m.row (2), p);
      if (run.are_below_floor) {
        const V depth = set (floor[3]);
        const V scale = hn::Div (depth, hn::Sub (depth, valueAt (floor, p)));
        x = hn::MulAdd (scale, hn::Sub (x, set (m (0, 3))), set (m (0, 3)));
        y = hn::MulAdd (scale, hn::Sub (y, set (m (1, 3))), set (m (1, 3)));
        z = hn::MulAdd (scale, hn::Sub (z, set (m (2, 3))), set (m (2, 3)));
      }
      const V square = hn::MulAdd (x, x, hn::Mul (y, y));
      const V column = hn::Iota (Floats(), static_cast<float> (i));
      const Mask is_inside = hn::And (hn::Ge (column, begin), hn::Lt (column, end));
      smallest = hn::IfThenElse (
          hn::And (is_inside, hn::Lt (square, smallest)), square, smallest);

      const Mask is_in_range =
          hn::And (hn::And (hn::Ge (square, nearest), hn::Le (square, farthest)),
                   hn::And (hn::Gt (square, hn::Zero (Floats())),
                            hn::Le (z, set (limits.max_height))));
      const Mask counts = hn::And (is_inside, is_in_range);
      const auto isLeftOf = [&] (const float* border_x, const float* border_y) {
        return hn::Ge (hn::Mul (load (border_x), y), hn::Mul (load (border_y), x));
      };
      const Mask is_in_sector =
          hn::AndNot (isLeftOf (&columns.left_x[i], &columns.left_y[i]),
                      isLeftOf (&columns.right_x[i], &columns.right_y[i]));
      const V closest = load (&columns.squares[i]);
      const Mask is_closer =
          hn::And (hn::And (counts, is_in_sector), hn::Lt (square, closest));
      hn::StoreU (
          hn::IfThenElse (is_closer, square, closest), Floats(), &columns.squares[i]);
      const Mask is_stray = hn::AndNot (is_in_sector, counts);
      if (!hn::AllFalse (Floats(), is_stray)) {
        columns.strays[i / bits_in_word] |= bitsOf (Floats(), is_stray)
                                            << i % bits_in_word;
        hn::BlendedStore (x, is_stray, Floats(), &columns.x[i]);
        hn::BlendedStore (y, is_stray, Floats(), &columns.y[i]);
      }
    }
    *run.nearest_square = hn::GetLane (hn::MinOfLanes (Floats(), smallest));
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
