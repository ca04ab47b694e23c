// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "platform.h"
#include "point_sample.h"
#include "row_corners.h"

#include <pcl/segmentation/impl/support_planes.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr std::size_t ransac_points = 300;
/** Points further from a plane, in standard deviations of depth, do not agree with it. */
constexpr float ransac_sigmas = 1.5f;
constexpr std::size_t refit_points = 1000;
constexpr float refit_sigmas = 3.f;
/** Heights of planes are uncertain by so many standard deviations of depth. */
constexpr float height_sigmas = 3.f;
/** That of the floor may be off by so much, as the pose of the camera may be. */
constexpr float floor_tolerance = 0.05f;

/** How far a point is from \a plane, in standard deviations of its depth. */
float
sigmasFrom (const Plane& plane, const Eigen::Vector3f& p, const DepthNoise& noise)
{
  return std::fabs (plane.distance (p.data())) / noise.sigmaAtSquare (p.squaredNorm());
}

} // namespace

void
SupportPlanes::compute (const OrganizedPoints& points,
                        const std::vector<SegmentedPlane>& planes,
                        const Eigen::Affine3f& camera_to_base,
                        const ObjectParameters& parameters)
{
  rejections_ = {};
  findCandidates (points, planes, camera_to_base, parameters);
  const float lowest = lowestHeight (parameters);
  std::size_t count = 0;
  for (const Candidate& candidate : candidates_) {
    if (!(candidate.height >= lowest - candidate.noise)) {
      ++rejections_.too_low;
      continue;
    }
    supports_.resize (std::max (supports_.size(), count + 1));
    SupportSurface& support = supports_[count++];
    support.index = candidate.index;
    support.plane = candidate.plane;
    support.height = candidate.height;
    support.axis_x = support.plane.normal.unitOrthogonal();
    support.axis_y = support.plane.normal.cross (support.axis_x);
    outline (points,
             *planes[candidate.index].inliers,
             {},
             parameters,
             support,
             support.outline);
    findSurroundings (parameters, support);
  }
  supports_.resize (count);
  std::sort (supports_.begin(), supports_.end(), [] (const auto& a, const auto& b) {
    return a.height != b.height ? a.height > b.height : a.index < b.index;
  });
  markPlanesOnObjects (points, planes, parameters);
  for (SupportSurface& support : supports_)
    if (!support.is_on_object)
      support.warp.compute (points, *planes[support.index].inliers, support.plane);
  findBackground (points, planes, parameters);
}

void
SupportPlanes::findCandidates (const OrganizedPoints& points,
                               const std::vector<SegmentedPlane>& planes,
                               const Eigen::Affine3f& camera_to_base,
                               const ObjectParameters& parameters)
{
  const Eigen::Vector3f up = camera_to_base.linear().row (2);
  // That of pi / 2 as a float is less than 0.
  const float min_cosine = std::max (std::cos (parameters.horizontal_tolerance), 0.f);
  candidates_.clear();
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const bool is_level = planes[k].plane.normal.dot (up) >= min_cosine;
    if (!is_level || planes[k].inliers->empty()) {
      rejections_.not_level += !is_level;
      continue;
    }
    const Plane plane = optimise (points, planes[k], parameters.noise);
    const Eigen::Vector3f center = sample_.mean();
    const float height = up.dot (center) + camera_to_base.translation().z();
    const float noise =
        height_sigmas * parameters.noise.sigmaAtSquare (center.squaredNorm());
    if (!(plane.normal.dot (up) >= min_cosine))
      ++rejections_.not_level;
    else if (height > parameters.max_plane_height + noise)
      ++rejections_.too_high;
    else
      candidates_.push_back ({k, plane, height, noise});
  }
}

/** Where the range starts at z = 0 or below, it holds the plane that is nearest to z = 0. */
float
SupportPlanes::lowestHeight (const ObjectParameters& parameters) const
{
  float floor = floor_tolerance;
  for (const Candidate& candidate : candidates_)
    if (std::fabs (candidate.height) < std::fabs (floor))
      floor = candidate.height;
  return parameters.min_plane_height > 0.f
             ? parameters.min_plane_height
             : std::min (parameters.min_plane_height, floor);
}

Plane
SupportPlanes::optimise (const OrganizedPoints& points,
                         const SegmentedPlane& segmented,
                         const DepthNoise& noise)
{
  sample_.clear();
  samplePoints (points, *segmented.inliers, ransac_points, [&] (const auto& p) {
    sample_.add (p, ransac_sigmas * noise.sigmaAtSquare (p.squaredNorm()));
  });
  Plane best = segmented.plane;
  if (sample_.size() < 3)
    return best;
  best = sample_.planeOfMost (best);
  PlaneMoments moments;
  samplePoints (points, *segmented.inliers, refit_points, [&] (const auto& p) {
    const float squared_range = p.squaredNorm();
    const float sigma = noise.sigmaAtSquare (squared_range);
    if (std::fabs (best.distance (p.data())) < refit_sigmas * sigma)
      moments.add (p.data(), squared_range / (sigma * sigma));
  });
  const Eigen::Vector3d m = moments.inverseDistance();
  return m.allFinite() ? planeOf (m) : best;
}

/** The hull of the inliers that agree with the plane and are in a part of it. */
void
SupportPlanes::outline (const OrganizedPoints& points,
                        const pcl::Indices& inliers,
                        const MainPart& part,
                        const ObjectParameters& parameters,
                        const SupportSurface& support,
                        ConvexOutline& hull)
{
  border_.clear();
  const auto agrees = [&] (pcl::index_t index) {
    const float* p = points[static_cast<std::size_t> (index)];
    return isMeasured (p) &&
           sigmasFrom (support.plane,
                       Eigen::Map<const Eigen::Vector3f> (p),
                       parameters.noise) < refit_sigmas &&
           part.contains (support.project (p));
  };
  visitCornersOfRows (points, inliers, agrees, [&] (const float* p) {
    border_.push_back (support.project (p));
  });
  hull.compute (border_, parameters.hull_tolerance);
}

void
SupportPlanes::findSurroundings (const ObjectParameters& parameters,
                                 SupportSurface& support)
{
  border_ = support.outline.corners();
  support.surroundings.compute (border_,
                                parameters.hull_tolerance + parameters.max_overhang);
}

void
describe (const std::vector<SupportSurface>& supports,
          const Eigen::Vector3f& sensor,
          const PCLHeader& header,
          std::vector<SupportPlane>& planes)
{
  planes.resize (supports.size());
  for (std::size_t k = 0; k < supports.size(); ++k) {
    const SupportSurface& support = supports[k];
    SupportPlane& plane = planes[k];
    plane.index = support.index;
    const Plane seen = support.plane.shifted (sensor);
    plane.coefficients.header = header;
    plane.coefficients.values.assign (seen.normal.data(), seen.normal.data() + 3);
    plane.coefficients.values.push_back (seen.d);
    plane.hull.clear();
    for (const auto& corner : support.outline.corners())
      plane.hull.push_back (sensor + support.unproject (corner));
    plane.height = support.height;
    plane.is_on_object = support.is_on_object;
    plane.is_platform = support.is_platform;
  }
}

} // namespace rgbd_planes
} // namespace pcl
