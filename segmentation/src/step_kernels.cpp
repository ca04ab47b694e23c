// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "step_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "each_bit.h"
#include "plane_vectors-inl.h"
#include "step_kernels.h"

#include <cstdint>

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

} // namespace

void
findJumpsHere (const float* errors,
               const float* own,
               std::size_t begin,
               std::size_t end,
               float* jumps)
{
  for (std::size_t i = begin; i < end; i += hn::Lanes (Floats())) {
    V before = hn::Zero (Floats()), behind = before, number_before = before,
      number_behind = before;
    for (std::size_t k = 0; k < depth; ++k) {
      before = hn::Add (before, load (errors + i - k));
      number_before = hn::Add (number_before, load (own + i - k));
      behind = hn::Add (behind, load (errors + i + k + 1));
      number_behind = hn::Add (number_behind, load (own + i + k + 1));
    }
    const Mask is_known =
        hn::And (hn::Gt (load (own + i), hn::Zero (Floats())),
                 hn::Ge (hn::Min (number_before, number_behind), set (min_in_depth)));
    const V jump =
        hn::Sub (hn::Div (before, number_before), hn::Div (behind, number_behind));
    hn::StoreU (hn::IfThenElseZero (is_known, jump), Floats(), jumps + i);
  }
}

std::size_t
findPeaksHere (
    const float* jumps, std::size_t begin, std::size_t end, float least, int* peaks)
{
  std::size_t count = 0;
  for (std::size_t i = begin; i < end; i += hn::Lanes (Floats())) {
    const V jump = hn::Abs (load (jumps + i));
    const Mask is_peak =
        hn::And (hn::Ge (jump, hn::Max (set (least), hn::Abs (load (jumps + i - 1)))),
                 hn::Gt (jump, hn::Abs (load (jumps + i + 1))));
    forEachBit (bitsOf (Floats(), is_peak), [&] (std::size_t lane) {
      peaks[count++] = static_cast<int> (i + lane);
    });
  }
  return count;
}

std::size_t
findLinesHere (const float* jumps,
               int width,
               std::size_t stride,
               const std::vector<int>& starts,
               const std::vector<float>& votes,
               const LineLimits& limits,
               int* lines)
{
  const auto lanes = static_cast<int> (hn::Lanes (Floats()));
  std::size_t count = 0;
  for (int first = 0; first < static_cast<int> (votes.size()); first += lanes) {
    const Mask is_voted =
        hn::Ge (hn::Abs (load (&votes[static_cast<std::size_t> (first)])),
                set (limits.min_votes));
    if (hn::AllFalse (Floats(), is_voted))
      continue;
    const auto isBeside = [&] (std::size_t row) {
      return first - starts[row] <= -lanes || first - starts[row] >= width;
    };
    std::size_t begin = 0, end = starts.size();
    while (begin < end && isBeside (begin))
      ++begin;
    while (begin < end && isBeside (end - 1))
      --end;
    V sum = hn::Zero (Floats()), places = sum;
    for (std::size_t row = begin; row < end; ++row) {
      const V jump = load (jumps + static_cast<std::ptrdiff_t> (row * stride) + first -
                           starts[row]);
      sum = hn::Add (sum, jump);
      places = hn::Add (
          places, hn::IfThenElseZero (hn::Ne (jump, hn::Zero (Floats())), set (1.f)));
    }
    const Mask is_line =
        hn::And (hn::And (is_voted, hn::Ge (places, set (limits.min_places))),
                 hn::Ge (hn::Abs (sum), hn::Mul (set (limits.min_jump), places)));
    forEachBit (bitsOf (Floats(), is_line), [&] (std::size_t lane) {
      lines[count++] = first + static_cast<int> (lane);
    });
  }
  return count;
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
HWY_EXPORT (findPeaksHere);
HWY_EXPORT (findLinesHere);
HWY_EXPORT (sumProductsHere);
HWY_EXPORT (sumBehindHere);

void
findJumps (const float* errors,
           const float* own,
           std::size_t begin,
           std::size_t end,
           float* jumps)
{
  HWY_DYNAMIC_DISPATCH (findJumpsHere) (errors, own, begin, end, jumps);
}

std::size_t
findPeaks (
    const float* jumps, std::size_t begin, std::size_t end, float least, int* peaks)
{
  return HWY_DYNAMIC_DISPATCH (findPeaksHere) (jumps, begin, end, least, peaks);
}

std::size_t
findLines (const float* jumps,
           int width,
           std::size_t stride,
           const std::vector<int>& starts,
           const std::vector<float>& votes,
           const LineLimits& limits,
           int* lines)
{
  return HWY_DYNAMIC_DISPATCH (findLinesHere) (
      jumps, width, stride, starts, votes, limits, lines);
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
