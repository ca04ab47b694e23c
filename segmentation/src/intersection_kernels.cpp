// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "intersection_kernels.cpp"
#include "simd_targets.h"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once for each set of instructions.
#include "plane_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pcl {
namespace rgbd_planes {
namespace HWY_NAMESPACE {
namespace {

/** Points that are nearer to a plane than this share of the reach of planes clearly lie on
 * it, and those that are farther away than this one clearly do not. */
constexpr float on_share = 0.5f, off_share = 0.8f;
/** Where two planes are farther apart, points are clear of the line in which they meet. */
constexpr float clear_share = 0.6f;

/** Where plane \a a is nearer to the sensor than \a b along the viewing rays. */
HWY_INLINE Mask
isNearer (const Points& points, const PlaneEquation& a, const PlaneEquation& b)
{
  return hn::Lt (hn::Mul (set (b.d), dot (a, points)),
                 hn::Mul (set (a.d), dot (b, points)));
}

} // namespace

SideCounts
countSidesHere (const PointBlock& points,
                const std::uint32_t* labels,
                std::uint32_t label,
                const PlaneEquation& plane,
                const PlaneEquation& other,
                const DepthNoise& tolerance)
{
  SideCounts counts;
  for (std::size_t i = 0; i < points.size; i += hn::Lanes (Floats())) {
    const Mask own = areLabel (labels + i, label);
    const Reach reach = reachOf (load (points, i), tolerance);
    const Mask clear = hn::AndNot (isWithin (reach, other, off_share),
                                   hn::And (own, isWithin (reach, plane, on_share)));
    const Mask nearer = isNearer (reach.points, plane, other);
    counts.nearer += hn::CountTrue (Floats(), hn::And (clear, nearer));
    counts.farther += hn::CountTrue (Floats(), hn::AndNot (nearer, clear));
  }
  return counts;
}

void
splitPointsHere (const PointBlock& points,
                 std::uint32_t a,
                 std::uint32_t b,
                 const PlaneEquation* equations,
                 const DepthNoise& tolerance,
                 SeenPlane seen,
                 std::uint32_t* labels)
{
  const auto a_label = setInts (a), b_label = setInts (b);
  const bool nearer_is_seen = seen == SeenPlane::nearer;
  const auto label_where_a_is_nearer = nearer_is_seen ? a_label : b_label,
             label_elsewhere = nearer_is_seen ? b_label : a_label;
  for (std::size_t i = 0; i < points.size; i += hn::Lanes (Floats())) {
    const auto label = loadInts (labels + i);
    const auto of_pair = hn::Or (hn::Eq (label, a_label), hn::Eq (label, b_label));
    const Reach reach = reachOf (load (points, i), tolerance);
    const Mask on_both = hn::And (
        hn::RebindMask (Floats(), of_pair),
        hn::And (isWithin (reach, equations[a]), isWithin (reach, equations[b])));
    const Mask a_is_nearer = isNearer (reach.points, equations[a], equations[b]);
    const auto side = hn::IfThenElse (
        hn::RebindMask (Ints(), a_is_nearer), label_where_a_is_nearer, label_elsewhere);
    const auto result = hn::IfThenElse (hn::RebindMask (Ints(), on_both), side, label);
    storeInts (result, labels + i);
  }
}

void
dropUnclearHere (const PointBlock& points,
                 std::uint32_t label,
                 const PlaneEquation& plane,
                 const PlaneEquation& other,
                 const DepthNoise& tolerance,
                 SeenPlane seen,
                 std::uint32_t* labels)
{
  for (std::size_t i = 0; i < points.size; i += hn::Lanes (Floats())) {
    const Mask own = areLabel (labels + i, label);
    const Reach reach = reachOf (load (points, i), tolerance);
    // The inverses of the ranges of both planes, relative to that of the point, times both
    // of their distances to the sensor: where negative, a plane is infinitely far away.
    const V a = hn::Neg (dot (plane, reach.points)),
            b = hn::Neg (dot (other, reach.points));
    const V a_is_nearer = hn::MulSub (a, set (other.d), hn::Mul (b, set (plane.d)));
    const V ahead = seen == SeenPlane::nearer ? a_is_nearer : hn::Neg (a_is_nearer);
    const V gap = hn::Mul (hn::Mul (set (clear_share), reach.limit), hn::Mul (a, b));
    const Mask clear = hn::Ge (hn::Mul (ahead, reach.range), gap);
    const auto result =
        hn::IfThenElse (hn::RebindMask (Ints(), hn::AndNot (clear, own)),
                        setInts (unlabelled),
                        loadInts (labels + i));
    storeInts (result, labels + i);
  }
}

} // namespace HWY_NAMESPACE
} // namespace rgbd_planes
} // namespace pcl
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pcl {
namespace rgbd_planes {

HWY_EXPORT (countSidesHere);
HWY_EXPORT (splitPointsHere);
HWY_EXPORT (dropUnclearHere);

SideCounts
countSides (const PointBlock& points,
            const std::uint32_t* labels,
            std::uint32_t label,
            const PlaneEquation& plane,
            const PlaneEquation& other,
            const DepthNoise& tolerance)
{
  return HWY_DYNAMIC_DISPATCH (countSidesHere) (
      points, labels, label, plane, other, tolerance);
}

void
splitPoints (const PointBlock& points,
             std::uint32_t a,
             std::uint32_t b,
             const PlaneEquation* equations,
             const DepthNoise& tolerance,
             SeenPlane seen,
             std::uint32_t* labels)
{
  HWY_DYNAMIC_DISPATCH (splitPointsHere)
  (points, a, b, equations, tolerance, seen, labels);
}

void
dropUnclear (const PointBlock& points,
             std::uint32_t label,
             const PlaneEquation& plane,
             const PlaneEquation& other,
             const DepthNoise& tolerance,
             SeenPlane seen,
             std::uint32_t* labels)
{
  HWY_DYNAMIC_DISPATCH (dropUnclearHere)
  (points, label, plane, other, tolerance, seen, labels);
}

} // namespace rgbd_planes
} // namespace pcl
#endif
