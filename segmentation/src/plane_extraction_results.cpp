// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "uneven_surface.h"

#include <pcl/segmentation/impl/plane_extraction.h>

#include <algorithm>
#include <numeric>

namespace pcl {
namespace rgbd_planes {

namespace {

/** The mean square of the errors of points on a curved surface, in standard deviations,
 * is larger. */
constexpr double min_error_if_curved = 0.45;
/** Planes with such a part of all measured points are floors, walls and tables rather than clothes:
 * of the least share of near normals, this one is enough on them. */
constexpr std::size_t part_of_large = 10;
constexpr double enough_if_large = 0.5;
/** Noise must leave the direction of a plane certain to so many radians; in images of so few rows
 * or columns to less, for there, where some points in a line fit a plane by chance, these alone
 * seem certain of it. */
constexpr double max_error = 0.5, max_error_in_few_rows = 0.04;
constexpr int few_rows = 4;

} // namespace

/** Whether the plane is part of a curved surface, or lies in an uneven one, and the points
 * that it got in the end are not those of a flat one. */
bool
PlaneExtraction::isPatch (std::size_t plane) const
{
  const PlaneMoments& points = assignment_.weightedMoments()[plane];
  const double error = points.meanSquaredError (points.inverseDistance());
  if (!parameters_.additions.patches)
    return false;
  if (patches_.isPatch (plane) && error > min_error_if_curved)
    return true;
  if (!parameters_.additions.assignment)
    return false;
  const auto isIn = [&] (double min_near_normals) {
    return isUneven (points, error, assignment_.nearNormals (plane), min_near_normals);
  };
  const double least = parameters_.min_near_normals;
  return isIn (least) && (isIn (enough_if_large * least) || !isLarge (points));
}

bool
PlaneExtraction::isLarge (const PlaneMoments& points) const
{
  const auto measured = static_cast<std::size_t> (
      std::count_if (samples_.weight.begin(), samples_.weight.end(), [] (float weight) {
        return weight > 0.f;
      }));
  const auto pixels = static_cast<std::size_t> (samples_.step * samples_.step);
  return part_of_large * points.points >= measured * pixels;
}

/** Drops planes that too few points determine, sorts the others, and fits them. */
void
PlaneExtraction::finish (const OrganizedPoints& points)
{
  const auto& sums = assignment_.moments();
  order_.resize (sums.size());
  std::iota (order_.begin(), order_.end(), 0u);
  const std::size_t min_points = std::max<std::size_t> (parameters_.min_inliers, 3);
  const auto dropWhere = [&] (const auto& is_dropped) {
    const auto end = std::remove_if (order_.begin(), order_.end(), is_dropped);
    const auto dropped = static_cast<std::size_t> (order_.end() - end);
    order_.erase (end, order_.end());
    return dropped;
  };
  const double error = std::min (points.width, points.height) > few_rows
                           ? max_error
                           : max_error_in_few_rows;
  // What StepSplit joined to another plane is left without points.
  dropWhere ([&] (std::uint32_t k) { return moments_[k].points == 0; });
  rejections_.too_few_points += dropWhere ([&] (std::uint32_t k) {
    return sums[k].points < min_points ||
           !assignment_.weightedMoments()[k].determinePlane (error);
  });
  rejections_.curved += dropWhere ([&] (std::uint32_t k) {
    return isPatch (k) || sums[k].curvature() > parameters_.maximum_curvature;
  });
  std::sort (order_.begin(), order_.end(), [&] (std::uint32_t a, std::uint32_t b) {
    return sums[a].points != sums[b].points ? sums[a].points > sums[b].points : a < b;
  });

  numbers_.assign (sums.size(), unlabelled);
  planes_.clear();
  moments_.clear();
  parameter_covariances_.clear();
  for (const std::uint32_t k : order_) {
    numbers_[k] = static_cast<std::uint32_t> (moments_.size());
    const PlaneMoments& weighted = assignment_.weightedMoments()[k];
    const Eigen::Vector3d m = weighted.inverseDistance();
    planes_.push_back (planeOf (m));
    moments_.push_back (sums[k]);
    parameter_covariances_.push_back (parameterCovariance (weighted, m));
  }
  runs_.find (assignment_.labels(), static_cast<std::size_t> (points.width), numbers_);
}

} // namespace rgbd_planes
} // namespace pcl
