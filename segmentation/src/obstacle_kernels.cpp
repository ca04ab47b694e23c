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

HWY_INLINE hn::Vec<Ints>
intOf (Mask mask, int value)
{
  return hn::IfThenElseZero (hn::RebindMask (Ints(), mask), hn::Set (Ints(), value));
}

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
  const hn::Rebind<std::uint8_t, Floats> bytes;
  const DepthNoise& noise = parameters.noise;
  const V one = set (1.f), largest = set (std::numeric_limits<float>::max());
  const V farthest = set (noise.max_range * noise.max_range);
  for (std::size_t i = 0; i < row.size(); i += hn::Lanes (Floats())) {
    const Points p = load (row, static_cast<std::ptrdiff_t> (i));
    const V height =
        hn::Add (dot ({floor[0], floor[1], floor[2], 0.f}, p), set (floor[3]));
    const V squared_range = squaredLength (p);
    const V sigma = hn::Mul (
        set (floor[3]),
        hn::MulAdd (squared_range, set (noise.quadratic), set (noise.constant)));
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
    hn::StoreU (hn::DemoteTo (bytes, what), bytes, &result.what[i]);
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
             float* const (&moved)[3])
{
  const Eigen::Matrix4f m = transform.matrix();
  for (std::size_t i = 0; i < row.size(); i += hn::Lanes (Floats())) {
    const Points p = load (row, static_cast<std::ptrdiff_t> (i));
    for (int k = 0; k < 3; ++k) {
      const V turned = dot ({m (k, 0), m (k, 1), m (k, 2), 0.f}, p);
      hn::StoreU (hn::Add (turned, set (m (k, 3))), Floats(), moved[k] + i);
    }
  }
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (classifyRowHere);
HWY_EXPORT (moveRowHere);

void
classifyRow (const PointRow& row,
             const Eigen::Vector4f& floor,
             const ObstaclePointParameters& parameters,
             ObstacleRow& result)
{
  HWY_DYNAMIC_DISPATCH (classifyRowHere) (row, floor, parameters, result);
}

void
moveRow (const PointRow& row,
         const Eigen::Affine3f& transform,
         float* const (&moved)[3])
{
  HWY_DYNAMIC_DISPATCH (moveRowHere) (row, transform, moved);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
