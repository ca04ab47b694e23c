// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "link_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "link_kernels.h"
#include "plane_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {

void
linkRowHere (const PointRow& row,
             const PointRow& row_above,
             const LinkLimit& limit,
             const std::uint8_t* blocks,
             std::uint8_t* to_left,
             std::uint8_t* to_above)
{
  const PlaneEquation up{limit.up.x(), limit.up.y(), limit.up.z(), 0.f};
  for (std::size_t block = 0; block < row.blocks(); ++block) {
    if (!blocks[block])
      continue;
    for (std::size_t k = 0; k < PointRow::block_size; k += hn::Lanes (Floats())) {
      const auto i = static_cast<std::ptrdiff_t> (block * PointRow::block_size + k);
      const Points p = load (row, i);
      const V squared_range = squaredLength (p);
      const V range = hn::Sqrt (squared_range);
      const V sigma = sigmaOf (limit.noise, squared_range);
      const V rise = hn::Div (hn::Abs (dot (up, p)), range);
      const V run =
          hn::Sqrt (hn::Max (set (0.f), hn::NegMulAdd (rise, rise, set (1.f))));
      const V noise = hn::Mul (set (limit.sigmas), sigma);
      const V least = hn::Mul (set (LinkLimit::min_slope), range);
      const V slope = set (limit.slope);
      const V known_slope = set (limit.known_slope);
      const auto slopeOn = [&] (V sine) HWY_ATTR {
        return hn::Max (slope, hn::Div (known_slope, sine));
      };
      const auto unless = [&] (V sine, float least_sine, V same) HWY_ATTR {
        return hn::IfThenElse (hn::Ge (sine, set (least_sine)), same, set (-1.f));
      };
      const V spread = hn::Mul (set (LinkLimit::same_sigmas), sigma);
      const V level_slope = slopeOn (rise);
      const V same_height = unless (rise, LinkLimit::min_rise, hn::Mul (spread, rise));
      const V upright_slope = slopeOn (run);
      const V same_place =
          unless (run,
                  LinkLimit::min_run,
                  hn::MulAdd (known_slope, range, hn::Mul (spread, run)));
      const auto storeLinks = [&] (const Points& q, std::uint8_t* links) HWY_ATTR {
        const Points way = p - q;
        const V squared_way = squaredLength (way);
        const V climb = dot (up, way);
        const V level =
            hn::Sqrt (hn::Max (set (0.f), hn::NegMulAdd (climb, climb, squared_way)));
        V stretched = slope;
        stretched = hn::IfThenElse (
            hn::Le (hn::Abs (climb), same_height), level_slope, stretched);
        stretched = hn::IfThenElse (
            hn::Le (level, same_place), hn::Max (stretched, upright_slope), stretched);
        const V far = hn::Max (hn::MulAdd (stretched, range, noise), least);
        const Mask is_close = hn::Le (squared_way, hn::Mul (far, far));
        storeBytes (intOf (is_close, 1), links + i);
      };
      storeLinks (load (row, i - 1), to_left);
      storeLinks (load (row_above, i), to_above);
    }
  }
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (linkRowHere);

void
linkRow (const PointRow& row,
         const PointRow& row_above,
         const LinkLimit& limit,
         const std::uint8_t* blocks,
         std::uint8_t* to_left,
         std::uint8_t* to_above)
{
  HWY_DYNAMIC_DISPATCH (linkRowHere) (row, row_above, limit, blocks, to_left, to_above);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
