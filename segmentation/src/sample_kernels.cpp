// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sample_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
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

HWY_INLINE Points
relativePoints (const PlaneSamples& samples,
                std::size_t i,
                const double (&reference)[3])
{
  return difference (pointsAt (samples, i),
                     {set (static_cast<float> (reference[0])),
                      set (static_cast<float> (reference[1])),
                      set (static_cast<float> (reference[2]))});
}

HWY_INLINE unsigned
bitsOf (Mask mask)
{
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits (Floats(), mask, bytes);
  return bytes[0] | static_cast<unsigned> (bytes[1]) << 8;
}

/** By how many degrees a normal may differ from that of its plane: 10, and 6 more with
 * each metre, as depth noise tilts far normals. */
constexpr float angle_at_sensor = 10.f, angle_per_metre = 6.f, largest_angle = 60.f;

/** The cosine of this angle. */
HWY_INLINE V
minCosine (V range)
{
  const V degrees =
      hn::Min (hn::MulAdd (range, set (angle_per_metre), set (angle_at_sensor)),
               set (largest_angle));
  const V angle = hn::Mul (degrees, set (static_cast<float> (M_PI / 180.)));
  const V square = hn::Mul (angle, angle);
  V series = hn::NegMulAdd (square, set (1.f / 720.f), set (1.f / 24.f));
  series = hn::NegMulAdd (square, series, set (1.f / 2.f));
  return hn::NegMulAdd (square, series, set (1.f));
}

} // namespace

void
fillUncertaintiesHere (PlaneSamples& samples, const DepthNoise& noise)
{
  const V none = set (-1.f);
  for (std::size_t i = 0; i < samples.size(); i += hn::Lanes (Floats())) {
    const V squared_range = squaredLength (pointsAt (samples, i));
    const V squared_normal = squaredLength (normalsAt (samples, i));
    const Mask measured = hn::Gt (squared_range, hn::Zero (Floats()));
    const V range = hn::Sqrt (squared_range);
    const V sigma = sigmaOf (noise, squared_range);
    const V relative = hn::Div (sigma, range);
    hn::StoreU (hn::IfThenElse (measured, sigma, none), Floats(), &samples.sigma[i]);
    hn::StoreU (hn::IfThenElse (measured, relative, none),
                Floats(),
                &samples.relative_sigma[i]);
    hn::StoreU (hn::IfThenElseZero (measured,
                                    hn::Div (set (1.f), hn::Mul (relative, relative))),
                Floats(),
                &samples.weight[i]);
    hn::StoreU (hn::IfThenElse (hn::Gt (squared_normal, hn::Zero (Floats())),
                                minCosine (range),
                                none),
                Floats(),
                &samples.min_cosine[i]);
  }
}

std::uint8_t
claimTileHere (const PlaneSamples& samples,
               std::size_t tile,
               const PlaneEquation& plane,
               float max_sigmas,
               float* claimed)
{
  std::size_t number = 0;
  forEachVectorFrom (tile * PlaneSamples::tile_size, [&] (std::size_t i) {
    const V distance = hn::Add (dot (plane, pointsAt (samples, i)), set (plane.d));
    const V cosine = dot (plane, normalsAt (samples, i));
    const V reach = hn::Max (hn::Mul (load (&samples.relative_sigma[i]), set (plane.d)),
                             hn::Mul (load (&samples.sigma[i]), set (min_view_cosine)));
    const Mask on =
        hn::And (hn::Le (hn::Abs (distance), hn::Mul (reach, set (max_sigmas))),
                 hn::Ge (hn::Abs (cosine), load (&samples.min_cosine[i])));
    hn::StoreU (
        hn::IfThenElseZero (on, load (&samples.weight[i])), Floats(), claimed + i);
    number += hn::CountTrue (Floats(), on);
  });
  return static_cast<std::uint8_t> (number);
}

void
sumSamplesHere (const PlaneSamples& samples,
                const std::vector<std::uint32_t>& tiles,
                const float* claimed,
                const double (&reference)[3],
                double (&sums)[10])
{
  Sums all;
  forEachVector (tiles, [&] (std::size_t i) {
    all.add (relativePoints (samples, i, reference), load (claimed + i));
  });
  totals (all, sums);
}

void
sumNormalsHere (const PlaneSamples& samples,
                const std::vector<std::uint32_t>& tiles,
                const float* claimed,
                const double (&reference)[3],
                double (&sums)[22])
{
  Sums all;
  V normals[12];
  for (V& value : normals)
    value = hn::Zero (Floats());
  forEachVector (tiles, [&] (std::size_t i) {
    const V weight =
        hn::IfThenElseZero (hn::Ge (load (&samples.min_cosine[i]), hn::Zero (Floats())),
                            load (claimed + i));
    const Points p = relativePoints (samples, i, reference);
    all.add (p, weight);
    const Points n = normalsAt (samples, i);
    const V components[3] = {n.x, n.y, n.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const V component = hn::Mul (weight, components[k]);
      normals[k] = hn::Add (normals[k], component);
      normals[3 + 3 * k] = hn::MulAdd (component, p.x, normals[3 + 3 * k]);
      normals[4 + 3 * k] = hn::MulAdd (component, p.y, normals[4 + 3 * k]);
      normals[5 + 3 * k] = hn::MulAdd (component, p.z, normals[5 + 3 * k]);
    }
  });
  totals (all, sums);
  for (std::size_t k = 0; k < 12; ++k)
    sums[10 + k] = total (normals[k]);
}

std::uint16_t
compatibleSamplesHere (const PlaneSamples& samples,
                       std::size_t begin,
                       const PlaneEquation& plane,
                       float enough)
{
  unsigned bits = 0;
  forEachVectorFrom (begin, [&] (std::size_t i) {
    const V cosine = dot (plane, normalsAt (samples, i));
    const Mask agrees = hn::Ge (hn::Abs (cosine),
                                hn::Min (load (&samples.min_cosine[i]), set (enough)));
    bits |= bitsOf (agrees) << (i - begin);
  });
  return static_cast<std::uint16_t> (bits);
}

SamplesAtPlane
samplesAtPlaneHere (const PlaneSamples& samples,
                    std::size_t begin,
                    const PlaneEquation& plane,
                    const DepthNoise& noise,
                    float max_sigmas,
                    float least_cosine)
{
  unsigned near = 0, along = 0;
  forEachVectorFrom (begin, [&] (std::size_t i) {
    const Points p = pointsAt (samples, i);
    const V distance = hn::Abs (hn::Add (dot (plane, p), set (plane.d)));
    const V squared_range = squaredLength (p);
    const V range = hn::Sqrt (squared_range);
    const V towards = hn::Max (set (plane.d), hn::Mul (range, set (min_view_cosine)));
    const V reach =
        hn::Mul (hn::Mul (set (max_sigmas), sigmaOf (noise, squared_range)), towards);
    const V cosine = dot (plane, normalsAt (samples, i));
    near |= bitsOf (hn::And (hn::Gt (squared_range, set (min_squared_range)),
                             hn::Le (hn::Mul (distance, range), reach)))
            << (i - begin);
    along |= bitsOf (hn::Ge (hn::Abs (cosine), set (least_cosine))) << (i - begin);
  });
  return {static_cast<std::uint16_t> (near), static_cast<std::uint16_t> (along)};
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (fillUncertaintiesHere);
HWY_EXPORT (claimTileHere);
HWY_EXPORT (sumSamplesHere);
HWY_EXPORT (sumNormalsHere);
HWY_EXPORT (compatibleSamplesHere);
HWY_EXPORT (samplesAtPlaneHere);

void
fillUncertainties (PlaneSamples& samples, const DepthNoise& noise)
{
  HWY_DYNAMIC_DISPATCH (fillUncertaintiesHere) (samples, noise);
}

std::uint8_t
claimTile (const PlaneSamples& samples,
           std::size_t tile,
           const PlaneEquation& plane,
           float max_sigmas,
           float* claimed)
{
  return HWY_DYNAMIC_DISPATCH (claimTileHere) (
      samples, tile, plane, max_sigmas, claimed);
}

void
sumSamples (const PlaneSamples& samples,
            const std::vector<std::uint32_t>& tiles,
            const float* claimed,
            const double (&reference)[3],
            double (&sums)[10])
{
  HWY_DYNAMIC_DISPATCH (sumSamplesHere) (samples, tiles, claimed, reference, sums);
}

void
sumNormals (const PlaneSamples& samples,
            const std::vector<std::uint32_t>& tiles,
            const float* claimed,
            const double (&reference)[3],
            double (&sums)[22])
{
  HWY_DYNAMIC_DISPATCH (sumNormalsHere) (samples, tiles, claimed, reference, sums);
}

std::uint16_t
compatibleSamples (const PlaneSamples& samples,
                   std::size_t begin,
                   const PlaneEquation& plane,
                   float enough)
{
  return HWY_DYNAMIC_DISPATCH (compatibleSamplesHere) (samples, begin, plane, enough);
}

SamplesAtPlane
samplesAtPlane (const PlaneSamples& samples,
                std::size_t begin,
                const PlaneEquation& plane,
                const DepthNoise& noise,
                float max_sigmas,
                float least_cosine)
{
  return HWY_DYNAMIC_DISPATCH (samplesAtPlaneHere) (
      samples, begin, plane, noise, max_sigmas, least_cosine);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
