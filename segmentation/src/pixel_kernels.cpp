// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pixel_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "plane_vectors-inl.h"
#include <hwy/cache_control.h>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** The points whose sample has a normal that agrees with that of the plane. */
HWY_INLINE Mask
agreeWith (const TilePlane& plane, I samples)
{
  const auto bit = hn::ShiftLeft<31> (hn::Shr (setInts (plane.compatible), samples));
  return hn::MaskFromVec (hn::BitCast (Floats(), hn::ShiftRight<31> (bit)));
}

/** The points, of which each gets one of the planes or none. */
struct Nearest {
  Points points;
  V range;
  I sample;
  /** The smallest number of standard deviations so far, a fraction but for a factor that
   * is the same for all planes: there are no divisions. */
  V numerator, denominator;
  I label;

  HWY_INLINE void
  lookAt (const TilePlane& plane, const PlaneEquation& equation)
  {
    const auto [distance, towards] = rayOffset (equation, points, range);
    const Mask on =
        hn::And (hn::Le (hn::Mul (distance, denominator), hn::Mul (numerator, towards)),
                 agreeWith (plane, sample));
    numerator = hn::IfThenElse (on, distance, numerator);
    denominator = hn::IfThenElse (on, towards, denominator);
    label = hn::IfThenElse (hn::RebindMask (Ints(), on), setInts (plane.number), label);
  }
};

HWY_INLINE bool
isAny (const std::uint32_t* labels, std::size_t size, std::uint32_t label)
{
  for (std::size_t i = 0; i < size; i += hn::Lanes (Floats()))
    if (!hn::AllFalse (Floats(), areLabel (labels + i, label)))
      return true;
  return false;
}

} // namespace

void
loadPixelsHere (const float* first,
                std::size_t stride,
                const std::vector<std::int32_t>& offsets,
                std::size_t run,
                float* x,
                float* y,
                float* z)
{
  const std::size_t lanes = hn::Lanes (Floats());
  constexpr std::size_t cache_line = 16; // floats
  const std::size_t next_tile = 4 * run;
  // In PCL's points, x begins a block of 16 bytes; elsewhere the last one may end with z.
  const bool has_blocks =
      stride == 4 && reinterpret_cast<std::uintptr_t> (first) % 16 == 0;
  if (has_blocks && run % lanes == 0)
    for (std::size_t i = 0; i < offsets.size(); i += lanes) {
      V px, py, pz, unused;
      const float* from = first + 4 * offsets[i];
      for (std::size_t k = 0; k < 4 * lanes; k += cache_line)
        hwy::Prefetch (from + next_tile + k);
      hn::LoadInterleaved4 (Floats(), from, px, py, pz, unused);
      hn::StoreU (px, Floats(), x + i);
      hn::StoreU (py, Floats(), y + i);
      hn::StoreU (pz, Floats(), z + i);
    }
  else // Gathers are slow on some processors.
    for (std::size_t i = 0; i < offsets.size(); ++i) {
      const float* p = first + static_cast<std::ptrdiff_t> (stride) * offsets[i];
      x[i] = p[0];
      y[i] = p[1];
      z[i] = p[2];
    }
}

void
assignPointsHere (const PointBlock& points,
                  const std::int32_t* samples,
                  const TilePlanes& planes,
                  const PlaneEquation* equations,
                  const DepthNoise& tolerance,
                  std::uint32_t* labels)
{
  const V farthest = set (tolerance.maxSquaredRange());
  for (std::size_t i = 0; i < points.size; i += hn::Lanes (Floats())) {
    const Points p = load (points, i);
    const V squared_range = squaredLength (p);
    const Mask measured = isUsable (squared_range, farthest);
    const V range = hn::Sqrt (squared_range);
    Nearest nearest = {p,
                       range,
                       hn::LoadU (Ints(), samples + i),
                       sigmaOf (tolerance, squared_range),
                       range,
                       setInts (unlabelled)};
    for (const TilePlane& plane : planes)
      nearest.lookAt (plane, equations[plane.number]);
    const auto label = hn::IfThenElse (
        hn::RebindMask (Ints(), measured), nearest.label, setInts (unlabelled));
    storeInts (label, labels + i);
  }
}

std::ptrdiff_t
unlabelledInFrontHere (const PointBlock& points,
                       const std::uint32_t* labels,
                       const PlaneEquation& plane,
                       float max_squared_range)
{
  std::ptrdiff_t number = 0;
  for (std::size_t i = 0; i < points.size; i += hn::Lanes (Floats())) {
    const Points p = load (points, i);
    const Mask open = hn::And (isUsable (squaredLength (p), set (max_squared_range)),
                               areLabel (labels + i, unlabelled));
    const Mask in_front = hn::Gt (signedDistance (plane, p), hn::Zero (Floats()));
    const auto count = [] (Mask mask) HWY_ATTR {
      return static_cast<std::ptrdiff_t> (hn::CountTrue (Floats(), mask));
    };
    number += count (hn::And (open, in_front)) - count (hn::AndNot (in_front, open));
  }
  return number;
}

void
leaveFootPointsHere (const PointBlock& points,
                     const std::int32_t* samples,
                     const TilePlane& plane,
                     const PlaneEquation& equation,
                     const DepthNoise& tolerance,
                     std::uint32_t* labels)
{
  for (std::size_t i = 0; i < points.size; i += hn::Lanes (Floats())) {
    const Reach reach = reachOf (load (points, i), tolerance);
    const Mask in_front =
        hn::Gt (signedDistance (equation, reach.points), hn::Zero (Floats()));
    const Mask stays = hn::Or (isWithin (reach, equation),
                               agreeWith (plane, hn::LoadU (Ints(), samples + i)));
    const Mask is_foot =
        hn::And (areLabel (labels + i, plane.number), hn::AndNot (stays, in_front));
    storeInts (hn::IfThenElse (hn::RebindMask (Ints(), is_foot),
                               setInts (unlabelled),
                               loadInts (labels + i)),
               labels + i);
  }
}

std::size_t
sumPointsHere (const PointBlock& points,
               const float* weights,
               const std::uint32_t* labels,
               std::uint32_t label,
               const double* reference,
               double (&sums)[10])
{
  if (!isAny (labels, points.size, label))
    return 0;
  Sums all;
  std::size_t number = 0;
  const Points origin = setPoint (reference);
  for (std::size_t i = 0; i < points.size; i += hn::Lanes (Floats())) {
    const Mask on = areLabel (labels + i, label);
    const Points p = load (points, i) - origin;
    all.add ({hn::IfThenElseZero (on, p.x),
              hn::IfThenElseZero (on, p.y),
              hn::IfThenElseZero (on, p.z)},
             hn::IfThenElseZero (on, load (weights + i)));
    number += hn::CountTrue (Floats(), on);
  }
  totals (all, sums);
  return number;
}

std::size_t
lengthOfRunHere (const std::uint32_t* labels, std::size_t size)
{
  const auto label = setInts (*labels);
  std::size_t i = 0;
  for (; i + hn::Lanes (Ints()) <= size; i += hn::Lanes (Ints())) {
    const auto differs = hn::Not (hn::Eq (loadInts (labels + i), label));
    const auto first = hn::FindFirstTrue (Ints(), differs);
    if (first >= 0)
      return i + static_cast<std::size_t> (first);
  }
  while (i < size && labels[i] == *labels)
    ++i;
  return i;
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (loadPixelsHere);
HWY_EXPORT (assignPointsHere);
HWY_EXPORT (unlabelledInFrontHere);
HWY_EXPORT (leaveFootPointsHere);
HWY_EXPORT (sumPointsHere);
HWY_EXPORT (lengthOfRunHere);

void
loadPixels (const float* first,
            std::size_t stride,
            const std::vector<std::int32_t>& offsets,
            std::size_t run,
            float* x,
            float* y,
            float* z)
{
  HWY_DYNAMIC_DISPATCH (loadPixelsHere) (first, stride, offsets, run, x, y, z);
}

void
assignPoints (const PointBlock& points,
              const std::int32_t* samples,
              const TilePlanes& planes,
              const PlaneEquation* equations,
              const DepthNoise& tolerance,
              std::uint32_t* labels)
{
  HWY_DYNAMIC_DISPATCH (assignPointsHere)
  (points, samples, planes, equations, tolerance, labels);
}

std::ptrdiff_t
unlabelledInFront (const PointBlock& points,
                   const std::uint32_t* labels,
                   const PlaneEquation& plane,
                   float max_squared_range)
{
  return HWY_DYNAMIC_DISPATCH (unlabelledInFrontHere) (
      points, labels, plane, max_squared_range);
}

void
leaveFootPoints (const PointBlock& points,
                 const std::int32_t* samples,
                 const TilePlane& plane,
                 const PlaneEquation& equation,
                 const DepthNoise& tolerance,
                 std::uint32_t* labels)
{
  HWY_DYNAMIC_DISPATCH (leaveFootPointsHere)
  (points, samples, plane, equation, tolerance, labels);
}

std::size_t
sumPoints (const PointBlock& points,
           const float* weights,
           const std::uint32_t* labels,
           std::uint32_t label,
           const double* reference,
           double (&sums)[10])
{
  return HWY_DYNAMIC_DISPATCH (sumPointsHere) (
      points, weights, labels, label, reference, sums);
}

std::size_t
lengthOfRun (const std::uint32_t* labels, std::size_t size)
{
  return HWY_DYNAMIC_DISPATCH (lengthOfRunHere) (labels, size);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
