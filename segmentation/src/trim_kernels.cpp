// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trim_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "each_bit.h"
#include "plane_vectors-inl.h"
#include "trim_kernels.h"

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** One value of each group, or of as many groups as a vector holds. */
using Group = hn::CappedTag<float, trim_groups>;

} // namespace

std::size_t
findLowHere (const float* values, std::size_t size, float sign, float* low)
{
  const auto signedAt = [=] (std::size_t i) HWY_ATTR {
    return hn::Mul (hn::Set (Group(), sign), hn::LoadU (Group(), values + i));
  };
  // As many values as there are groups are no higher than the lowest one of each; not many are.
  const std::size_t end = size / trim_groups * trim_groups;
  float lowest[trim_groups];
  for (std::size_t k = 0; k < trim_groups; k += hn::Lanes (Group())) {
    auto of_groups = hn::Set (Group(), std::numeric_limits<float>::max());
    for (std::size_t i = k; i < end; i += trim_groups)
      of_groups = hn::Min (of_groups, signedAt (i));
    hn::StoreU (of_groups, Group(), lowest + k);
  }
  const auto bound =
      hn::Set (Group(), *std::max_element (lowest, lowest + trim_groups));
  std::size_t count = 0;
  for (std::size_t i = 0; i < end; i += hn::Lanes (Group()))
    forEachBit (bitsOf (Group(), hn::Le (signedAt (i), bound)),
                [&] (std::size_t k) { low[count++] = sign * values[i + k]; });
  for (std::size_t i = end; i < size; ++i)
    low[count++] = sign * values[i];
  return count;
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (findLowHere);

std::size_t
findLow (const float* values, std::size_t size, float sign, float* low)
{
  return HWY_DYNAMIC_DISPATCH (findLowHere) (values, size, sign, low);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
