// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/support_planes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <random>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr std::size_t ransac_points = 300;
constexpr int ransac_trials = 30;
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

/** How far a point is from \a plane, in standard deviations of its depth. */
float
sigmasFrom (const Plane& plane, const Eigen::Vector3f& p, const DepthNoise& noise)
{
  return std::fabs (plane.distance (p.data())) / noise.sigma (p.squaredNorm());
}

std::size_t
countAgreeing (const Plane& plane,
               const std::vector<Eigen::Vector3f>& sample,
               const DepthNoise& noise)
{
  return static_cast<std::size_t> (
      std::count_if (sample.begin(), sample.end(), [&] (const Eigen::Vector3f& p) {
        return sigmasFrom (plane, p, noise) < ransac_sigmas;
      }));
}

/** The plane through three points; its normal is NaN where they lie on a line. */
Plane
through (const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c)
{
  const Eigen::Vector3f cross = (b - a).cross (c - a);
  Plane plane{cross / cross.norm(), 0.f};
  plane.d = -plane.normal.dot (a);
  if (plane.d < 0.f)
    plane = {-plane.normal, -plane.d};
  return plane;
}

/** Calls use (p) for some \a count of the measured inliers, evenly spread. */
template <typename Use>
void
sampleInliers (const OrganizedPoints& points,
               const pcl::Indices& inliers,
               std::size_t count,
               const Use& use)
{
  const std::size_t step = std::max<std::size_t> (inliers.size() / count, 1);
  for (std::size_t i = 0; i < inliers.size(); i += step) {
    const float* p = points[static_cast<std::size_t> (inliers[i])];
    if (isMeasured (p))
      use (Eigen::Map<const Eigen::Vector3f> (p));
  }
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
  isNearlyAll () const
  {
    return static_cast<double> (part) >= nearly_all * static_cast<double> (all);
  }
};

/** The points of a decisive sample for which is_part (p) is true. */
template <typename IsPart>
Share
shareOf (const OrganizedPoints& points,
         const pcl::Indices& thing,
         const IsPart& is_part)
{
  Share share;
  sampleInliers (points, thing, decisive_sample, [&] (const auto& p) {
    ++share.all;
    share.part += is_part (p.data());
  });
  return share;
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
    Eigen::Vector3f center = Eigen::Vector3f::Zero();
    for (const auto& p : sample_)
      center += p / static_cast<float> (sample_.size());
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
    outline (points, *planes[k].inliers, parameters, support);
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
  for (const auto& plane : planes) {
    const auto isElsewhere = [&] (const float* p) {
      return std::all_of (
          supports_.begin(), supports_.end(), [&] (const SupportPlane& support) {
            return levelOf (p, support, parameters) == Level::elsewhere;
          });
    };
    if (shareOf (points, *plane.inliers, isElsewhere).isMost())
      background_.push_back (plane.plane);
  }
}

void
SupportPlanes::markPlanesOnObjects (const OrganizedPoints& points,
                                    const std::vector<SegmentedPlane>& planes,
                                    const ObjectParameters& parameters)
{
  for (std::size_t k = supports_.size(); k-- > 0;) { // the lowest first
    const auto isOnLower = [&] (const float* p) {
      return std::any_of (supports_.begin() + static_cast<std::ptrdiff_t> (k) + 1,
                          supports_.end(),
                          [&] (const SupportPlane& lower) {
                            return !lower.is_on_object &&
                                   levelOf (p, lower, parameters) != Level::elsewhere;
                          });
    };
    supports_[k].is_on_object =
        shareOf (points, *planes[supports_[k].index].inliers, isOnLower).isMost();
  }
}

Plane
SupportPlanes::optimise (const OrganizedPoints& points,
                         const SegmentedPlane& segmented,
                         const DepthNoise& noise)
{
  sample_.clear();
  sampleInliers (points, *segmented.inliers, ransac_points, [&] (const auto& p) {
    sample_.push_back (p);
  });
  Plane best = segmented.plane;
  if (sample_.size() < 3)
    return best;
  std::size_t most = countAgreeing (best, sample_, noise);
  std::minstd_rand random;
  const auto draw = [&] () -> const Eigen::Vector3f& {
    return sample_[random() % sample_.size()];
  };
  for (int trial = 0; trial < ransac_trials; ++trial) {
    const auto &a = draw(), &b = draw(), &c = draw();
    const Plane plane = through (a, b, c);
    const std::size_t agreeing = countAgreeing (plane, sample_, noise);
    if (agreeing > most) {
      most = agreeing;
      best = plane;
    }
  }
  PlaneMoments moments;
  sampleInliers (points, *segmented.inliers, refit_points, [&] (const auto& p) {
    const float squared_range = p.squaredNorm();
    const float sigma = noise.sigma (squared_range);
    if (std::fabs (best.distance (p.data())) < refit_sigmas * sigma)
      moments.add (p.data(), squared_range / (sigma * sigma));
  });
  const Eigen::Vector3d m = moments.inverseDistance();
  return m.allFinite() ? planeOf (m) : best;
}

void
SupportPlanes::outline (const OrganizedPoints& points,
                        const pcl::Indices& inliers,
                        const ObjectParameters& parameters,
                        SupportPlane& support)
{
  support.axis_x = support.plane.normal.unitOrthogonal();
  support.axis_y = support.plane.normal.cross (support.axis_x);
  // A pinhole camera sees convex things as convex: the corners of the hull are the first
  // or last points of their rows.
  border_.clear();
  const auto agrees = [&] (pcl::index_t index) {
    const float* p = points[static_cast<std::size_t> (index)];
    return isMeasured (p) && sigmasFrom (support.plane,
                                         Eigen::Map<const Eigen::Vector3f> (p),
                                         parameters.noise) < refit_sigmas;
  };
  for (auto row = inliers.begin(); row != inliers.end();) {
    const auto next_row = std::max (
        std::lower_bound (row, inliers.end(), (*row / points.width + 1) * points.width),
        row + 1);
    const auto first = std::find_if (row, next_row, agrees);
    if (first != next_row) {
      const auto last = std::find_if (std::make_reverse_iterator (next_row),
                                      std::make_reverse_iterator (first),
                                      agrees);
      border_.push_back (support.project (points[static_cast<std::size_t> (*first)]));
      border_.push_back (support.project (points[static_cast<std::size_t> (*last)]));
    }
    row = next_row;
  }
  support.outline.compute (border_, parameters.hull_tolerance);
}

bool
liesAbove (const OrganizedPoints& points,
           const pcl::Indices& thing,
           const SupportPlane& support,
           const ObjectParameters& parameters)
{
  const auto isAbove = [&] (const float* p) {
    return levelOf (p, support, parameters) == Level::above;
  };
  return shareOf (points, thing, isAbove).isNearlyAll();
}

bool
liesOnOneOf (const std::vector<Plane>& planes,
             const OrganizedPoints& points,
             const pcl::Indices& thing,
             const DepthNoise& noise)
{
  constexpr float sigmas = 3.f;
  std::array<Eigen::Vector3f, 2 * decisive_sample> sample;
  std::size_t size = 0;
  sampleInliers (
      points, thing, decisive_sample, [&] (const auto& p) { sample[size++] = p; });
  const auto may_be_off =
      static_cast<std::size_t> ((1. - nearly_all) * static_cast<double> (size));
  return std::any_of (planes.begin(), planes.end(), [&] (const Plane& plane) {
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
