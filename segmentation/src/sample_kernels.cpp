// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sample_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "each_bit.h"
#include "sample_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** By how many degrees a normal may differ from that of its plane: 10, and 6 more with
 * each metre, as depth noise tilts far normals, but no more than 45, for those at the foot of
 * what stands on a far floor are between the two; more with the fourth root of their scatter,
 * which is less than that allows for. */
constexpr float angle_at_sensor = 10.f, angle_per_metre = 6.f, angle_far_away = 45.f;
/** Normals with more than this part of the largest curvature are not trusted. */
constexpr float trusted_share = 0.5f;

} // namespace

void
judgeSamplesHere (PlaneSamples& samples, const DepthNoise& noise, float max_curvature)
{
  const V none = set (-1.f);
  const float scatter = std::sqrt (std::sqrt (noise.normal_scatter));
  samples.seeds.resize (samples.size());
  std::size_t seeds = 0;
  for (std::size_t i = 0; i < samples.size(); i += hn::Lanes (Floats())) {
    const Points points = pointsAt (samples, i), normals = normalsAt (samples, i);
    const V squared_range = squaredLength (points);
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
    const V square = squaredLength (normals);
    const Mask has_normal = hn::And (hn::Gt (square, set (min_normal_square)),
                                     hn::Lt (square, set (max_normal_square)));
    // Sums of normals need one sign: towards the sensor.
    const Mask faces_away = hn::Gt (dot (points, normals), hn::Zero (Floats()));
    const V sign = hn::IfThenElse (faces_away, set (-1.f), set (1.f));
    for (auto* values : {&samples.normal_x, &samples.normal_y, &samples.normal_z})
      hn::StoreU (hn::IfThenElseZero (has_normal, hn::Mul (sign, load (&(*values)[i]))),
                  Floats(),
                  &(*values)[i]);
    const V curvature = load (&samples.curvature[i]);
    const Mask is_seed =
        hn::AndNot (hn::Gt (curvature, set (max_curvature)), has_normal);
    // Compressing vectors is slow on some processors.
    forEachBit (bitsOf (is_seed), [&] (std::size_t lane) {
      samples.seeds[seeds++] = static_cast<std::uint32_t> (i + lane);
    });
    const Mask is_trusted = hn::AndNot (
        hn::Gt (curvature, set (trusted_share * max_curvature)), has_normal);
    const V degrees = hn::Min (hn::MulAdd (range,
                                           set (scatter * angle_per_metre),
                                           set (scatter * angle_at_sensor)),
                               set (scatter * angle_far_away));
    hn::StoreU (hn::IfThenElse (is_trusted, cosineOf (degrees), none),
                Floats(),
                &samples.min_cosine[i]);
  }
  samples.seeds.resize (seeds);
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
    const V distance = signedDistance (plane, pointsAt (samples, i));
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

unsigned
claimPartHere (const PlaneSamples& samples,
               std::size_t tile,
               unsigned own,
               float* claimed)
{
  const std::size_t begin = tile * PlaneSamples::tile_size;
  unsigned result = 0;
  forEachVectorFrom (begin, [&] (std::size_t i) {
    const std::uint64_t bits = std::uint64_t{own} >> (i - begin);
    const Mask is_own =
        hn::LoadMaskBits (Floats(), reinterpret_cast<const std::uint8_t*> (&bits));
    const Mask on =
        hn::And (is_own, hn::Ge (load (&samples.sigma[i]), hn::Zero (Floats())));
    hn::StoreU (
        hn::IfThenElseZero (on, load (&samples.weight[i])), Floats(), claimed + i);
    result |= bitsOf (on) << (i - begin);
  });
  return result;
}

void
takeTileHere (PlaneSamples& samples,
              std::size_t tile,
              const float* claimed,
              std::int32_t owner,
              std::int32_t* owners)
{
  forEachVectorFrom (tile * PlaneSamples::tile_size, [&] (std::size_t i) {
    const Mask on = hn::Gt (load (claimed + i), hn::Zero (Floats()));
    for (auto* sigmas : {&samples.sigma, &samples.relative_sigma})
      hn::StoreU (hn::IfThenElse (on, set (-1.f), load (&(*sigmas)[i])),
                  Floats(),
                  &(*sigmas)[i]);
    hn::StoreU (hn::IfThenElse (hn::RebindMask (Ints(), on),
                                hn::Set (Ints(), owner),
                                hn::LoadU (Ints(), owners + i)),
                Ints(),
                owners + i);
  });
}

void
sumSamplesHere (const PlaneSamples& samples,
                const std::vector<std::uint32_t>& tiles,
                const float* claimed,
                const double* reference,
                double (&sums)[10])
{
  const Points origin = setPoint (reference);
  Sums all;
  forEachVector (tiles, [&] (std::size_t i) {
    all.add (pointsAt (samples, i) - origin, load (claimed + i));
  });
  totals (all, sums);
}

SamplesAtPlane
samplesAtPlaneHere (const PlaneSamples& samples,
                    std::size_t begin,
                    const PlaneEquation& plane,
                    const DepthNoise& tolerance,
                    float least_cosine)
{
  unsigned near = 0, along = 0;
  forEachVectorFrom (begin, [&] (std::size_t i) {
    const Reach reach = reachOf (pointsAt (samples, i), tolerance);
    const V cosine = dot (plane, normalsAt (samples, i));
    near |= bitsOf (hn::And (
                hn::Gt (reach.squared_range, set (DepthNoise::min_squared_range)),
                isWithin (reach, plane)))
            << (i - begin);
    along |= bitsOf (hn::And (isTrusted (samples, i),
                              hn::Ge (hn::Abs (cosine), set (least_cosine))))
             << (i - begin);
  });
  return {near, along};
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (judgeSamplesHere);
HWY_EXPORT (claimTileHere);
HWY_EXPORT (claimPartHere);
HWY_EXPORT (takeTileHere);
HWY_EXPORT (sumSamplesHere);
HWY_EXPORT (samplesAtPlaneHere);

void
judgeSamples (PlaneSamples& samples, const DepthNoise& noise, float max_curvature)
{
  HWY_DYNAMIC_DISPATCH (judgeSamplesHere) (samples, noise, max_curvature);
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

unsigned
claimPart (const PlaneSamples& samples, std::size_t tile, unsigned own, float* claimed)
{
  return HWY_DYNAMIC_DISPATCH (claimPartHere) (samples, tile, own, claimed);
}

void
takeTile (PlaneSamples& samples,
          std::size_t tile,
          const float* claimed,
          std::int32_t owner,
          std::int32_t* owners)
{
  HWY_DYNAMIC_DISPATCH (takeTileHere) (samples, tile, claimed, owner, owners);
}

void
sumSamples (const PlaneSamples& samples,
            const std::vector<std::uint32_t>& tiles,
            const float* claimed,
            const double* reference,
            double (&sums)[10])
{
  HWY_DYNAMIC_DISPATCH (sumSamplesHere) (samples, tiles, claimed, reference, sums);
}

SamplesAtPlane
samplesAtPlane (const PlaneSamples& samples,
                std::size_t begin,
                const PlaneEquation& plane,
                const DepthNoise& tolerance,
                float least_cosine)
{
  return HWY_DYNAMIC_DISPATCH (samplesAtPlaneHere) (
      samples, begin, plane, tolerance, least_cosine);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
