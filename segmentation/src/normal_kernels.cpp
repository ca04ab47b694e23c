// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "normal_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "sample_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** The noise of a Kinect v1 tilts most normals of a flat surface by less than this many
 * degrees where it faces the sensor, more with the square of the range... */
constexpr float usual_tilt = 6.f, usual_tilt_per_squared_metre = 1.f;

} // namespace

void
sumNormalsHere (const PlaneSamples& samples,
                const std::vector<std::uint32_t>& tiles,
                const float* claimed,
                const double* reference,
                double (&sums)[22])
{
  const Points origin = setPoint (reference);
  Sums all;
  V normals[12];
  for (V& value : normals)
    value = hn::Zero (Floats());
  forEachVector (tiles, [&] (std::size_t i) {
    const V weight = hn::IfThenElseZero (isTrusted (samples, i), load (claimed + i));
    const Points p = pointsAt (samples, i) - origin;
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

unsigned
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
  return bits;
}

NormalsAtPlane
normalsAtPlaneHere (const PlaneSamples& samples,
                    std::size_t begin,
                    const PlaneEquation& plane,
                    float scatter)
{
  unsigned known = 0, near = 0;
  forEachVectorFrom (begin, [&] (std::size_t i) {
    const V squared_range = squaredLength (pointsAt (samples, i));
    // ... and the more the flatter the surface is seen.
    const V view_cosine = hn::Max (hn::Div (set (plane.d), hn::Sqrt (squared_range)),
                                   set (min_view_cosine));
    const V tilt = hn::Div (hn::MulAdd (squared_range,
                                        set (scatter * usual_tilt_per_squared_metre),
                                        set (scatter * usual_tilt)),
                            view_cosine);
    const Points normals = normalsAt (samples, i);
    const Mask has_normal = hn::Gt (squaredLength (normals), hn::Zero (Floats()));
    const V cosine = hn::Abs (dot (plane, normals));
    known |= bitsOf (has_normal) << (i - begin);
    near |= bitsOf (hn::And (has_normal, hn::Ge (cosine, cosineOf (tilt))))
            << (i - begin);
  });
  return {known, near};
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (sumNormalsHere);
HWY_EXPORT (compatibleSamplesHere);
HWY_EXPORT (normalsAtPlaneHere);

void
sumNormals (const PlaneSamples& samples,
            const std::vector<std::uint32_t>& tiles,
            const float* claimed,
            const double* reference,
            double (&sums)[22])
{
  HWY_DYNAMIC_DISPATCH (sumNormalsHere) (samples, tiles, claimed, reference, sums);
}

unsigned
compatibleSamples (const PlaneSamples& samples,
                   std::size_t begin,
                   const PlaneEquation& plane,
                   float enough)
{
  return HWY_DYNAMIC_DISPATCH (compatibleSamplesHere) (samples, begin, plane, enough);
}

NormalsAtPlane
normalsAtPlane (const PlaneSamples& samples,
                std::size_t begin,
                const PlaneEquation& plane,
                float scatter)
{
  return HWY_DYNAMIC_DISPATCH (normalsAtPlaneHere) (samples, begin, plane, scatter);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
