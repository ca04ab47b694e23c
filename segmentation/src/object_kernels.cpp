// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "object_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "object_kernels.h"
#include "plane_vectors-inl.h"

#include <pcl/segmentation/support_planes.h>

#include <algorithm>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** As mayBeOnPlane(). */
HWY_INLINE Mask
mayBeOnPlane (V height,
              V projection,
              V squared_range,
              const ObjectParameters& parameters)
{
  const V sigma = sigmaOf (parameters.noise, squared_range);
  const V noise = hn::Mul (hn::Mul (set (plane_sigmas), sigma), projection);
  return hn::Or (hn::Le (hn::Abs (height), set (0.5f * parameters.min_object_height)),
                 hn::Le (hn::Mul (hn::Mul (height, height), squared_range),
                         hn::Mul (noise, noise)));
}

/** How far from a pixel the two points are that are compared. */
constexpr float reach_m = 0.006f;
constexpr float max_reach_px = 5.f;
static_assert (max_reach_px <= ClusterImage::margin, "points lie inside of the image");
/** A point is above the tangent plane of another one when it rises by this part of their
 * distance, 17 degrees, and by more than noise: that many standard deviations of depth. */
constexpr float min_step_rise = 0.3f;
constexpr float min_step_sigmas = 2.f;

using Places = std::ptrdiff_t[4];

/** From a point of \a block to the second one of each pair, in four directions. */
HWY_INLINE void
findSteps (const ClusterImage& image,
           std::size_t block,
           float pixel_angle,
           Places& steps)
{
  const auto* owner = &image.owner[block];
  const std::size_t i =
      block +
      static_cast<std::size_t> (std::find_if (owner,
                                              owner + ClusterImage::block_size,
                                              [] (std::uint32_t o) { return o != 0; }) -
                                owner);
  const float squared_range =
      image.x[i] * image.x[i] + image.y[i] * image.y[i] + image.z[i] * image.z[i];
  const float pixel_m = pixel_angle * std::sqrt (squared_range);
  const float reach = std::min (reach_m / pixel_m, max_reach_px);
  const std::ptrdiff_t far = std::max (std::lround (reach), 1l);
  const std::ptrdiff_t near =
      std::max (std::lround (0.7f * static_cast<float> (far)), 1l);
  const std::ptrdiff_t stride = image.stride();
  steps[0] = far;
  steps[1] = far * stride;
  steps[2] = near * stride + near;
  steps[3] = near * stride - near;
}

/** The points of an image from place \a i on, with their normals. */
struct Surface {
  Points points, normals;

  HWY_INLINE
  Surface (const ClusterImage& image, std::ptrdiff_t i)
  : points{load (image.x.data() + i),
           load (image.y.data() + i),
           load (image.z.data() + i)}
  , normals{load (image.normal_x.data() + i),
            load (image.normal_y.data() + i),
            load (image.normal_z.data() + i)}
  {}

  /** Whether the points at the end of \a way are above the tangent planes. */
  HWY_INLINE Mask
  isBelow (const Points& way, const DepthNoise& noise) const
  {
    const V rise = dot (normals, way);
    const V sigma = sigmaOf (noise, squaredLength (points));
    return hn::And (
        hn::Gt (rise, hn::Mul (set (min_step_sigmas), sigma)),
        hn::Gt (hn::Mul (rise, rise),
                hn::Mul (set (min_step_rise * min_step_rise), squaredLength (way))));
  }
};

HWY_INLINE Mask
isCut (const ClusterImage& image,
       std::ptrdiff_t i,
       const Places& steps,
       const DepthNoise& noise)
{
  const auto owner = [&] (std::ptrdiff_t j) {
    return hn::LoadU (hn::RebindToUnsigned<Floats>(), image.owner.data() + j);
  };
  const auto own = owner (i);
  Mask cut = hn::MaskFromVec (hn::Zero (Floats()));
  for (const std::ptrdiff_t step : steps) {
    const Surface a (image, i - step), b (image, i + step);
    const Points forth = difference (b.points, a.points);
    const Points back = difference (a.points, b.points);
    const Mask is_inside = hn::RebindMask (
        Floats(),
        hn::And (hn::Eq (owner (i - step), own), hn::Eq (owner (i + step), own)));
    const Mask is_step = hn::Or (a.isBelow (forth, noise), b.isBelow (back, noise));
    cut = hn::Or (cut, hn::And (is_inside, is_step));
  }
  return cut;
}

/** Whether points are neither (0, 0, 0) nor NaN or infinite. */
HWY_INLINE Mask
isMeasured (V squared_range)
{
  return hn::And (hn::Gt (squared_range, hn::Zero (Floats())),
                  hn::Le (squared_range, set (std::numeric_limits<float>::max())));
}

/** Points in the axes of a supporting plane. */
struct Projected {
  V x, y;

  HWY_INLINE
  Projected (const SupportPlane& support, const Points& p)
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

} // namespace

void
markCutsHere (const ClusterImage& image,
              float pixel_angle,
              const DepthNoise& noise,
              std::vector<std::uint8_t>& cut)
{
  constexpr std::size_t block_size = ClusterImage::block_size;
  cut.resize (image.size());
  for (std::size_t block = 0; block + block_size <= image.size(); block += block_size) {
    const auto* owner = &image.owner[block];
    if (std::all_of (
            owner, owner + block_size, [] (std::uint32_t o) { return o == 0; }))
      continue;
    Places steps;
    findSteps (image, block, pixel_angle, steps);
    for (std::size_t i = block; i < block + block_size; i += hn::Lanes (Floats())) {
      const Mask is_cut = isCut (image, static_cast<std::ptrdiff_t> (i), steps, noise);
      storeBytes (intOf (is_cut, 1), &cut[i]);
    }
  }
}

void
placeRowHere (const PointRow& row,
              int v,
              const std::vector<const SupportPlane*>& planes,
              const ObjectParameters& parameters,
              std::uint8_t* places,
              std::uint8_t* has_above)
{
  const auto nowhere = hn::Zero (Ints()), outside = hn::Set (Ints(), 1);
  const V farthest = set (parameters.noise.max_range * parameters.noise.max_range);
  for (std::size_t block = 0; block < row.blocks(); ++block) {
    bool any_above = false;
    for (std::size_t k = 0; k < PointRow::block_size; k += hn::Lanes (Floats())) {
      const auto i = static_cast<std::ptrdiff_t> (block * PointRow::block_size + k);
      const Points p = load (row, i);
      const V squared_range = squaredLength (p);
      auto place = outside;
      Mask is_open =
          hn::And (isMeasured (squared_range), hn::Le (squared_range, farthest));
      Mask may_be_under = hn::MaskFromVec (hn::Zero (Floats()));
      for (std::size_t number = 0; number < planes.size(); ++number) {
        const SupportPlane& support = *planes[number];
        const V projection = dot (equationOf (support.plane), p);
        const V height =
            hn::Add (projection, set (support.plane.d - support.warp.row (v)[block]));
        const Mask is_near = hn::And (
            is_open, hn::Le (hn::Abs (height), set (parameters.max_object_height)));
        const Mask is_on = hn::And (
            is_near, mayBeOnPlane (height, projection, squared_range, parameters));
        const Projected q (support, p);
        const Mask is_over = q.isIn (support.outline.bounds());
        const Mask is_above =
            hn::And (hn::And (is_near, is_over), hn::Gt (height, hn::Zero (Floats())));
        if (!hn::AllFalse (Floats(), is_above)) {
          const Mask is_sure =
              hn::AndNot (may_be_under, q.isIn (support.outline.innerSides()));
          const auto above = hn::Add (intOf (is_sure, surely_above),
                                      hn::Set (Ints(), static_cast<int> (2 + number)));
          place = hn::IfThenElse (hn::RebindMask (Ints(), is_above), above, place);
        }
        place = hn::IfThenElse (hn::RebindMask (Ints(), is_on), nowhere, place);
        is_open = hn::AndNot (hn::Or (is_on, is_above), is_open);
        may_be_under = hn::Or (may_be_under, is_over);
      }
      any_above |= !hn::AllFalse (Ints(), hn::Gt (place, outside));
      storeBytes (place, places + i);
    }
    has_above[block] = any_above;
  }
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (markCutsHere);
HWY_EXPORT (placeRowHere);

void
markCuts (const ClusterImage& image,
          float pixel_angle,
          const DepthNoise& noise,
          std::vector<std::uint8_t>& cut)
{
  HWY_DYNAMIC_DISPATCH (markCutsHere) (image, pixel_angle, noise, cut);
}

void
placeRow (const PointRow& row,
          int v,
          const std::vector<const SupportPlane*>& planes,
          const ObjectParameters& parameters,
          std::uint8_t* places,
          std::uint8_t* has_above)
{
  HWY_DYNAMIC_DISPATCH (placeRowHere)
  (row, v, planes, parameters, places, has_above);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
