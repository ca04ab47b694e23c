// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// Vectors of normals on their way to normals one by one, for the files that are compiled once
// for each set of instructions.

#if defined(PCL_RGBD_PLANES_NORMAL_VECTORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_RGBD_PLANES_NORMAL_VECTORS_INL_H
#undef PCL_RGBD_PLANES_NORMAL_VECTORS_INL_H
#else
#define PCL_RGBD_PLANES_NORMAL_VECTORS_INL_H
#endif

#include "row_vectors-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** Normals and curvatures of pixels, NaN where there is none. */
struct NormalVectors {
  Vectors n;
  V curvature;
};

HWY_INLINE NormalVectors
onlyValid (Mask is_valid, const Vectors& n, V curvature)
{
  const V nan = set (std::numeric_limits<float>::quiet_NaN());
  return {choose (is_valid, n, {nan, nan, nan}),
          hn::IfThenElse (is_valid, curvature, nan)};
}

#if HWY_TARGET == HWY_SCALAR
HWY_INLINE void
spread (const NormalVectors& normals, float* to, std::size_t)
{
  const V zero = hn::Zero (Floats());
  hn::StoreInterleaved4 (normals.n.x, normals.n.y, normals.n.z, zero, Floats(), to);
  hn::StoreInterleaved4 (normals.curvature, zero, zero, zero, Floats(), to + 4);
}

HWY_INLINE void
spreadPairs (const NormalVectors& first, const NormalVectors& second, float* to)
{
  spread (first, to, 0);
  spread (second, to + normal_floats, 0);
}
#else
/** Lanes \a first and following of: three floats of a normal, 0, its curvature, and 0 three
 * times; of quads of a normal and a curvature. */
HWY_INLINE V
spreadQuads (V quads, std::int32_t first)
{
  constexpr Ints d;
  const I lane = hn::Iota (d, first);
  const I in_normal = hn::And (lane, hn::Set (d, 7));
  const I of_quad = hn::Add (hn::ShiftLeft<2> (hn::ShiftRight<3> (lane)),
                             hn::Min (in_normal, hn::Set (d, 3)));
  const auto is_used =
      hn::Or (hn::Lt (in_normal, hn::Set (d, 3)), hn::Eq (in_normal, hn::Set (d, 4)));
  return hn::IfThenElseZero (
      hn::RebindMask (Floats(), is_used),
      hn::TableLookupLanes (quads, hn::IndicesFromVec (Floats(), of_quad)));
}

/** Writes every four normals \a stride floats behind those before. */
HWY_INLINE void
spread (const NormalVectors& normals, float* to, std::size_t stride)
{
  constexpr Floats d;
  constexpr std::size_t lanes = hn::MaxLanes (d);
  HWY_ALIGN float quads[4 * lanes];
  hn::StoreInterleaved4 (
      normals.n.x, normals.n.y, normals.n.z, normals.curvature, d, quads);
  for (std::size_t i = 0; i < 4 * lanes; i += lanes) {
    const V vector = hn::Load (d, quads + i);
    float* here = to + i / 16 * stride + i % 16 * 2;
    store (spreadQuads (vector, 0), here);
    store (spreadQuads (vector, lanes), here + lanes);
  }
}

HWY_INLINE void
spreadPairs (const NormalVectors& first, const NormalVectors& second, float* to)
{
  constexpr Floats d;
  const auto& [n, curvature] = first;
  const auto& [m, other_curvature] = second;
  spread ({{hn::InterleaveLower (d, n.x, m.x),
            hn::InterleaveLower (d, n.y, m.y),
            hn::InterleaveLower (d, n.z, m.z)},
           hn::InterleaveLower (d, curvature, other_curvature)},
          to,
          8 * normal_floats);
  spread ({{hn::InterleaveUpper (d, n.x, m.x),
            hn::InterleaveUpper (d, n.y, m.y),
            hn::InterleaveUpper (d, n.z, m.z)},
           hn::InterleaveUpper (d, curvature, other_curvature)},
          to + 4 * normal_floats,
          8 * normal_floats);
}
#endif

} // namespace
} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#endif
