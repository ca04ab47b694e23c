// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// Vectors of points, for the files that are compiled once for each set of instructions.

#if defined(PCL_RGBD_PLANES_PLANE_VECTORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_RGBD_PLANES_PLANE_VECTORS_INL_H
#undef PCL_RGBD_PLANES_PLANE_VECTORS_INL_H
#else
#define PCL_RGBD_PLANES_PLANE_VECTORS_INL_H
#endif

#include "plane_kernels.h"
#include "vectors-inl.h"

#include <pcl/segmentation/impl/point_row.h>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

static_assert (PlaneSamples::tile_size % RowRing<float>::lanes == 0 &&
                   PointRow::block_size % RowRing<float>::lanes == 0,
               "tiles and blocks are whole vectors");

using Points = Vectors;

HWY_INLINE Points
load (const PointRow& row, std::ptrdiff_t i)
{
  return {load (row.x() + i), load (row.y() + i), load (row.z() + i)};
}

HWY_INLINE Points
load (const PointBlock& points, std::size_t i)
{
  return {load (points.x + i), load (points.y + i), load (points.z + i)};
}

/** Whether points at this range are measurements, and no farther than the sensor is worth using. */
HWY_INLINE Mask
isUsable (V squared_range, V farthest)
{
  return hn::And (hn::Gt (squared_range, set (DepthNoise::min_squared_range)),
                  hn::Le (squared_range, farthest));
}

HWY_INLINE I
setInts (std::uint32_t value)
{
  return hn::Set (Ints(), static_cast<std::int32_t> (value));
}

HWY_INLINE I
loadInts (const std::uint32_t* from)
{
  return hn::BitCast (Ints(), hn::LoadU (hn::RebindToUnsigned<Floats>(), from));
}

HWY_INLINE void
storeInts (I values, std::uint32_t* to)
{
  const hn::RebindToUnsigned<Floats> numbers;
  hn::StoreU (hn::BitCast (numbers, values), numbers, to);
}

/** The labels that are \a label. */
HWY_INLINE Mask
areLabel (const std::uint32_t* labels, std::uint32_t label)
{
  return hn::RebindMask (Floats(), hn::Eq (loadInts (labels), setInts (label)));
}

/** The same point in all lanes. */
HWY_INLINE Points
setPoint (const double* xyz)
{
  return {set (static_cast<float> (xyz[0])),
          set (static_cast<float> (xyz[1])),
          set (static_cast<float> (xyz[2]))};
}

HWY_INLINE V
dot (const PlaneEquation& plane, const Points& p)
{
  return hn::MulAdd (set (plane.x),
                     p.x,
                     hn::MulAdd (set (plane.y), p.y, hn::Mul (set (plane.z), p.z)));
}

/** How far points are in front of a plane; negative behind it. */
HWY_INLINE V
signedDistance (const PlaneEquation& plane, const Points& p)
{
  return hn::Add (dot (plane, p), set (plane.d));
}

HWY_INLINE V
squaredLength (const Points& p)
{
  return dot (p, p);
}

/** As DepthNoise::sigma(). */
HWY_INLINE V
sigmaOf (const DepthNoise& noise, V squared_range)
{
  return hn::MulAdd (squared_range, set (noise.quadratic), set (noise.constant));
}

/** How far points are off a plane along their viewing rays, relative to their range:
 * \a distance over \a towards. */
struct RayOffset {
  V distance, towards;
};

HWY_INLINE RayOffset
rayOffset (const PlaneEquation& plane, const Points& p, V range)
{
  return {hn::Abs (signedDistance (plane, p)),
          hn::Max (set (plane.d), hn::Mul (range, set (min_view_cosine)))};
}

/** Points, and how far along their viewing rays they may be off a plane that they lie on. */
struct Reach {
  Points points;
  V squared_range, range, limit;
};

HWY_INLINE Reach
reachOf (const Points& points, const DepthNoise& tolerance)
{
  const V squared_range = squaredLength (points);
  return {points,
          squared_range,
          hn::Sqrt (squared_range),
          sigmaOf (tolerance, squared_range)};
}

/** The points that are off a plane by no more than \a share of their reach. */
HWY_INLINE Mask
isWithin (const Reach& reach, const PlaneEquation& plane, float share = 1.f)
{
  const auto [distance, towards] = rayOffset (plane, reach.points, reach.range);
  return hn::Le (hn::Mul (distance, reach.range),
                 hn::Mul (hn::Mul (set (share), reach.limit), towards));
}

/** A bit for each lane of a mask. */
template <typename D>
HWY_INLINE std::uint64_t
bitsOf (D d, hn::Mask<D> mask)
{
  std::uint64_t bits = 0; // as many bytes as StoreMaskBits may write
  hn::StoreMaskBits (d, mask, reinterpret_cast<std::uint8_t*> (&bits));
  return bits;
}

HWY_INLINE I
intOf (Mask mask, int value)
{
  return hn::IfThenElseZero (hn::RebindMask (Ints(), mask), hn::Set (Ints(), value));
}

HWY_INLINE void
storeBytes (I values, std::uint8_t* to)
{
  const hn::Rebind<std::uint8_t, Floats> bytes;
  hn::StoreU (hn::DemoteTo (bytes, values), bytes, to);
}

/** Weighted sums of points, of their coordinates and products. */
struct Sums {
  V values[10];

  Sums()
  {
    // Else they are cleared, and stay, in memory.
#pragma GCC unroll 10
    for (V& value : values)
      value = hn::Zero (Floats());
  }

  HWY_INLINE void
  add (const Points& p, V weight)
  {
    const V x = hn::Mul (weight, p.x), y = hn::Mul (weight, p.y),
            z = hn::Mul (weight, p.z);
    values[0] = hn::Add (values[0], weight);
    values[1] = hn::Add (values[1], x);
    values[2] = hn::Add (values[2], y);
    values[3] = hn::Add (values[3], z);
    values[4] = hn::MulAdd (x, p.x, values[4]);
    values[5] = hn::MulAdd (x, p.y, values[5]);
    values[6] = hn::MulAdd (x, p.z, values[6]);
    values[7] = hn::MulAdd (y, p.y, values[7]);
    values[8] = hn::MulAdd (y, p.z, values[8]);
    values[9] = hn::MulAdd (z, p.z, values[9]);
  }
};

HWY_INLINE void
totals (const Sums& sums, double* results)
{
#pragma GCC unroll 10
  for (std::size_t k = 0; k < 10; ++k)
    results[k] = total (sums.values[k]);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#endif
