// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "object_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "object_kernels.h"
#include "plane_vectors-inl.h"

#include <pcl/segmentation/impl/support_planes.h>

#include <array>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** Points in the axes of a supporting plane. */
struct Projected {
  V x, y;

  HWY_INLINE
  Projected (const SupportSurface& support, const Points& p)
  : x (along (support.axis_x, p))
  , y (along (support.axis_y, p))
  {}

  HWY_INLINE static V
  along (const Eigen::Vector3f& axis, const Points& p)
  {
    return dot (PlaneEquation{axis[0], axis[1], axis[2], 0.f}, p);
  }

  HWY_INLINE Mask
  isIn (const Eigen::AlignedBox2f& bounds) const
  {
    const auto isBetween = [&] (V value, int side) {
      return hn::And (hn::Ge (value, set (bounds.min()[side])),
                      hn::Le (value, set (bounds.max()[side])));
    };
    return hn::And (isBetween (x, 0), isBetween (y, 1));
  }

  HWY_INLINE Mask
  isIn (const std::array<ConvexOutline::Side, 8>& sides) const
  {
    V closest = set (1.f);
    for (const auto& side : sides)
      closest = hn::Min (
          closest,
          hn::MulAdd (set (side.a), x, hn::MulAdd (set (side.b), y, set (side.c))));
    return hn::Gt (closest, hn::Zero (Floats()));
  }
};

using Supports = std::vector<const SupportSurface*>;

/** As placeRow(), for some points of a block of row \a v. */
HWY_INLINE I
placesOf (const Points& p,
          I is_background,
          int v,
          std::size_t block,
          const Supports& planes,
          const ObjectParameters& parameters)
{
  const V squared_range = squaredLength (p);
  const V noise =
      hn::Mul (set (plane_sigmas), sigmaOf (parameters.noise, squared_range));
  Mask is_open =
      hn::And (isUsable (squared_range, set (parameters.noise.maxSquaredRange())),
               hn::RebindMask (Floats(), hn::Eq (is_background, hn::Zero (Ints()))));
  auto place = hn::Sub (hn::Set (Ints(), 1), is_background);
  for (std::size_t number = 0; number < planes.size(); ++number) {
    if (hn::AllFalse (Floats(), is_open))
      break;
    const SupportSurface& support = *planes[number];
    const V projection = dot (equationOf (support.plane), p);
    const V height =
        hn::Add (projection, set (support.plane.d - support.warp.row (v)[block]));
    const Mask is_near = hn::And (
        is_open, hn::Le (hn::Abs (height), set (parameters.max_object_height)));
    if (hn::AllFalse (Floats(), is_near))
      continue;
    const Projected projected (support, p);
    const Mask is_here =
        hn::And (is_near, projected.isIn (support.surroundings.bounds()));
    if (hn::AllFalse (Floats(), is_here))
      continue;
    // As mayBeOnPlane().
    const V rise = hn::Mul (noise, projection);
    const Mask is_within_noise = hn::Le (
        hn::Mul (hn::Mul (height, height), squared_range), hn::Mul (rise, rise));
    const Mask is_low =
        hn::Le (hn::Abs (height), set (0.5f * parameters.min_object_height));
    const Mask is_level = hn::And (is_here, hn::Or (is_low, is_within_noise));
    // Beside a platform, what is as high as that may be of a thing on a lower plane.
    const Mask is_on =
        support.is_platform
            ? hn::And (is_level, projected.isIn (support.outline.innerSides()))
            : is_level;
    place = hn::IfThenZeroElse (hn::RebindMask (Ints(), is_on), place);
    is_open = hn::AndNot (is_on, is_open);
    const Mask is_above =
        hn::And (hn::AndNot (is_on, is_here),
                 hn::Or (is_level, hn::Gt (height, hn::Zero (Floats()))));
    if (hn::AllFalse (Floats(), is_above))
      continue;
    const Mask is_sure = projected.isIn (support.outline.innerSides());
    const int above = static_cast<int> (2 + number);
    const auto sure_or_not = hn::IfThenElse (hn::RebindMask (Ints(), is_sure),
                                             hn::Set (Ints(), above),
                                             hn::Set (Ints(), above + maybe_above));
    place = hn::IfThenElse (hn::RebindMask (Ints(), is_above), sure_or_not, place);
    is_open = hn::AndNot (is_above, is_open);
  }
  return place;
}

} // namespace

void
placeRowHere (const PointRow& row,
              int v,
              const Supports& planes,
              const ObjectParameters& parameters,
              const std::uint8_t* is_background,
              std::uint8_t* places,
              std::uint8_t* has_above)
{
  for (std::size_t block = 0; block < row.blocks(); ++block) {
    auto highest = hn::Zero (Ints());
    for (std::size_t k = 0; k < PointRow::block_size; k += hn::Lanes (Floats())) {
      const auto i = static_cast<std::ptrdiff_t> (block * PointRow::block_size + k);
      const auto background = hn::PromoteTo (
          Ints(), hn::LoadU (hn::Rebind<std::uint8_t, Ints>(), is_background + i));
      const auto place =
          placesOf (load (row, i), background, v, block, planes, parameters);
      highest = hn::Max (highest, place);
      storeBytes (place, places + i);
    }
    const auto isAnyFrom = [&] (int place) HWY_ATTR {
      return !hn::AllFalse (Ints(), hn::Gt (highest, hn::Set (Ints(), place - 1)));
    };
    has_above[block] = isAnyFrom (maybe_above) ? 2 : isAnyFrom (2) ? 1 : 0;
  }
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (placeRowHere);

void
placeRow (const PointRow& row,
          int v,
          const std::vector<const SupportSurface*>& planes,
          const ObjectParameters& parameters,
          const std::uint8_t* is_background,
          std::uint8_t* places,
          std::uint8_t* has_above)
{
  HWY_DYNAMIC_DISPATCH (placeRowHere)
  (row, v, planes, parameters, is_background, places, has_above);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
