// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "image_lines.h"
#include "plane_levels.h"
#include "platform.h"

#include <algorithm>
#include <bitset>
#include <cstdint>
#include <utility>

namespace pcl {
namespace rgbd_planes {

// What a plane is to the others: one that lies on a thing, a platform, or one of the background.

namespace {

/** A plane is of the background if so much of it is on no supporting one, nor above. */
constexpr double background_share = 0.2;
/** It is also if it goes on from one side of the image to the other: a wall of which too little is
 * seen. That shows in so many points, and in so many parts of the image, of which those next to the
 * border may have no points. Between things in a row there are gaps. */
constexpr std::size_t across_sample = 4000;
constexpr int parts_across = 60, margin = parts_across / part_of_margin;

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

} // namespace rgbd_planes
} // namespace pcl
