// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plane_means.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "normal_vectors-inl.h"
#include "row_vectors-inl.h"
#include <hwy/cache_control.h>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** A point up to this many deviations away from the plane of its cell keeps it. */
constexpr float own_sigmas = 2.f;
/** Planes whose weighted normals add up to less count for nothing. */
constexpr float min_squared_sum = 1e-20f;

/** Adds to \a sum the weighted normals of candidates \a first and following: those that bend
 * little count, and those on which \a p lies, with Tukey's biweight of its distance times
 * \a reach. */
template <std::size_t first, std::size_t number>
HWY_INLINE Vectors
addNormals (const Candidates<number>& candidates,
            std::ptrdiff_t at,
            const Vectors& p,
            V reach,
            Vectors sum)
{
  // The rows have the same one, which takes fewer registers.
  const std::size_t stride = candidates[0].stride();
#pragma GCC unroll 9
  for (std::size_t k = first; k < number; ++k) {
    const float* x = candidates[k][plane_x] + at;
    const float* distance = x + plane_distance * stride;
    const Vectors n = {load (x), load (x + stride), load (x + 2 * stride)};
    const V off = hn::MulAdd (
        n.x, p.x, hn::MulAdd (n.y, p.y, hn::MulSub (n.z, p.z, load (distance))));
    const V deviation = hn::Mul (off, reach);
    const V root =
        hn::Max (hn::NegMulAdd (deviation, deviation, set (1.f)), hn::Zero (Floats()));
    const V weight = hn::Mul (load (distance + stride), hn::Mul (root, root));
    sum = {hn::MulAdd (n.x, weight, sum.x),
           hn::MulAdd (n.y, weight, sum.y),
           hn::MulAdd (n.z, weight, sum.z)};
  }
  return sum;
}

/** The smallest eigenvalue over the sum of all (section 3) of a square patch
 * z = k x^2 / 2 whose halves bend as much as those of a window whose plane has \a weight. */
HWY_INLINE V
curvatureOf (V weight)
{
  const V squared_bend =
      hn::Mul (hn::Sub (reciprocal (weight), set (1.f)), set (1.f / sharpness));
  // Not a number where the weight is 0.
  const V curvature = hn::Mul (squared_bend, set (1.f / 30.f));
  const V limited = hn::Max (hn::Min (curvature, set (1.f / 3.f)), hn::Zero (Floats()));
  return hn::IfThenElse (
      hn::Gt (weight, hn::Zero (Floats())), limited, set (1.f / 3.f));
}

/** Begins to fetch where normals of the next row go. */
HWY_INLINE void
prefetch (const float* first, std::size_t number)
{
  for (std::size_t line = 0; line < number * normal_floats; line += 16)
    hwy::Prefetch (first + line);
}

std::size_t
writeCellNormalsOf (std::size_t cells, const PlaneRow& planes, float* normals)
{
  constexpr Floats d;
  std::size_t valid = 0;
  for (std::size_t at = 0; at < cells; at += hn::Lanes (d)) {
    const auto i = static_cast<std::ptrdiff_t> (at);
    float* here = normals + normal_floats * at;
    prefetch (here + normal_floats * cells, hn::Lanes (d));
    const Vectors n = load (planes, plane_x, i);
    const Mask is_valid = isPlane (n);
    spread (onlyValid (is_valid, n, curvatureOf (load (planes[plane_weight] + i))),
            here,
            4 * normal_floats);
    valid += hn::CountTrue (d, is_valid);
  }
  return valid;
}

std::size_t
writePixelNormalsOf (const float* points,
                     std::size_t cells,
                     const SensorModel& sensor,
                     const PlaneRow& planes,
                     const Candidates<9>* candidates,
                     float* normals)
{
  constexpr Floats d;
  std::size_t valid = 0;
  for (std::size_t at = 0; at < cells; at += hn::Lanes (d)) {
    const auto i = static_cast<std::ptrdiff_t> (at);
    float* here = normals + 2 * normal_floats * at;
    prefetch (here + 2 * normal_floats * cells, 2 * hn::Lanes (d));
    const Vectors own = load (planes, plane_x, i);
    const V distance = load (planes[plane_distance] + i);
    const V curvature = curvatureOf (load (planes[plane_weight] + i));
    NormalVectors pair[] = {{own, curvature}, {own, curvature}};
    usePoints<2> (
        points + 8 * at, sensor, [&] (std::size_t k, const Points& point) HWY_ATTR {
          Vectors n = own;
          const V deviation = sigma (sensor, point.squared_range);
          const V off = hn::Abs (hn::Sub (dot (n, point.p), distance));
          const Mask lies_off = hn::And (
              point.measured, hn::Gt (off, hn::Mul (set (own_sigmas), deviation)));
          if (candidates && !hn::AllFalse (d, lies_off)) {
            const V reach = hn::Div (set (1.f / reach_sigmas), deviation);
            const V zero = hn::Zero (d);
            const Vectors sum =
                addNormals<0> (*candidates, i, point.p, reach, {zero, zero, zero});
            const V squared_length = dot (sum, sum);
            const Mask is_mean =
                hn::And (lies_off, hn::Gt (squared_length, set (min_squared_sum)));
            n = choose (is_mean, sum * reciprocalSqrt (squared_length), n);
          }
          const Mask is_valid = hn::And (point.measured, isPlane (n));
          pair[k] = onlyValid (is_valid, n, curvature);
          valid += hn::CountTrue (d, is_valid);
        });
    spreadPairs (pair[0], pair[1], here);
  }
  return valid;
}

HWY_INLINE void
averagePlanesOf (const Candidates<5>& candidates,
                 std::size_t cells,
                 CellRow points,
                 PlaneRow planes)
{
  constexpr Floats d;
  const PlaneRow own = candidates[0];
  for (std::size_t at = 0; at < cells; at += hn::Lanes (d)) {
    const auto i = static_cast<std::ptrdiff_t> (at);
    const Vectors p = load (points, cell_x, i);
    const V reach = load (points[cell_reach] + i);
    const Vectors own_normal = load (own, plane_x, i);
    const V weight = load (own[plane_weight] + i);
    // The point lies on its own plane.
    const Vectors sum = addNormals<1> (candidates, i, p, reach, own_normal * weight);
    const V squared_length = dot (sum, sum);
    const Mask is_mean = hn::And (hn::Gt (reach, hn::Zero (d)),
                                  hn::Gt (squared_length, set (min_squared_sum)));
    const Vectors n =
        choose (is_mean, sum * reciprocalSqrt (squared_length), own_normal);
    store (n, planes, plane_x, at);
    store (dot (n, p), planes[plane_distance] + i);
    store (weight, planes[plane_weight] + i);
  }
}

} // namespace

void
averagePlanesHere (const Candidates<5>& candidates,
                   std::size_t cells,
                   const CellRow& points,
                   const PlaneRow& planes)
{
  averagePlanesOf (candidates, cells, points, planes);
}

std::size_t
writeNormalsHere (const float* points,
                  std::size_t cells,
                  int step,
                  const SensorModel& sensor,
                  const PlaneRow& planes,
                  const Candidates<9>* candidates,
                  float* normals)
{
  if (step == 1)
    return writeCellNormalsOf (cells, planes, normals);
  return writePixelNormalsOf (points, cells, sensor, planes, candidates, normals);
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (averagePlanesHere);
HWY_EXPORT (writeNormalsHere);

void
averagePlanes (const Candidates<5>& candidates,
               std::size_t cells,
               const CellRow& points,
               const PlaneRow& planes)
{
  HWY_DYNAMIC_DISPATCH (averagePlanesHere) (candidates, cells, points, planes);
}

std::size_t
writeNormals (const float* points,
              std::size_t cells,
              int step,
              const SensorModel& sensor,
              const PlaneRow& planes,
              const Candidates<9>* candidates,
              float* normals)
{
  return HWY_DYNAMIC_DISPATCH (writeNormalsHere) (
      points, cells, step, sensor, planes, candidates, normals);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
