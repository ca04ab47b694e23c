// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// Vectors of PlaneSamples, for the files that are compiled once for each set of instructions.

#if defined(PCL_RGBD_PLANES_SAMPLE_VECTORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_RGBD_PLANES_SAMPLE_VECTORS_INL_H
#undef PCL_RGBD_PLANES_SAMPLE_VECTORS_INL_H
#else
#define PCL_RGBD_PLANES_SAMPLE_VECTORS_INL_H
#endif

#include "plane_vectors-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** Calls \a body (i) for the first sample of each vector in the tile that begins with
 * sample \a begin. */
template <typename Body>
HWY_INLINE void
forEachVectorFrom (std::size_t begin, const Body& body)
{
  for (std::size_t lane = 0; lane < PlaneSamples::tile_size;
       lane += hn::Lanes (Floats()))
    body (begin + lane);
}

/** The same for all \a tiles. */
template <typename Body>
HWY_INLINE void
forEachVector (const std::vector<std::uint32_t>& tiles, const Body& body)
{
  for (const std::uint32_t tile : tiles)
    forEachVectorFrom (tile * PlaneSamples::tile_size, body);
}

HWY_INLINE Points
pointsAt (const PlaneSamples& samples, std::size_t i)
{
  return {load (&samples.x[i]), load (&samples.y[i]), load (&samples.z[i])};
}

HWY_INLINE Points
normalsAt (const PlaneSamples& samples, std::size_t i)
{
  return {load (&samples.normal_x[i]),
          load (&samples.normal_y[i]),
          load (&samples.normal_z[i])};
}

HWY_INLINE Mask
isTrusted (const PlaneSamples& samples, std::size_t i)
{
  return hn::Ge (load (&samples.min_cosine[i]), hn::Zero (Floats()));
}

HWY_INLINE unsigned
bitsOf (Mask mask)
{
  return static_cast<unsigned> (bitsOf (Floats(), mask));
}

/** By how many degrees a normal may at most differ from that of its plane. */
constexpr float largest_angle = 60.f;

/** The cosine of an angle, or of the largest one. */
HWY_INLINE V
cosineOf (V degrees)
{
  const V angle = hn::Mul (hn::Min (degrees, set (largest_angle)),
                           set (static_cast<float> (M_PI / 180.)));
  const V square = hn::Mul (angle, angle);
  V series = hn::NegMulAdd (square, set (1.f / 720.f), set (1.f / 24.f));
  series = hn::NegMulAdd (square, series, set (1.f / 2.f));
  return hn::NegMulAdd (square, series, set (1.f));
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#endif
