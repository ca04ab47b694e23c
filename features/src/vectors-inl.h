// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

// Vectors of floats, for the files that are compiled once for each set of instructions.

#if defined(PCL_RGBD_PLANES_VECTORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PCL_RGBD_PLANES_VECTORS_INL_H
#undef PCL_RGBD_PLANES_VECTORS_INL_H
#else
#define PCL_RGBD_PLANES_VECTORS_INL_H
#endif

#include <hwy/highway.h>

#include <pcl/features/impl/row_ring.h>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, RowRing<float>::lanes>;
using Ints = hn::RebindToSigned<Floats>;
using V = hn::Vec<Floats>;
using I = hn::Vec<Ints>;
using Mask = hn::Mask<Floats>;

struct Vectors {
  V x, y, z;
};

HWY_INLINE V
set (float value)
{
  return hn::Set (Floats(), value);
}

HWY_INLINE V
load (const float* from)
{
  return hn::LoadU (Floats(), from);
}

HWY_INLINE V
dot (const Vectors& a, const Vectors& b)
{
  return hn::MulAdd (a.x, b.x, hn::MulAdd (a.y, b.y, hn::Mul (a.z, b.z)));
}

HWY_INLINE float
total (V value)
{
  return hn::GetLane (hn::SumOfLanes (Floats(), value));
}

HWY_INLINE Vectors
operator- (const Vectors& a, const Vectors& b)
{
  return {hn::Sub (a.x, b.x), hn::Sub (a.y, b.y), hn::Sub (a.z, b.z)};
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#endif
