// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "image_lines.h"
#include "platform.h"
#include "point_sample.h"
#include "row_corners.h"

#include <pcl/segmentation/support_planes.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstdint>
#include <utility>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Where a point is with respect to a supporting plane. */
enum class Level { elsewhere, on_plane, above };

/** How far a plane reaches. */
enum class Reach { outline, surroundings };

/** Whether \a p lies on a plane, or up to the largest height of an object above it, in
 * both cases where the plane reaches. */
Level
levelOf (const float* p,
         const SupportPlane& support,
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

constexpr std::size_t ransac_points = 300;
/** Points further from a plane, in standard deviations of depth, do not agree with it. */
constexpr float ransac_sigmas = 1.5f;
constexpr std::size_t refit_points = 1000;
constexpr float refit_sigmas = 3.f;
/** Heights of planes are uncertain by so many standard deviations of depth: the floor is
 * within a range that starts at 0. */
constexpr float height_sigmas = 3.f;

/** So many points of a thing tell where most of it is. */
constexpr std::size_t decisive_sample = 100;
constexpr double nearly_all = 0.9;
/** A plane is of the background if so much of it is on no supporting one, nor above. */
constexpr double background_share = 0.2;
/** It is also if it goes on from one side of the image to the other: a wall of which too little is
 * seen. That shows in so many points, and in so many parts of the image, of which those next to the
 * border may have no points. Between things in a row there are gaps. */
constexpr std::size_t across_sample = 4000;
constexpr int parts_across = 60, margin = parts_across / part_of_margin;

/** How far a point is from \a plane, in standard deviations of its depth. */
float
sigmasFrom (const Plane& plane, const Eigen::Vector3f& p, const DepthNoise& noise)
{
  return std::fabs (plane.distance (p.data())) / noise.sigma (p.squaredNorm());
}

struct Share {
  std::size_t part = 0;
  std::size_t all = 0;

  bool
  isMost () const
  {
    return 2 * part > all;
  }

  bool
  isAtLeast (double share) const
  {
    return static_cast<double> (part) >= share * static_cast<double> (all);
  }
};

/** The points of a decisive sample for which is_part (p) is true. */
template <typename Thing, typename IsPart>
Share
shareOf (const OrganizedPoints& points, const Thing& thing, const IsPart& is_part)
{
  Share share;
  samplePoints (points, thing, decisive_sample, [&] (const auto& p) {
    ++share.all;
    share.part += is_part (p.data());
  });
  return share;
}

/** Whether a plane goes on from one side of the image to the other. */
bool
goesAcross (const OrganizedPoints& points, const pcl::Indices& inliers)
{
  if (inliers.size() < points.size() / parts_across)
    return false;
  std::bitset<parts_across> columns, rows;
  for (int i = 0; i < margin; ++i)
    for (auto* parts : {&columns, &rows}) {
      parts->set (static_cast<std::size_t> (i));
      parts->set (static_cast<std::size_t> (parts_across - 1 - i));
    }
  const auto width = static_cast<std::uint32_t> (points.width),
             height = static_cast<std::uint32_t> (points.height);
  sampleIndices (inliers, across_sample, [&] (std::size_t index) {
    const auto i = static_cast<std::uint32_t> (index);
    columns.set (i % width * parts_across / width);
    rows.set (i / width * parts_across / height);
  });
  return columns.all() || rows.all();
}

} // namespace

void
SupportPlanes::compute (const OrganizedPoints& points,
                        const std::vector<SegmentedPlane>& planes,
                        const Eigen::Affine3f& camera_to_base,
                        const ObjectParameters& parameters)
{
  const Eigen::Vector3f up = camera_to_base.linear().row (2);
  const float camera_height = camera_to_base.translation().z();
  const float min_cosine = std::cos (parameters.horizontal_tolerance);
  std::size_t count = 0;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    if (!(planes[k].plane.normal.dot (up) >= min_cosine) || planes[k].inliers->empty())
      continue;
    const Plane plane = optimise (points, planes[k], parameters.noise);
    const Eigen::Vector3f center = sample_.mean();
    const float height = up.dot (center) + camera_height;
    const float noise = height_sigmas * parameters.noise.sigma (center.squaredNorm());
    if (!(plane.normal.dot (up) >= min_cosine) ||
        !(height >= parameters.min_plane_height - noise &&
          height <= parameters.max_plane_height + noise))
      continue;
    supports_.resize (std::max (supports_.size(), count + 1));
    SupportPlane& support = supports_[count++];
    support.index = k;
    support.plane = plane;
    support.height = height;
    support.axis_x = support.plane.normal.unitOrthogonal();
    support.axis_y = support.plane.normal.cross (support.axis_x);
    outline (points, *planes[k].inliers, {}, parameters, support, support.outline);
    findSurroundings (parameters, support);
  }
  supports_.resize (count);
  std::sort (supports_.begin(), supports_.end(), [] (const auto& a, const auto& b) {
    return a.height != b.height ? a.height > b.height : a.index < b.index;
  });
  markPlanesOnObjects (points, planes, parameters);
  for (SupportPlane& support : supports_)
    if (!support.is_on_object)
      support.warp.compute (points, *planes[support.index].inliers, support.plane);
  findBackground (points, planes, parameters);
}

void
SupportPlanes::findBackground (const OrganizedPoints& points,
                               const std::vector<SegmentedPlane>& planes,
                               const ObjectParameters& parameters)
{
  background_.clear();
  const auto supports = [&] (const SegmentedPlane& plane) {
    return std::any_of (
        supports_.begin(), supports_.end(), [&] (const SupportPlane& support) {
          return &planes[support.index] == &plane && !support.is_on_object;
        });
  };
  for (const auto& plane : planes) {
    const auto isAtOneOf = [&] (Reach reach) {
      return shareOf (points, *plane.inliers, [&] (const float* p) {
        return std::any_of (
            supports_.begin(), supports_.end(), [&] (const SupportPlane& support) {
              return levelOf (p, support, reach, parameters) != Level::elsewhere;
            });
      });
    };
    if (!isAtOneOf (Reach::surroundings).isAtLeast (1. - background_share) ||
        !isAtOneOf (Reach::outline).isAtLeast (over_hull_share) ||
        (!supports (plane) && goesAcross (points, *plane.inliers)))
      background_.push_back (plane);
  }
}

void
SupportPlanes::markPlanesOnObjects (const OrganizedPoints& points,
                                    const std::vector<SegmentedPlane>& planes,
                                    const ObjectParameters& parameters)
{
  for (std::size_t k = supports_.size(); k-- > 0;) { // the lowest first
    const auto isOnLower = [&] (Reach reach) {
      const auto& inliers = *planes[supports_[k].index].inliers;
      return shareOf (points, inliers, [&] (const float* p) {
        return std::any_of (supports_.begin() + static_cast<std::ptrdiff_t> (k) + 1,
                            supports_.end(),
                            [&] (const SupportPlane& lower) {
                              return !lower.is_on_object &&
                                     levelOf (p, lower, reach, parameters) !=
                                         Level::elsewhere;
                            });
      });
    };
    SupportPlane& support = supports_[k];
    const bool is_on_lower = isOnLower (Reach::surroundings).isMost() &&
                             isOnLower (Reach::outline).isAtLeast (over_hull_share);
    support.is_platform =
        is_on_lower &&
        makePlatform (points, *planes[support.index].inliers, parameters, support);
    support.is_on_object = is_on_lower && !support.is_platform;
  }
}

/** Gives it the outline of its main part, if that is one of a platform. */
bool
SupportPlanes::makePlatform (const OrganizedPoints& points,
                             const pcl::Indices& inliers,
                             const ObjectParameters& parameters,
                             SupportPlane& support)
{
  if (!isLargerThanTops (support.outline, parameters.max_object_height))
    return false;
  MainPart part;
  part.compute (points, inliers, support);
  outline (points, inliers, part, parameters, support, main_outline_);
  if (!isLargerThanTops (main_outline_, parameters.max_object_height) ||
      !isClosed (points, inliers, support, main_outline_, parameters.noise))
    return false;
  std::swap (support.outline, main_outline_);
  findSurroundings (parameters, support);
  return true;
}

Plane
SupportPlanes::optimise (const OrganizedPoints& points,
                         const SegmentedPlane& segmented,
                         const DepthNoise& noise)
{
  sample_.clear();
  samplePoints (points, *segmented.inliers, ransac_points, [&] (const auto& p) {
    sample_.add (p, ransac_sigmas * noise.sigma (p.squaredNorm()));
  });
  Plane best = segmented.plane;
  if (sample_.size() < 3)
    return best;
  best = sample_.planeOfMost (best);
  PlaneMoments moments;
  samplePoints (points, *segmented.inliers, refit_points, [&] (const auto& p) {
    const float squared_range = p.squaredNorm();
    const float sigma = noise.sigma (squared_range);
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
                        const SupportPlane& support,
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
                                 SupportPlane& support)
{
  border_ = support.outline.corners();
  support.surroundings.compute (border_,
                                parameters.hull_tolerance + parameters.max_overhang);
}

bool
liesAbove (const OrganizedPoints& points,
           const std::vector<PointRun>& thing,
           const SupportPlane& support,
           const ObjectParameters& parameters)
{
  const auto shareAt = [&] (bool or_on_plane) {
    return shareOf (points, thing, [&] (const float* p) {
      const Level level = levelOf (p, support, Reach::outline, parameters);
      return level == Level::above || (or_on_plane && level == Level::on_plane);
    });
  };
  return shareAt (true).isAtLeast (nearly_all) && shareAt (false).isMost();
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
