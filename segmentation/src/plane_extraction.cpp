// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/impl/frame_noise.h>
#include <pcl/segmentation/impl/plane_extraction.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Clusters merge within no more, however far normals scatter. */
constexpr double max_angular_threshold = M_PI / 2.;
/** Normals left by the first round, most of them of far or small planes, scatter so much
 * more. */
constexpr double scatter_of_rest = 2.;
/** A connected part of a cluster is a candidate with this share of min_inliers. */
constexpr double min_candidate_share = 0.2;
/** Planes grow over points up to so much farther away than their own may lie: better
 * one plane with a few points missing than two. */
constexpr float growth_reach = 1.15f;
/** Both sides of a step in a plane have this share of min_inliers. */
constexpr double min_step_share = 0.4;
/** The square of the range whose noise stands for all where it may not grow. */
constexpr float squared_usual_range = 9.f;
/** More standard deviations than any point is from a plane. */
constexpr float any_sigmas = 1e9f;

/** Leaves out what is not to be added. */
void
applyAdditions (PlaneExtractionParameters& parameters)
{
  if (!parameters.additions.creases)
    parameters.max_point_curvature = std::numeric_limits<double>::infinity();
  if (!parameters.additions.noise) {
    parameters.noise.constant = parameters.noise.sigmaAtSquare (squared_usual_range);
    parameters.noise.quadratic = 0.f;
  }
}

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
  rejections_ = {};
  times_ = {};
  auto start = std::chrono::steady_clock::now();
  parameters_ = parameters;
  parameters_.noise = noiseIn (points, selected, parameters.noise);
  max_sigmas_ = static_cast<float> (parameters_.distanceThreshold()) /
                parameters_.noise.sigmaAtSquare (1.f);
  applyAdditions (parameters_);
  // Where errors are shared, the means of clusters and of sides of steps are less exact.
  cluster_scatter_ = std::sqrt (parameters_.noise.normal_scatter);
  samples_.compute (points,
                    normals,
                    selected,
                    parameters_.noise,
                    static_cast<float> (parameters_.max_point_curvature));
  times_.normal_space = secondsSince (start);

  const double min_samples =
      static_cast<double> (parameters_.min_inliers) / (samples_.step * samples_.step);
  growth_.reset (
      samples_, min_samples, growth_reach * max_sigmas_, parameters_.additions);
  findParts();
  start = std::chrono::steady_clock::now();
  joinParts();
  assign (points, selected);
  finish (points);
  times_.refinement += secondsSince (start);
}

void
PlaneExtraction::shift (const Eigen::Vector3f& shift)
{
  const Eigen::Vector3d by = shift.cast<double>();
  for (std::size_t k = 0; k < planes_.size(); ++k) {
    planes_[k] = planes_[k].shifted (shift);
    shiftSums (by, moments_[k].sums);
    parameter_covariances_[k] = shiftedCovariance (parameter_covariances_[k], by);
  }
}

void
PlaneExtraction::assign (const OrganizedPoints& points,
                         const std::vector<std::uint8_t>& selected)
{
  if (!parameters_.additions.assignment) {
    assignment_.keepOwners (owners_);
    assignment_.assignPixels (
        points, selected, samples_, planes_, parameters_.noise, any_sigmas);
    return;
  }
  assignment_.findPlanes (samples_, owners_, parts_, planes_);
  const DepthNoise tolerance = parameters_.noise.times (max_sigmas_);
  // Samples near a crease may lie nearer to the plane on its other side.
  assignment_.assignSamples (samples_, planes_, tolerance);
  fitToSamples();
  if (parameters_.additions.intersections) {
    assignment_.findIntersections (samples_, planes_, tolerance);
    assignment_.leaveOutUnclearSamples (samples_, planes_, tolerance);
    fitToSamples();
  }
  assignment_.assignPixels (
      points, selected, samples_, planes_, parameters_.noise, max_sigmas_);
}

void
PlaneExtraction::fitToSamples()
{
  for (std::size_t k = 0; k < planes_.size(); ++k)
    if (assignment_.weightedMoments()[k].points > 3)
      planes_[k] = planeOf (assignment_.weightedMoments()[k].inverseDistance());
}

void
PlaneExtraction::findParts()
{
  const double candidate =
      min_candidate_share * parameters_.min_inliers / (samples_.step * samples_.step);
  const auto min_candidate =
      std::max (static_cast<std::size_t> (std::ceil (candidate)), std::size_t{3});
  const auto min_cell =
      static_cast<std::size_t> (parameters_.min_cell_share *
                                static_cast<double> (samples_.width * samples_.height));
  auto start = std::chrono::steady_clock::now();
  const int rounds = parameters_.additions.repeat ? 2 : 1;
  for (int round = 0; round < rounds; ++round) {
    if (round > 0)
      samples_.dropTakenSeeds();
    const double scatter = cluster_scatter_ * (round == 0 ? 1. : scatter_of_rest);
    const double angular_threshold =
        std::min (parameters_.angular_threshold * scatter, max_angular_threshold);
    normal_clusters_.compute (
        samples_, parameters_.grid, static_cast<float> (angular_threshold), min_cell);
    times_.normal_space += secondsSince (start);
    distance_clusters_.compute (
        samples_, normal_clusters_, min_candidate, parameters_.additions.peaks);
    components_.compute (samples_,
                         distance_clusters_.labels(),
                         min_candidate,
                         parameters_.additions.parts);
    times_.distance_space += secondsSince (start);
    growParts();
    times_.refinement += secondsSince (start);
  }
}

void
PlaneExtraction::growParts()
{
  for (std::size_t k = 0; k < components_.size(); ++k) {
    auto result = PlaneGrowth::Result::side_of_bend;
    while (result == PlaneGrowth::Result::side_of_bend)
      result = growth_.grow (samples_, components_[k]);
    switch (result) {
    case PlaneGrowth::Result::side_of_bend:
    case PlaneGrowth::Result::plane:
      break;
    case PlaneGrowth::Result::too_few_points:
      ++rejections_.too_few_points;
      break;
    case PlaneGrowth::Result::curved:
      ++rejections_.curved;
      break;
    case PlaneGrowth::Result::claimed_by_larger:
      ++rejections_.claimed_by_larger;
      break;
    }
  }
}

void
PlaneExtraction::joinParts()
{
  const auto giveIfJoined = [this] (const auto& joined) {
    if (joined.planes().size() < moments_.size())
      giveTo (joined.planes(), joined.planeOfPart());
  };
  joining_.compute (growth_.moments(), parameters_.additions.joining);
  owners_ = growth_.owners();
  giveTo (joining_.planes(), joining_.planeOfPart());
  if (parameters_.additions.joining) {
    joining_.computeAlternating (moments_, parts_);
    giveIfJoined (joining_);
  }
  if (parameters_.additions.steps) {
    const double min_side =
        min_step_share * parameters_.min_inliers / (samples_.step * samples_.step);
    steps_.compute (samples_,
                    static_cast<std::size_t> (std::ceil (min_side)),
                    cluster_scatter_ * max_sigmas_,
                    owners_,
                    parts_,
                    moments_);
    if (parameters_.additions.joining) {
      joining_.computeSides (moments_, steps_.areSides());
      giveIfJoined (joining_);
    }
  }
  if (parameters_.additions.strips) {
    joining_.computeStrips (moments_);
    giveIfJoined (joining_);
  }
  if (parameters_.additions.joining) {
    ends_.find (samples_, owners_, parts_, moments_);
    giveIfJoined (ends_);
  }
  planes_.clear();
  for (const PlaneMoments& moments : moments_)
    planes_.push_back (planeOf (moments.inverseDistance()));
  if (parameters_.additions.patches)
    patches_.find (
        samples_, owners_, parts_, planes_, parameters_.noise.times (max_sigmas_));
}

/** Samples go to the planes that their own ones were joined to. */
void
PlaneExtraction::giveTo (const std::vector<PlaneMoments>& planes,
                         const std::vector<std::int32_t>& plane_of_part)
{
  moments_ = planes;
  for (std::int32_t& owner : owners_)
    if (owner >= 0)
      owner = plane_of_part[static_cast<std::size_t> (owner)];
  findTileParts (owners_, parts_);
}

} // namespace rgbd_planes
} // namespace pcl
