// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "step_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "step_kernels.h"
#include "vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** Samples on either side of a line whose mean errors are compared, and how many of them
 * there must be: an edge of a table is only two or three samples thick. */
constexpr std::size_t depth = 4;
constexpr float min_in_depth = 2.f;

/** 1, u, v, uu, uv, vv and the error of the samples from \a i on that are \a chosen, 0 for the
 * others. */
struct Terms {
  V values[7];

  HWY_INLINE
  Terms (const SurfaceSamples& samples, std::size_t i, Mask chosen)
  {
    const V u = hn::IfThenElseZero (chosen, load (&samples.u[i]));
    const V v = hn::IfThenElseZero (chosen, load (&samples.v[i]));
    values[0] = hn::IfThenElseZero (chosen, set (1.f));
    values[1] = u;
    values[2] = v;
    values[3] = hn::Mul (u, u);
    values[4] = hn::Mul (u, v);
    values[5] = hn::Mul (v, v);
    values[6] = hn::IfThenElseZero (chosen, load (&samples.errors[i]));
  }
};

HWY_INLINE float
total (V value)
{
  return hn::GetLane (hn::SumOfLanes (Floats(), value));
}

} // namespace

void
findJumpsHere (const float* errors,
               const float* own,
               std::size_t begin,
               std::size_t end,
               std::size_t across,
               float* jumps)
{
  for (std::size_t i = begin; i < end; i += hn::Lanes (Floats())) {
    V before = hn::Zero (Floats()), behind = before, number_before = before,
      number_behind = before;
    for (std::size_t k = 0; k < depth; ++k) {
      before = hn::Add (before, load (errors + i - k * across));
      number_before = hn::Add (number_before, load (own + i - k * across));
      behind = hn::Add (behind, load (errors + i + (k + 1) * across));
      number_behind = hn::Add (number_behind, load (own + i + (k + 1) * across));
    }
    const Mask is_known =
        hn::And (hn::Gt (load (own + i), hn::Zero (Floats())),
                 hn::Ge (hn::Min (number_before, number_behind), set (min_in_depth)));
    const V jump =
        hn::Sub (hn::Div (before, number_before), hn::Div (behind, number_behind));
    hn::StoreU (hn::IfThenElseZero (is_known, jump), Floats(), jumps + i);
  }
}

void
sumProductsHere (const SurfaceSamples& samples, float (&sums)[7][7])
{
  V all[7][7];
  for (auto& row : all)
    for (V& value : row)
      value = hn::Zero (Floats());
  for (std::size_t i = 0; i < samples.u.size(); i += hn::Lanes (Floats())) {
    const Mask is_sample = hn::Ge (load (&samples.columns[i]), hn::Zero (Floats()));
    const Terms terms (samples, i, is_sample);
    for (std::size_t a = 0; a < 7; ++a)
      for (std::size_t b = 0; b <= a; ++b)
        all[a][b] = hn::MulAdd (terms.values[a], terms.values[b], all[a][b]);
  }
  for (std::size_t a = 0; a < 7; ++a)
    for (std::size_t b = 0; b <= a; ++b)
      sums[a][b] = sums[b][a] = total (all[a][b]);
}

void
sumBehindHere (const SurfaceSamples& samples, const GridLine& line, float (&sums)[7])
{
  const auto& across = line.is_steep ? samples.columns : samples.rows;
  const auto& along = line.is_steep ? samples.rows : samples.columns;
  V all[7];
  for (V& value : all)
    value = hn::Zero (Floats());
  for (std::size_t i = 0; i < samples.u.size(); i += hn::Lanes (Floats())) {
    const V line_at =
        hn::Add (hn::Mul (set (line.slope), load (&along[i])), set (line.offset));
    const Terms terms (samples, i, hn::Gt (load (&across[i]), line_at));
    for (std::size_t k = 0; k < 7; ++k)
      all[k] = hn::Add (all[k], terms.values[k]);
  }
  for (std::size_t k = 0; k < 7; ++k)
    sums[k] = total (all[k]);
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (findJumpsHere);
HWY_EXPORT (sumProductsHere);
HWY_EXPORT (sumBehindHere);

void
findJumps (const float* errors,
           const float* own,
           std::size_t begin,
           std::size_t end,
           std::size_t across,
           float* jumps)
{
  HWY_DYNAMIC_DISPATCH (findJumpsHere) (errors, own, begin, end, across, jumps);
}

void
sumProducts (const SurfaceSamples& samples, float (&sums)[7][7])
{
  HWY_DYNAMIC_DISPATCH (sumProductsHere) (samples, sums);
}

void
sumBehind (const SurfaceSamples& samples, const GridLine& line, float (&sums)[7])
{
  HWY_DYNAMIC_DISPATCH (sumBehindHere) (samples, line, sums);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
