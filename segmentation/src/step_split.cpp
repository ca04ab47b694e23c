// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "each_bit.h"

#include <pcl/segmentation/impl/step_split.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Errors are in thirds of the distance that points may have, which are standard deviations
 * of depth unless these are said to be smaller than those of single points. */
constexpr float reach = 3.f;
/** The sensor bends planes with more of the samples of the image, so that their errors are
 * larger without a step as well. */
constexpr double large_share = 0.08;
/** The error of what lies on a plane, and of those points of it that a tilted plane missed. */
constexpr double max_error = 1.5, max_missed_error = 2.5;
/** These are not more than such a part of it. */
constexpr double max_missed = 0.05;

/** The other plane that fits best to the points of a side, if their error is less than
 * \a most; or else \a own. */
std::size_t
planeUnder (const PlaneMoments& side,
            const std::vector<PlaneMoments>& planes,
            std::size_t own,
            double most)
{
  std::size_t best = own;
  double least = most * most;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const double error = side.meanSquaredError (planes[k].inverseDistance());
    if (k != own && error < least) {
      least = error;
      best = k;
    }
  }
  return best;
}

/** Small planes that lie on one whose step was taken join it: it was tilted, and missed
 * them. They are left without samples.
 * \return whether there are any */
bool
joinWhatLiesOn (std::size_t plane,
                double most,
                std::vector<std::int32_t>& owners,
                std::vector<PlaneMoments>& planes)
{
  bool is_any = false;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    if (static_cast<double> (planes[k].points) >
        max_missed * static_cast<double> (planes[plane].points))
      continue;
    if (!(planes[k].meanSquaredError (planes[plane].inverseDistance()) < most * most))
      continue;
    is_any = true;
    planes[plane] += planes[k];
    planes[k] = {};
    std::replace (owners.begin(),
                  owners.end(),
                  static_cast<std::int32_t> (k),
                  static_cast<std::int32_t> (plane));
  }
  return is_any;
}

} // namespace

void
StepSplit::compute (const PlaneSamples& samples,
                    std::size_t min_side,
                    float max_sigmas,
                    std::vector<std::int32_t>& owners,
                    std::vector<TilePart>& parts,
                    std::vector<PlaneMoments>& planes)
{
  const double large = large_share * samples.width * samples.height;
  const float unit = max_sigmas / reach;
  are_sides_.assign (planes.size(), false);
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const bool is_large = static_cast<double> (planes[k].points) > large;
    const Limits limits = is_large ? Limits{1.15, 0.9, 3} : Limits{0.8, 0.95, 1};
    int steps = 0;
    while (steps < limits.max_steps &&
           splitOnce (samples, k, min_side, limits, unit, owners, parts, planes))
      ++steps;
    if (is_large && steps > 0 &&
        joinWhatLiesOn (k, max_missed_error * unit, owners, planes))
      findTileParts (owners, parts);
  }
}

/** Whether the plane has a step; its smaller side is taken from it. */
bool
StepSplit::splitOnce (const PlaneSamples& samples,
                      std::size_t k,
                      std::size_t min_side,
                      const Limits& limits,
                      float unit,
                      std::vector<std::int32_t>& owners,
                      std::vector<TilePart>& parts,
                      std::vector<PlaneMoments>& planes)
{
  const Eigen::Vector3d m = planes[k].inverseDistance();
  const double least = limits.min_error * unit;
  if (!(planes[k].meanSquaredError (m) >= least * least))
    return false;
  collect (samples, parts, static_cast<std::uint32_t> (k), m, unit);
  GridLine step;
  if (!finder_.find (errors_, min_side, step, limits.max_left))
    return false;
  PlaneMoments sides[2];
  for (const SampleError& e : errors_) {
    const float p[] = {samples.x[e.sample], samples.y[e.sample], samples.z[e.sample]};
    sides[step.isBehind (e.u, e.v)].add (p, samples.weight[e.sample]);
  }
  const std::size_t smaller = sides[1].points < sides[0].points;
  if (!sides[0].inverseDistance().allFinite() ||
      !sides[1].inverseDistance().allFinite())
    return false;
  std::size_t owner = planeUnder (sides[smaller], planes, k, max_error * unit);
  if (owner == k) {
    owner = planes.size();
    planes.emplace_back();
    are_sides_.emplace_back();
  }
  are_sides_[owner] = are_sides_[k] = true;
  planes[owner] += sides[smaller];
  planes[k] = sides[1 - smaller];
  for (const SampleError& e : errors_)
    if (step.isBehind (e.u, e.v) == (smaller == 1))
      owners[e.sample] = static_cast<std::int32_t> (owner);
  findTileParts (owners, parts);
  return true;
}

/** Lists the samples of a plane, and how far they are off m * p = 1. */
void
StepSplit::collect (const PlaneSamples& samples,
                    const std::vector<TilePart>& parts,
                    std::uint32_t plane,
                    const Eigen::Vector3d& m,
                    float unit)
{
  const Eigen::Vector3f plane_m = m.cast<float>();
  errors_.clear();
  for (const TilePart& part : parts) {
    if (part.plane != plane)
      continue;
    forEachBit (part.own, [&] (std::size_t bit) {
      const std::size_t i = part.tile * PlaneSamples::tile_size + bit;
      const auto [u, v] = samples.placeOf (i);
      const Eigen::Vector3f p (samples.x[i], samples.y[i], samples.z[i]);
      // In place: copies of what was written in parts just before stall.
      errors_.emplace_back() = {u,
                                v,
                                (plane_m.dot (p) - 1.f) *
                                    std::sqrt (samples.weight[i]) / unit,
                                static_cast<std::uint32_t> (i)};
    });
  }
}

} // namespace rgbd_planes
} // namespace pcl
