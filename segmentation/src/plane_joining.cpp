// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "tile_bits.h"

#include <pcl/segmentation/impl/plane_joining.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl {
namespace rgbd_planes {

namespace {

/** By how much errors may grow when one plane stands for two, as a ratio of their root
 * mean squares, for two strips too; smaller ones than this many standard deviations count
 * as that. */
constexpr double max_growth = 2.6, max_strip_growth = 1.25, min_error = 0.8;
/** How far off the plane of the larger part the smaller one may lie in the mean, and how
 * well that has to be known, in standard deviations. */
constexpr double max_offset = 2.5, max_uncertainty = 0.5;
/** Two parts of one surface that is bent may be this far off, if it is known as well, on
 * the larger and on the smaller part, and if their normals are within 10 degrees. */
constexpr double max_bent_offset = 6., max_bent_uncertainty = 0.2,
                 max_bent_uncertainty_back = 1., min_bent_cosine = 0.985;
/** Where the larger part is known to so much on the smaller one, and the smaller one no better
 * than this on the larger one, only the plane of the larger one tells of a step. */
constexpr double certain = 0.1, uncertain = 0.25;
/** Less uncertainty than this part of the range is enough, however small that deviation is. */
constexpr double enough_certainty = 0.0005;
/** Strips are this many times as far from each other as they are wide. */
constexpr double min_widths_apart = 15.;
/** Of a part whose samples alternate with those of a plane, so many lie between two of them
 * in a row, and in a column; and the root mean square of its errors on that plane is
 * smaller, in standard deviations. */
constexpr double min_between = 0.15, max_error_of_alternate = 6.;
/** Errors that grow up to the limit of what a plane takes have this root mean square and more,
 * in standard deviations: noise goes on beyond. So few between others are enough then. */
constexpr double min_error_of_noisy = 1.35, min_between_of_noisy = 0.05;

/** By how much the mean squared error of either part grows on a plane of both; not finite
 * where there is none. */
double
growth (const FittedMoments& a, const FittedMoments& b)
{
  PlaneMoments both = a.moments;
  both += b.moments;
  const Eigen::Vector3d plane = both.inverseDistance();
  const auto growthOf = [&plane] (const FittedMoments& part) {
    return part.moments.meanSquaredError (plane) /
           std::max (part.squared_error, min_error * min_error);
  };
  return std::max (growthOf (a), growthOf (b));
}

/** How well it is known where the plane of a part meets the rays to another one. */
class Certainty {
public:
  Certainty (const FittedMoments& a, const FittedMoments& b)
  : of_points_ (static_cast<double> (b.moments.points) / b.moments.weight())
  {
    const Eigen::Vector3d mean = b.moments.mean();
    variance_ = mean.dot (a.inverse_of_second * mean);
  }

  /** To so many standard deviations. */
  bool
  isWithin (double uncertainty) const
  {
    return variance_ <= uncertainty * uncertainty * of_points_;
  }

  /** To so many standard deviations, or to a small part of the range. */
  bool
  isEnough (double uncertainty) const
  {
    return isWithin (uncertainty) || variance_ <= enough_certainty * enough_certainty;
  }

private:
  double of_points_;
  double variance_;
};

/** Whether both may be of one surface that the error of depth bends, which has no step
 * between them: that is in front from one side and behind from the other. */
bool
bends (const FittedMoments& larger,
       const FittedMoments& smaller,
       const Certainty& at_smaller,
       double offset)
{
  const Eigen::Vector3d &plane = larger.plane, &other = smaller.plane;
  if (plane.dot (other) < min_bent_cosine * plane.norm() * other.norm())
    return false;
  const Certainty at_larger (smaller, larger);
  if (at_smaller.isWithin (certain) && !at_larger.isWithin (uncertain))
    return true;
  if (!at_smaller.isEnough (max_bent_uncertainty) ||
      !at_larger.isEnough (max_bent_uncertainty_back))
    return false;
  const double back = larger.moments.meanError (other);
  return std::abs (back) <= max_offset || (back > 0.) == (offset > 0.);
}

/** Whether errors are so much larger than the model says that a plane does not take all. */
bool
isNoisy (const FittedMoments& points)
{
  return points.squared_error >= min_error_of_noisy * min_error_of_noisy;
}

/** The side of the square as wide as the points, across where they reach farthest. */
double
widthOf (const PlaneMoments& points)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect (points.covariance(), Eigen::EigenvaluesOnly);
  return std::sqrt (12. * std::max (solver.eigenvalues()[1], 0.));
}

/** 0 where the smaller part lies perfectly on the plane of the larger one, up to 1 where it may
 * be of that. */
double
mismatchOf (const FittedMoments& larger, const FittedMoments& smaller)
{
  const Certainty at_smaller (larger, smaller);
  if (!at_smaller.isEnough (max_uncertainty))
    return 2.;
  const double offset = smaller.moments.meanError (larger.plane);
  const double offset_limit =
      bends (larger, smaller, at_smaller, offset) ? max_bent_offset : max_offset;
  if (!(std::abs (offset) <= offset_limit))
    return 2.;
  return std::max (growth (larger, smaller) / (max_growth * max_growth),
                   std::abs (offset) / offset_limit);
}

} // namespace

FittedMoments::FittedMoments (const PlaneMoments& of)
: moments (of)
, inverse_of_second (of.second().inverse())
, plane (inverse_of_second * of.first())
, squared_error (of.meanSquaredError (plane))
{}

void
PlaneJoining::compute (const std::vector<PlaneMoments>& parts, bool join_parts)
{
  const auto joinOnce = [&] (const std::vector<PlaneMoments>& now) {
    join (now, [&] (std::size_t plane, std::size_t part) {
      return join_parts ? mismatchOf (fitted_planes_[plane], fitted_parts_[part]) : 2.;
    });
  };
  joinOnce (parts);
  // A plane of several parts is known better than those were.
  for (std::size_t before = parts.size(); planes_.size() < before;) {
    before = planes_.size();
    joined_.swap (planes_);
    joined_of_part_.swap (plane_of_part_);
    joinOnce (joined_);
    for (std::int32_t& plane : joined_of_part_)
      plane = plane_of_part_[static_cast<std::size_t> (plane)];
    joined_of_part_.swap (plane_of_part_);
  }
}

void
PlaneJoining::computeSides (const std::vector<PlaneMoments>& parts,
                            const std::vector<bool>& are_sides)
{
  const auto hasSide = [&] (std::size_t plane) {
    for (std::size_t part = 0; part < parts.size(); ++part)
      if (are_sides[part] && plane_of_part_[part] == static_cast<std::int32_t> (plane))
        return true;
    return false;
  };
  join (parts, [&] (std::size_t plane, std::size_t part) {
    return are_sides[part] && hasSide (plane)
               ? 2.
               : mismatchOf (fitted_planes_[plane], fitted_parts_[part]);
  });
}

void
PlaneJoining::computeStrips (const std::vector<PlaneMoments>& parts)
{
  widths_.resize (parts.size());
  std::transform (parts.begin(), parts.end(), widths_.begin(), widthOf);
  join (parts, [&] (std::size_t plane, std::size_t part) {
    const FittedMoments &a = fitted_planes_[plane], &b = fitted_parts_[part];
    const double apart =
        (a.moments.mean() - b.moments.mean()).norm() / min_widths_apart;
    if (!(apart >= widths_[part] && apart >= widthOf (a.moments)))
      return 2.;
    return growth (a, b) / (max_strip_growth * max_strip_growth);
  });
}

void
PlaneJoining::computeAlternating (const std::vector<PlaneMoments>& parts,
                                  const std::vector<TilePart>& tile_parts)
{
  findBetween (tile_parts);
  join (parts, [&] (std::size_t plane, std::size_t part) {
    const auto [first, last] =
        std::equal_range (between_.begin(), between_.end(), Between{part}, byPart);
    std::size_t in_row = 0, in_column = 0;
    for (auto now = first; now != last; ++now)
      if (plane_of_part_[now->of] == static_cast<std::int32_t> (plane)) {
        in_row += now->in_row;
        in_column += now->in_column;
      }
    const double between = static_cast<double> (std::min (in_row, in_column)) /
                           static_cast<double> (parts[part].points);
    if (between < min_between_of_noisy ||
        (between < min_between &&
         !(isNoisy (fitted_planes_[plane]) && isNoisy (fitted_parts_[part]))))
      return 2.;
    return parts[part].meanSquaredError (fitted_planes_[plane].plane) /
           (max_error_of_alternate * max_error_of_alternate);
  });
}

/** Counts the samples of parts that lie between those of others. */
void
PlaneJoining::findBetween (const std::vector<TilePart>& tile_parts)
{
  between_.clear();
  for (auto first = tile_parts.begin(), last = first; first != tile_parts.end();
       first = last) {
    while (last != tile_parts.end() && last->tile == first->tile)
      ++last;
    for (auto of = first; last - first > 1 && of != last; ++of) {
      const MovedSamples beside = movedSamples (of->own);
      const unsigned between_in_row = beside.left & beside.right,
                     between_in_column = beside.up & beside.down;
      for (auto part = first; part != last; ++part) {
        const std::size_t in_row = count (part->own & between_in_row),
                          in_column = count (part->own & between_in_column);
        if (part != of && in_row + in_column > 0)
          between_.push_back ({part->plane, of->plane, in_row, in_column});
      }
    }
  }
  std::sort (between_.begin(), between_.end(), byPart);
}

template <typename Mismatch>
void
PlaneJoining::join (const std::vector<PlaneMoments>& parts, const Mismatch& mismatch)
{
  order_.resize (parts.size());
  std::iota (order_.begin(), order_.end(), std::size_t{0});
  std::sort (order_.begin(), order_.end(), [&] (std::size_t a, std::size_t b) {
    return parts[a].points != parts[b].points ? parts[a].points > parts[b].points
                                              : a < b;
  });
  fitted_parts_.clear();
  for (const PlaneMoments& part : parts)
    fitted_parts_.emplace_back (part);
  fitted_planes_.clear();
  planes_.clear();
  plane_of_part_.assign (parts.size(), -1);
  for (const std::size_t part : order_) {
    double least = 1.;
    std::size_t best = planes_.size();
    for (std::size_t k = 0; k < planes_.size(); ++k) {
      const double now = mismatch (k, part);
      if (now <= least) {
        least = now;
        best = k;
      }
    }
    plane_of_part_[part] = static_cast<std::int32_t> (best);
    if (best == planes_.size()) {
      planes_.push_back (parts[part]);
      fitted_planes_.push_back (fitted_parts_[part]);
    }
    else {
      planes_[best] += parts[part];
      fitted_planes_[best] = FittedMoments (planes_[best]);
    }
  }
}

} // namespace rgbd_planes
} // namespace pcl
