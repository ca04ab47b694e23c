// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/plane_extraction.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Cells of the normal-space grid hold at least this share of all points. */
constexpr double min_cell_share = 1e-4;
/** Points with less than this share of the maximum curvature are flat. */
constexpr float flat_share = 0.1f;
/** A cluster needs this share of min_inliers to become a candidate. */
constexpr double min_candidate_share = 0.25;
/** Planes are joined up to this share of the distance threshold, as rms. */
constexpr double max_rms_share = 2. / 3.;

double
secondsSince (std::chrono::steady_clock::time_point& start)
{
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::duration<double> elapsed = now - start;
  start = now;
  return elapsed.count();
}

} // namespace

void
PlaneExtraction::compute (const OrganizedPoints& points,
                          const OrganizedNormals& normals,
                          const std::vector<std::uint8_t>& selected,
                          const PlaneExtractionParameters& parameters)
{
  parameters_ = parameters;
  auto start = std::chrono::steady_clock::now();
  markUse (points, normals, selected);
  const auto size = static_cast<double> (points.size());
  normal_clusters_.compute (normals,
                            use_,
                            static_cast<float> (parameters.angular_threshold),
                            static_cast<std::size_t> (min_cell_share * size));
  times_.normal_space = secondsSince (start);

  const auto min_candidate = static_cast<std::size_t> (
      min_candidate_share * static_cast<double> (parameters.min_inliers));
  distance_clusters_.compute (points,
                              normal_clusters_,
                              static_cast<float> (parameters.distance_threshold),
                              min_candidate);
  times_.distance_space = secondsSince (start);

  fitCandidates (points);
  refine (points, normals);
  parameter_covariances_.assign (planes_.size(), Eigen::Matrix4d::Zero());
  times_.refinement = secondsSince (start);
}

void
PlaneExtraction::markUse (const OrganizedPoints& points,
                          const OrganizedNormals& normals,
                          const std::vector<std::uint8_t>& selected)
{
  use_.assign (points.size(), 0);
  for (std::size_t i = 0; i < use_.size(); ++i) {
    const float* p = points[i];
    // Points so far away that their squared range overflows are no measurements either.
    if ((!selected.empty() && !selected[i]) || !isMeasured (p) ||
        !std::isfinite (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]))
      continue;
    use_[i] = measured;
    const float* normal = normals.normal + i * normals.stride;
    if (!std::isfinite (normal[0] + normal[1] + normal[2]))
      continue;
    const float curvature = normals.curvature[i * normals.stride];
    if (!(curvature > parameters_.maximum_curvature))
      use_[i] |= clustered;
    if (!(curvature > flat_share * parameters_.maximum_curvature))
      use_[i] |= trusted_normal;
  }
}

void
PlaneExtraction::fitCandidates (const OrganizedPoints& points)
{
  const auto& clusters = distance_clusters_.labels();
  labels_.resize (clusters.size());
  std::transform (
      clusters.begin(), clusters.end(), labels_.begin(), [] (std::int32_t cluster) {
        return cluster == NormalSpaceClusters::none
                   ? unlabelled
                   : static_cast<std::uint32_t> (cluster);
      });
  sumMoments (points, distance_clusters_.size(), Weights::inverse_variances);
  keepPlanes (1);
  joinCoplanar();
}

/** Joins planes to the first larger one that explains them: the mean squared distance
 * of their points to it, in variances of depth, is that of points on the plane. */
void
PlaneExtraction::joinCoplanar()
{
  const double max_variances =
      max_rms_share * max_rms_share * maxSigmas() * maxSigmas();
  std::vector<std::uint32_t> joined (planes_.size());
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    joined[i] = static_cast<std::uint32_t> (i);
    for (std::size_t larger = 0; larger < i; ++larger)
      if (joined[larger] == larger &&
          moments_[i].squaredDistances (planes_[larger]) <=
              max_variances * static_cast<double> (moments_[i].points)) {
        joined[i] = static_cast<std::uint32_t> (larger);
        moments_[larger] += moments_[i];
        moments_[i] = PlaneMoments{};
        break;
      }
  }
  for (std::uint32_t& label : labels_)
    if (label != unlabelled)
      label = joined[label];
  keepPlanes (1);
}

void
PlaneExtraction::refine (const OrganizedPoints& points, const OrganizedNormals& normals)
{
  const auto assign = [&] (PlaneAssignment::Preference preference) {
    assignment_.assign (points,
                        normals,
                        use_,
                        planes_,
                        parameters_.noise,
                        maxSigmas(),
                        preference,
                        labels_);
    sumMoments (points, planes_.size(), Weights::inverse_variances);
    keepPlanes (parameters_.min_inliers);
  };
  assign (PlaneAssignment::Preference::first);
  joinCoplanar();
  assign (PlaneAssignment::Preference::nearest);
  sumMoments (points, planes_.size(), Weights::ones);
}

void
PlaneExtraction::sumMoments (const OrganizedPoints& points,
                             std::size_t planes,
                             Weights weights)
{
  moments_.assign (planes, PlaneMoments{});
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (labels_[i] == unlabelled)
      continue;
    const float* p = points[i];
    double weight = 1.;
    if (weights == Weights::inverse_variances) {
      const double sigma =
          parameters_.noise.sigma (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
      weight = 1. / (sigma * sigma);
    }
    moments_[labels_[i]].add (p, weight);
  }
}

/** Fits the planes that have enough points, orders them by size, and relabels the
 * points. */
void
PlaneExtraction::keepPlanes (std::size_t min_points)
{
  std::vector<std::size_t> order (moments_.size());
  std::iota (order.begin(), order.end(), std::size_t{0});
  order.erase (std::remove_if (order.begin(),
                               order.end(),
                               [&] (std::size_t k) {
                                 return moments_[k].points <
                                        std::max (min_points, std::size_t{3});
                               }),
               order.end());
  std::stable_sort (order.begin(), order.end(), [&] (std::size_t a, std::size_t b) {
    return moments_[a].points > moments_[b].points;
  });

  std::vector<std::uint32_t> renumbered (moments_.size(), unlabelled);
  std::vector<PlaneMoments> kept;
  planes_.clear();
  for (const std::size_t k : order) {
    renumbered[k] = static_cast<std::uint32_t> (kept.size());
    kept.push_back (moments_[k]);
    planes_.push_back (moments_[k].fit());
  }
  moments_ = std::move (kept);
  for (std::uint32_t& label : labels_)
    if (label != unlabelled)
      label = renumbered[label];
}

float
PlaneExtraction::maxSigmas() const
{
  return static_cast<float> (parameters_.distance_threshold) /
         parameters_.noise.sigma (1.f);
}

} // namespace rgbd_planes
} // namespace pcl
