// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sample_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "plane_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** Calls \a body (i) for the first sample of each vector in \a tiles. */
template <typename Body>
HWY_INLINE void
forEachVector (const std::vector<std::uint32_t>& tiles, const Body& body)
{
  for (const std::uint32_t tile : tiles) {
    const std::size_t begin = tile * PlaneSamples::tile_size;
    for (std::size_t lane = 0; lane < PlaneSamples::tile_size;
         lane += hn::Lanes (Floats()))
      body (begin + lane);
  }
}

HWY_INLINE Points
relativePoints (const PlaneSamples& samples,
                std::size_t i,
                const double (&reference)[3])
{
  return {hn::Sub (load (&samples.x[i]), set (static_cast<float> (reference[0]))),
          hn::Sub (load (&samples.y[i]), set (static_cast<float> (reference[1]))),
          hn::Sub (load (&samples.z[i]), set (static_cast<float> (reference[2])))};
}

} // namespace

void
claimSamplesHere (const PlaneSamples& samples,
                  const std::vector<std::uint32_t>& tiles,
                  const PlaneEquation& plane,
                  float max_sigmas,
                  float* claimed,
                  std::uint8_t* counts)
{
  for (const std::uint32_t tile : tiles)
    counts[tile] = 0;
  forEachVector (tiles, [&] (std::size_t i) {
    const V distance = hn::Add (
        dot (plane, {load (&samples.x[i]), load (&samples.y[i]), load (&samples.z[i])}),
        set (plane.d));
    const V cosine = dot (plane,
                          {load (&samples.normal_x[i]),
                           load (&samples.normal_y[i]),
                           load (&samples.normal_z[i])});
    const V reach = hn::Max (hn::Mul (load (&samples.relative_sigma[i]), set (plane.d)),
                             hn::Mul (load (&samples.sigma[i]), set (min_view_cosine)));
    const Mask on =
        hn::And (hn::Le (hn::Abs (distance), hn::Mul (reach, set (max_sigmas))),
                 hn::Ge (hn::Abs (cosine), load (&samples.min_cosine[i])));
    hn::StoreU (
        hn::IfThenElseZero (on, load (&samples.weight[i])), Floats(), claimed + i);
    counts[i / PlaneSamples::tile_size] = static_cast<std::uint8_t> (
        counts[i / PlaneSamples::tile_size] + hn::CountTrue (Floats(), on));
  });
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
    const V components[3] = {load (&samples.normal_x[i]),
                             load (&samples.normal_y[i]),
                             load (&samples.normal_z[i])};
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

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (claimSamplesHere);
HWY_EXPORT (sumSamplesHere);
HWY_EXPORT (sumNormalsHere);

void
claimSamples (const PlaneSamples& samples,
              const std::vector<std::uint32_t>& tiles,
              const PlaneEquation& plane,
              float max_sigmas,
              float* claimed,
              std::uint8_t* counts)
{
  HWY_DYNAMIC_DISPATCH (claimSamplesHere)
  (samples, tiles, plane, max_sigmas, claimed, counts);
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

} // namespace rgbd_planes
} // namespace pcl
#endif
