// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// Vectors of the numbers of neighbouring cells, for the files that are compiled once for
// each set of instructions.

#if defined(PCL_RGBD_PLANES_ROW_VECTORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_RGBD_PLANES_ROW_VECTORS_INL_H
#undef PCL_RGBD_PLANES_ROW_VECTORS_INL_H
#else
#define PCL_RGBD_PLANES_ROW_VECTORS_INL_H
#endif

#include "tangent_rows.h"
#include "vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** A plane counts for points up to this many deviations of depth away from it. */
constexpr float reach_sigmas = 3.f;
/** A plane whose window bends by this angle, in radians, counts half. */
constexpr float half_weight_bend = 0.2f;
constexpr float sharpness = 1.f / (half_weight_bend * half_weight_bend);
/** Points farther are taken for missing ones; their squares still are floats. */
constexpr float farthest_range = 1e15f;

HWY_INLINE void
store (V value, float* to)
{
  hn::StoreU (value, Floats(), to);
}

HWY_INLINE Vectors
operator+ (const Vectors& a, const Vectors& b)
{
  return {hn::Add (a.x, b.x), hn::Add (a.y, b.y), hn::Add (a.z, b.z)};
}

HWY_INLINE Vectors
operator* (const Vectors& a, V factor)
{
  return {hn::Mul (a.x, factor), hn::Mul (a.y, factor), hn::Mul (a.z, factor)};
}

HWY_INLINE Vectors
cross (const Vectors& a, const Vectors& b)
{
  return {hn::NegMulAdd (a.z, b.y, hn::Mul (a.y, b.z)),
          hn::NegMulAdd (a.x, b.z, hn::Mul (a.z, b.x)),
          hn::NegMulAdd (a.y, b.x, hn::Mul (a.x, b.y))};
}

HWY_INLINE Vectors
onlyWhere (Mask mask, const Vectors& a)
{
  return {hn::IfThenElseZero (mask, a.x),
          hn::IfThenElseZero (mask, a.y),
          hn::IfThenElseZero (mask, a.z)};
}

HWY_INLINE Vectors
choose (Mask mask, const Vectors& yes, const Vectors& no)
{
  return {hn::IfThenElse (mask, yes.x, no.x),
          hn::IfThenElse (mask, yes.y, no.y),
          hn::IfThenElse (mask, yes.z, no.z)};
}

/** Three channels as vectors, beginning with channel \a first. */
HWY_INLINE Vectors
load (ChannelRow<float> row, std::size_t first, std::ptrdiff_t at)
{
  return {
      load (row[first] + at), load (row[first + 1] + at), load (row[first + 2] + at)};
}

HWY_INLINE void
store (const Vectors& a, ChannelRow<float> row, std::size_t first, std::size_t at)
{
  store (a.x, row[first] + at);
  store (a.y, row[first + 1] + at);
  store (a.z, row[first + 2] + at);
}

/** Estimates of ARM have 8 bits, those of others 12 and more: after so many steps of Newton's
 * method, 23 bits are right, or nearly so. */
constexpr int newton_steps = HWY_ARCH_ARM ? 2 : 1;

/** 1 / sqrt (\a squared), from an estimate; without vector instructions, where estimates are
 * farther off, it is exact. */
HWY_INLINE V
reciprocalSqrt (V squared)
{
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128
  return hn::Div (set (1.f), hn::Sqrt (squared));
#else
  V root = hn::ApproximateReciprocalSqrt (squared);
  for (int i = 0; i < newton_steps; ++i) {
    const V half = hn::Mul (hn::Mul (squared, root), hn::Mul (root, set (-0.5f)));
    root = hn::Mul (root, hn::Add (half, set (1.5f)));
  }
  return root;
#endif
}

/** 1 / \a value, likewise. */
HWY_INLINE V
reciprocal (V value)
{
  V inverse = hn::ApproximateReciprocal (value);
  for (int i = 0; i < newton_steps; ++i)
    inverse = hn::Mul (inverse, hn::NegMulAdd (value, inverse, set (2.f)));
  return inverse;
}

HWY_INLINE V
sigma (const SensorModel& sensor, V squared_range)
{
  return hn::MulAdd (
      set (sensor.noise.quadratic), squared_range, set (sensor.noise.constant));
}

HWY_INLINE Mask
isPlane (const Vectors& normal)
{
  return hn::Gt (dot (normal, normal), hn::Zero (Floats()));
}

/** Points with their squared ranges. */
struct Points {
  Vectors p;
  V squared_range;
  Mask measured;
};

HWY_INLINE Points
relativePoints (const SensorModel& sensor, V x, V y, V z)
{
  const Vectors absolute{x, y, z};
  const auto& origin = sensor.origin;
  const Vectors p =
      absolute - Vectors{set (origin[0]), set (origin[1]), set (origin[2])};
  const V squared_range = dot (p, p);
  const Mask measured =
      hn::And (hn::Gt (dot (absolute, absolute), hn::Zero (Floats())),
               hn::And (hn::Gt (squared_range, set (DepthNoise::min_squared_range)),
                        hn::Lt (squared_range, set (farthest_range * farthest_range))));
  return {
      onlyWhere (measured, p), hn::IfThenElseZero (measured, squared_range), measured};
}

/** Calls \a use (k, points) with the first (k = 0) and, for step 2, the second (k = 1) points
 * of a vector of cells in a row. */
template <int step, typename Use>
HWY_INLINE void
usePoints (const float* points, const SensorModel& sensor, const Use& use)
{
  constexpr Floats d;
  V x, y, z, rest;
  hn::LoadInterleaved4 (d, points, x, y, z, rest);
  if constexpr (step == 1) {
    use (std::size_t{0}, relativePoints (sensor, x, y, z));
  }
  else {
    V x2, y2, z2;
    hn::LoadInterleaved4 (d, points + 4 * hn::Lanes (d), x2, y2, z2, rest);
#if HWY_TARGET == HWY_SCALAR
    use (std::size_t{0}, relativePoints (sensor, x, y, z));
    use (std::size_t{1}, relativePoints (sensor, x2, y2, z2));
#else
    use (std::size_t{0},
         relativePoints (sensor,
                         hn::ConcatEven (d, x2, x),
                         hn::ConcatEven (d, y2, y),
                         hn::ConcatEven (d, z2, z)));
    use (std::size_t{1},
         relativePoints (sensor,
                         hn::ConcatOdd (d, x2, x),
                         hn::ConcatOdd (d, y2, y),
                         hn::ConcatOdd (d, z2, z)));
#endif
  }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#endif
