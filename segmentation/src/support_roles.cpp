// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "image_lines.h"
#include "plane_levels.h"
#include "platform.h"

#include <algorithm>
#include <bitset>
#include <cstdint>
#include <numeric>
#include <utility>

namespace pcl {
namespace rgbd_planes {

// What a plane is to the others: one that lies on a thing, a platform, or one of the background.

namespace {

/** A plane is of the background if so much of it is on no supporting one, nor above. */
constexpr double background_share = 0.2;
/** It is also if it goes on from one side of the image to the other: a wall of which too little is
 * seen. That shows in so many points, and in so many parts of the image, of which those of margins
 * may have no points. Between things in a row there are gaps. */
constexpr std::size_t across_sample = 4000;
constexpr std::uint32_t parts_across = 60;
using PartsAcross = std::bitset<parts_across>;

/** The parts within the margins of an image of that size, \a first and \a last. */
PartsAcross
partsOfMargins (std::uint32_t first, std::uint32_t last, std::uint32_t size)
{
  PartsAcross parts;
  for (std::uint32_t i = 0; i < parts_across; ++i)
    parts[i] = (i + 1) * size <= first * parts_across ||
               (parts_across - i) * size <= last * parts_across;
  return parts;
}

/** Whether a plane goes on from one side of the image to the other. */
bool
goesAcross (const OrganizedPoints& points,
            const ImageMargins& margins,
            const pcl::Indices& inliers)
{
  if (inliers.size() < points.size() / parts_across)
    return false;
  const auto width = static_cast<std::uint32_t> (points.width),
             height = static_cast<std::uint32_t> (points.height);
  PartsAcross columns = partsOfMargins (margins.left, margins.right, width),
              rows = partsOfMargins (margins.above, margins.below, height);
  sampleIndices (inliers, across_sample, [&] (std::size_t index) {
    const auto i = static_cast<std::uint32_t> (index);
    columns.set (i % width * parts_across / width);
    rows.set (i / width * parts_across / height);
  });
  return columns.all() || rows.all();
}

/** Whether it is the front of a table: what supports is behind it, and it is no higher than things
 * that stand there. Its front may be in one plane with theirs. */
bool
isFrontOf (const SupportSurface& support,
           const OrganizedPoints& points,
           const SegmentedPlane& plane,
           float max_object_height)
{
  const auto& corners = support.outline.corners();
  const Eigen::Vector2f sum =
      std::accumulate (corners.begin(), corners.end(), Eigen::Vector2f (0.f, 0.f));
  const Eigen::Vector3f center =
      support.unproject (sum / static_cast<float> (corners.size()));
  return plane.plane.distance (center.data()) < 0.f && // normals face the sensor
         isShareAtLeast (nearly_all, points, *plane.inliers, [&] (const float* p) {
           return support.plane.distance (p) <= max_object_height &&
                  support.surroundings.contains (support.project (p));
         });
}

} // namespace

void
SupportPlanes::findBackground (const OrganizedPoints& points,
                               const std::vector<SegmentedPlane>& planes,
                               const ObjectParameters& parameters)
{
  background_.clear();
  margins_ = marginsOf (points);
  const auto supports = [&] (const SegmentedPlane& plane) {
    return std::any_of (
        supports_.begin(), supports_.end(), [&] (const SupportSurface& support) {
          return &planes[support.index] == &plane && !support.is_on_object;
        });
  };
  const auto isFront = [&] (const SegmentedPlane& plane) {
    return std::any_of (
        supports_.begin(), supports_.end(), [&] (const SupportSurface& support) {
          return !support.is_on_object &&
                 isFrontOf (support, points, plane, parameters.max_object_height);
        });
  };
  for (const auto& plane : planes) {
    const auto isAtOneOf = [&] (double share, Reach reach) {
      return isShareAtLeast (share, points, *plane.inliers, [&] (const float* p) {
        return std::any_of (
            supports_.begin(), supports_.end(), [&] (const SupportSurface& support) {
              return levelOf (p, support, reach, parameters) != Level::elsewhere;
            });
      });
    };
    const bool is_background =
        !isAtOneOf (1. - background_share, Reach::surroundings) ||
        !isAtOneOf (over_hull_share, Reach::outline) ||
        (!supports (plane) && goesAcross (points, margins_, *plane.inliers));
    if (is_background && !isFront (plane))
      background_.push_back (plane);
  }
}

void
SupportPlanes::markPlanesOnObjects (const OrganizedPoints& points,
                                    const std::vector<SegmentedPlane>& planes,
                                    const ObjectParameters& parameters)
{
  for (std::size_t k = supports_.size(); k-- > 0;) { // the lowest first
    const auto isOnLower = [&] (double share, Reach reach) {
      const auto& inliers = *planes[supports_[k].index].inliers;
      return isShareAtLeast (share, points, inliers, [&] (const float* p) {
        return std::any_of (supports_.begin() + static_cast<std::ptrdiff_t> (k) + 1,
                            supports_.end(),
                            [&] (const SupportSurface& lower) {
                              return !lower.is_on_object &&
                                     levelOf (p, lower, reach, parameters) !=
                                         Level::elsewhere;
                            });
      });
    };
    SupportSurface& support = supports_[k];
    const bool is_on_lower = isOnLower (majority, Reach::surroundings) &&
                             isOnLower (over_hull_share, Reach::outline);
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
                             SupportSurface& support)
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

} // namespace rgbd_planes
} // namespace pcl
