// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "obstacle_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "obstacle_kernels.h"
#include "plane_vectors-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE void
add (V value, float* sum)
{
  hn::StoreU (hn::Add (load (sum), value), Floats(), sum);
}

} // namespace

void
classifyRowHere (const PointRow& row,
                 const Eigen::Vector4f& floor,
                 const ObstaclePointParameters& parameters,
                 ObstacleRow& result)
{
  const DepthNoise& noise = parameters.noise;
  const V one = set (1.f), largest = set (std::numeric_limits<float>::max());
  const V farthest = set (noise.max_range * noise.max_range);
  for (std::size_t i = 0; i < row.size(); i += hn::Lanes (Floats())) {
    const Points p = load (row, static_cast<std::ptrdiff_t> (i));
    const V height = hn::Add (dot (PlaneEquation{floor[0], floor[1], floor[2], 0.f}, p),
                              set (floor[3]));
    const V squared_range = squaredLength (p);
    const V sigma = hn::Mul (set (floor[3]), sigmaOf (noise, squared_range));
    const V variance = hn::Div (hn::Mul (sigma, sigma), squared_range);
    const Mask is_measured =
        hn::And (hn::Le (squared_range, farthest), hn::Le (variance, largest));
    const V squared_height = hn::Mul (height, height);
    const auto exceeds = [&] (float sigmas) {
      return hn::And (
          is_measured,
          hn::Gt (squared_height, hn::Mul (set (sigmas * sigmas), variance)));
    };
    const Mask is_obstacle =
        hn::And (exceeds (point_sigmas), hn::Gt (height, set (parameters.min_height)));
    const Mask is_drop_off =
        hn::And (exceeds (drop_sigmas), hn::Lt (height, set (-parameters.min_drop)));
    const Mask may_be_floor =
        hn::AndNot (hn::Or (is_obstacle, is_drop_off), is_measured);
    const Mask is_high =
        hn::And (hn::And (may_be_floor, exceeds (0.5f * window_sigmas)),
                 hn::Gt (height, set (0.25f * parameters.min_height)));
    const auto what = hn::Add (hn::Add (intOf (is_measured, 1), intOf (is_obstacle, 1)),
                               intOf (is_drop_off, 2));
    storeBytes (what, &result.what[i]);
    hn::StoreU (height, Floats(), &result.height[i]);
    hn::StoreU (variance, Floats(), &result.variance[i]);
    add (hn::IfThenElseZero (may_be_floor, height), &result.height_sum[i]);
    add (hn::IfThenElseZero (may_be_floor, variance), &result.variance_sum[i]);
    add (hn::IfThenElseZero (may_be_floor, one), &result.points[i]);
    add (hn::IfThenElseZero (is_high, one), &result.high[i]);
  }
}

void
moveRowHere (const PointRow& row,
             const Eigen::Affine3f& transform,
             float* x,
             float* y,
             float* z,
             float* squares)
{
  const Eigen::Matrix4f m = transform.matrix();
  for (std::size_t i = 0; i < row.size(); i += hn::Lanes (Floats())) {
    const Points p = load (row, static_cast<std::ptrdiff_t> (i));
    const auto coordinate = [&] (int k) {
      return hn::Add (dot (PlaneEquation{m (k, 0), m (k, 1), m (k, 2), 0.f}, p),
                      set (m (k, 3)));
    };
    const V new_x = coordinate (0), new_y = coordinate (1);
    hn::StoreU (new_x, Floats(), x + i);
    hn::StoreU (new_y, Floats(), y + i);
    hn::StoreU (coordinate (2), Floats(), z + i);
    hn::StoreU (
        hn::MulAdd (new_x, new_x, hn::Mul (new_y, new_y)), Floats(), squares + i);
  }
}

float
minimumHere (const float* values, std::size_t count)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const std::size_t lanes = hn::Lanes (Floats());
  V smallest = set (infinity);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    const V value = load (values + i);
    smallest = hn::IfThenElse (hn::Lt (value, smallest), value, smallest);
  }
  float result = hn::GetLane (hn::MinOfLanes (Floats(), smallest));
  for (; i < count; ++i)
    result = values[i] < result ? values[i] : result;
  return result;
}

bool
scanRowHere (const float* x,
             const float* y,
             const float* z,
             std::size_t size,
             const ScanLimits& limits,
             ScanColumns& columns)
{
  const V nearest = set (limits.range_min * limits.range_min);
  const V farthest = set (limits.range_max * limits.range_max);
  Mask any_stray = hn::MaskFromVec (hn::Zero (Floats()));
  for (std::size_t i = 0; i < size; i += hn::Lanes (Floats())) {
    const V px = load (x + i), py = load (y + i);
    const V square = hn::MulAdd (px, px, hn::Mul (py, py));
    const Mask is_in_range =
        hn::And (hn::And (hn::Ge (square, nearest), hn::Le (square, farthest)),
                 hn::And (hn::Gt (square, hn::Zero (Floats())),
                          hn::Le (load (z + i), set (limits.max_height))));
    const auto isLeftOf = [&] (const float* border_x, const float* border_y) {
      return hn::Ge (hn::Mul (load (border_x), py), hn::Mul (load (border_y), px));
    };
    const Mask is_in_sector =
        hn::AndNot (isLeftOf (&columns.left_x[i], &columns.left_y[i]),
                    isLeftOf (&columns.right_x[i], &columns.right_y[i]));
    const V closest = load (&columns.squares[i]);
    const Mask is_closer =
        hn::And (hn::And (is_in_range, is_in_sector), hn::Lt (square, closest));
    hn::StoreU (
        hn::IfThenElse (is_closer, square, closest), Floats(), &columns.squares[i]);
    const Mask is_stray = hn::AndNot (is_in_sector, is_in_range);
    any_stray = hn::Or (any_stray, is_stray);
    storeBytes (intOf (is_stray, 1), &columns.strays[i]);
  }
  return !hn::AllFalse (Floats(), any_stray);
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (classifyRowHere);
HWY_EXPORT (minimumHere);
HWY_EXPORT (moveRowHere);
HWY_EXPORT (scanRowHere);

void
classifyRow (const PointRow& row,
             const Eigen::Vector4f& floor,
             const ObstaclePointParameters& parameters,
             ObstacleRow& result)
{
  HWY_DYNAMIC_DISPATCH (classifyRowHere) (row, floor, parameters, result);
}

float
minimum (const float* values, std::size_t count)
{
  return HWY_DYNAMIC_DISPATCH (minimumHere) (values, count);
}

void
moveRow (const PointRow& row,
         const Eigen::Affine3f& transform,
         float* x,
         float* y,
         float* z,
         float* squares)
{
  HWY_DYNAMIC_DISPATCH (moveRowHere) (row, transform, x, y, z, squares);
}

bool
scanRow (const float* x,
         const float* y,
         const float* z,
         std::size_t size,
         const ScanLimits& limits,
         ScanColumns& columns)
{
  return HWY_DYNAMIC_DISPATCH (scanRowHere) (x, y, z, size, limits, columns);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
