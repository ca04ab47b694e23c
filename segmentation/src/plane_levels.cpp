// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_levels.h"

#include <algorithm>
#include <array>

namespace pcl {
namespace rgbd_planes {

Level
levelOf (const float* p,
         const SupportSurface& support,
         Reach reach,
         const ObjectParameters& parameters)
{
  const float height = support.plane.distance (p);
  const auto& outline =
      reach == Reach::outline ? support.outline : support.surroundings;
  if (height > parameters.max_object_height || height < -parameters.max_object_height ||
      !outline.contains (support.project (p)))
    return Level::elsewhere;
  if (mayBeOnPlane (p, support.plane, height, parameters))
    return Level::on_plane;
  return height > 0.f ? Level::above : Level::elsewhere;
}

bool
liesAbove (const OrganizedPoints& points,
           const std::vector<PointRun>& thing,
           const SupportSurface& support,
           const ObjectParameters& parameters)
{
  const auto isAbove = [&] (double share, bool or_on_plane) {
    return isShareAtLeast (share, points, thing, [&] (const float* p) {
      const Level level = levelOf (p, support, Reach::outline, parameters);
      return level == Level::above || (or_on_plane && level == Level::on_plane);
    });
  };
  return isAbove (nearly_all, true) && isAbove (majority, false);
}

bool
liesOnOneOf (const std::vector<SegmentedPlane>& planes,
             const OrganizedPoints& points,
             const std::vector<PointRun>& thing,
             const DepthNoise& noise)
{
  constexpr float sigmas = 3.f;
  std::array<Eigen::Vector3f, 2 * decisive_sample> sample;
  std::size_t size = 0;
  samplePoints (
      points, thing, decisive_sample, [&] (const auto& p) { sample[size++] = p; });
  const auto may_be_off =
      static_cast<std::size_t> ((1. - nearly_all) * static_cast<double> (size));
  return std::any_of (
      planes.begin(), planes.end(), [&] (const SegmentedPlane& segmented) {
        const Plane& plane = segmented.plane;
        std::size_t off = 0;
        for (std::size_t i = 0; i < size && off <= may_be_off; ++i) {
          const float* p = sample[i].data();
          off += !isWithinNoise (p, plane, plane.distance (p), sigmas, noise);
        }
        return off <= may_be_off;
      });
}

} // namespace rgbd_planes
} // namespace pcl
