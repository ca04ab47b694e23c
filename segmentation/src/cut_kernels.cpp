// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cut_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "cut_kernels.h"
#include "sample_vectors-inl.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** How far from a pixel the two points are that are compared. */
constexpr float reach_m = 0.008f;
constexpr float max_reach_px = 5.f;
static_assert (max_reach_px <= ClusterImage::margin, "points lie inside of the image");
/** A point is above the tangent plane of another one when it rises by this part of their
 * distance, 17 degrees, and by more than noise: that many standard deviations of depth, two of
 * the difference of two points. */
constexpr float min_step_rise = 0.3f;
constexpr float min_step_sigmas = 2.83f;

using Steps = std::ptrdiff_t[4];

/** From a point of \a block to the second one of each pair, in four directions. */
HWY_INLINE void
findSteps (const ClusterImage& image,
           std::size_t block,
           float pixel_angle,
           Steps& steps)
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

HWY_INLINE hn::Vec<hn::RebindToUnsigned<Floats>>
ownersAt (const ClusterImage& image, std::ptrdiff_t i)
{
  return hn::LoadU (hn::RebindToUnsigned<Floats>(), image.owner.data() + i);
}

/** The cells whose owners are those of the cells \a step further. */
HWY_INLINE Mask
areAlike (const ClusterImage& image, std::ptrdiff_t i, std::ptrdiff_t step)
{
  return hn::RebindMask (Floats(),
                         hn::Eq (ownersAt (image, i), ownersAt (image, i + step)));
}

HWY_INLINE Mask
isCut (const ClusterImage& image,
       std::ptrdiff_t i,
       const Steps& steps,
       const DepthNoise& noise)
{
  Mask cut = hn::MaskFromVec (hn::Zero (Floats()));
  for (const std::ptrdiff_t step : steps) {
    const Surface a (image, i - step), b (image, i + step);
    const Points forth = b.points - a.points;
    const Points back = a.points - b.points;
    const Mask is_inside =
        hn::And (areAlike (image, i, -step), areAlike (image, i, step));
    const Mask is_step = hn::Or (a.isBelow (forth, noise), b.isBelow (back, noise));
    cut = hn::Or (cut, hn::And (is_inside, is_step));
  }
  return cut;
}

/** The bits of a block, those for which is_one (i) is true of the cells from i on. */
template <typename IsOne>
HWY_INLINE unsigned
bitsWhere (std::size_t block, const IsOne& is_one)
{
  unsigned bits = 0;
  for (std::size_t k = 0; k < ClusterImage::block_size; k += hn::Lanes (Floats()))
    bits |= bitsOf (is_one (static_cast<std::ptrdiff_t> (block + k))) << k;
  return bits;
}

} // namespace

void
findUncutHere (const ClusterImage& image,
               std::size_t row,
               float pixel_angle,
               const DepthNoise& noise,
               std::vector<RunBits>& bits)
{
  unsigned is_last_uncut = 0;
  for (std::size_t k = 0; k < bits.size(); ++k) {
    const std::size_t block = row + k * ClusterImage::block_size;
    const unsigned owned = bitsWhere (block, [&] (std::ptrdiff_t i) HWY_ATTR {
      const hn::RebindToUnsigned<Floats> owners;
      return hn::RebindMask (Floats(), hn::Ne (ownersAt (image, i), hn::Zero (owners)));
    });
    unsigned uncut = 0;
    bits[k] = {};
    if (owned != 0) {
      Steps steps;
      findSteps (image, block, pixel_angle, steps);
      const auto bitsOfLike = [&] (std::ptrdiff_t step) HWY_ATTR {
        return bitsWhere (block, [&] (std::ptrdiff_t i) HWY_ATTR {
          return areAlike (image, i, step);
        });
      };
      uncut = owned & ~bitsWhere (block, [&] (std::ptrdiff_t i) HWY_ATTR {
                return isCut (image, i, steps, noise);
              });
      const unsigned linked = uncut & (uncut << 1 | is_last_uncut) & bitsOfLike (-1);
      bits[k] = {static_cast<std::uint16_t> (uncut),
                 static_cast<std::uint16_t> (linked),
                 static_cast<std::uint16_t> (
                     bitsOfLike (-static_cast<std::ptrdiff_t> (image.stride())))};
    }
    is_last_uncut = uncut >> (ClusterImage::block_size - 1);
  }
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (findUncutHere);

void
findUncut (const ClusterImage& image,
           std::size_t row,
           float pixel_angle,
           const DepthNoise& noise,
           std::vector<RunBits>& bits)
{
  HWY_DYNAMIC_DISPATCH (findUncutHere) (image, row, pixel_angle, noise, bits);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
