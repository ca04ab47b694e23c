// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/object_clusters.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** How far apart neighbours may be on a surface, in widths of a pixel: slopes stretch it. */
constexpr float stretch = 3.f;
/** A point so many standard deviations above a plane is not there by noise. */
constexpr float clear_sigmas = 3.f;
/** Objects have so many clear points, in parts of min_points and of their own points. */
constexpr double clear_of_min_points = 0.8;
constexpr double clear_of_points = 0.25;
/** A cluster that hangs together with the outside in more than a few points, and along more
 * than a part of its width, the square root of its points, is cut off from something larger. */
constexpr double few_leaks = 3.;
constexpr double max_leak = 0.1;

} // namespace

void
ObjectClusters::compute (const OrganizedPoints& points,
                         const std::vector<std::uint8_t>& selected,
                         const std::vector<SupportPlane>& supports,
                         const ObjectParameters& parameters)
{
  points_ = points;
  supports_ = &supports;
  parameters_ = parameters;
  candidates_.clear();
  sums_.clear();
  if (!supports.empty()) {
    measurePixelAngle();
    placePoints (selected);
    joinNeighbours();
    sumUp();
  }
  collect();
}

void
ObjectClusters::measurePixelAngle()
{
  constexpr int row_step = 16;
  float angles = 0.f;
  int pixels = 0;
  for (int v = 0; v < points_.height; v += row_step) {
    const auto ray = [&] (int u) {
      return points_[static_cast<std::size_t> (v * points_.width + u)];
    };
    int first = 0, last = points_.width - 1;
    while (first < last && !isMeasured (ray (first)))
      ++first;
    while (first < last && !isMeasured (ray (last)))
      --last;
    if (first == last)
      continue;
    const Eigen::Map<const Eigen::Vector3f> p (ray (first)), q (ray (last));
    angles += std::atan2 (p.cross (q).norm(), p.dot (q));
    pixels += last - first;
  }
  pixel_angle_ = pixels ? angles / static_cast<float> (pixels) : 0.f;
}

void
ObjectClusters::placePoints (const std::vector<std::uint8_t>& selected)
{
  constexpr std::size_t max_bases = 250;
  bases_.clear();
  for (std::size_t k = 0; k < std::min (supports_->size(), max_bases); ++k)
    if (!(*supports_)[k].is_on_object)
      bases_.push_back ({(*supports_)[k].plane, k});
  place_.resize (points_.size());
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    place_[i] = selected.empty() || selected[i] ? placeOf (points_[i]) : nowhere;
    if (place_[i] >= above)
      candidates_.push_back (i);
  }
}

/** Points that are not measured are nowhere or outside, where they are close to none. */
ObjectClusters::Place
ObjectClusters::placeOf (const float* p) const
{
  for (const Base& base : bases_) {
    const float height = base.plane.distance (p);
    if (std::fabs (height) > parameters_.max_object_height)
      continue;
    // Most points of a frame; outside of the hull it makes no difference for them.
    if (isWithinNoise (p, base.plane, height, parameters_))
      return nowhere;
    const Level level = levelOf (p, (*supports_)[base.support], parameters_);
    if (level == Level::above && !isMeasured (p))
      return nowhere;
    if (level == Level::above)
      return isUnder (base.support, p) ? outside
                                       : static_cast<Place> (above + base.support);
  }
  return outside;
}

bool
ObjectClusters::isUnder (std::size_t support, const float* p) const
{
  for (std::size_t k = 0; k < support; ++k) {
    const SupportPlane& higher = (*supports_)[k];
    if (!higher.is_on_object && higher.outline.contains (higher.project (p)))
      return true;
  }
  return false;
}

bool
ObjectClusters::areClose (std::uint32_t i, std::uint32_t j) const
{
  const Eigen::Map<const Eigen::Vector3f> p (points_[i]), q (points_[j]);
  const float squared = p.squaredNorm();
  const float limit =
      parameters_.cluster_tolerance * parameters_.noise.sigma (squared) +
      stretch * pixel_angle_ * std::sqrt (squared);
  return (p - q).squaredNorm() <= limit * limit;
}

void
ObjectClusters::joinNeighbours()
{
  sets_.resize (points_.size());
  const auto width = static_cast<std::uint32_t> (points_.width);
  for (const std::uint32_t i : candidates_) {
    sets_.add (i);
    if (i % width > 0 && place_[i - 1] == place_[i] && areClose (i, i - 1))
      sets_.join (i, i - 1);
    if (i >= width && place_[i - width] == place_[i] && areClose (i, i - width))
      sets_.join (i, i - width);
  }
}

void
ObjectClusters::sumUp()
{
  set_number_.resize (points_.size());
  for (const std::uint32_t i : candidates_) {
    const std::uint32_t root = sets_.root (i);
    const std::size_t k = place_[i] - std::size_t{above};
    if (root == i) {
      set_number_[root] = static_cast<std::uint32_t> (sums_.size());
      sums_.emplace_back();
      sums_.back().support = k;
    }
    Sums& sums = sums_[set_number_[root]];
    ++sums.points;
    sums.leaks += leaks (i);
    const SupportPlane& support = (*supports_)[k];
    const float noise =
        clear_sigmas * support.heightSigma (points_[i], parameters_.noise);
    sums.clear += support.plane.distance (points_[i]) >=
                  std::max (parameters_.min_object_height, noise);
  }
}

bool
ObjectClusters::leaks (std::uint32_t i) const
{
  const auto width = static_cast<std::uint32_t> (points_.width);
  const auto leaksTo = [&] (std::uint32_t j) {
    return place_[j] == outside && areClose (i, j);
  };
  return (i % width > 0 && leaksTo (i - 1)) ||
         (i % width + 1 < width && leaksTo (i + 1)) ||
         (i >= width && leaksTo (i - width)) ||
         (i + width < points_.size() && leaksTo (i + width));
}

bool
ObjectClusters::isObject (const Sums& sums) const
{
  const auto points = static_cast<double> (sums.points);
  const auto clear = static_cast<double> (sums.clear);
  return sums.points >= parameters_.min_points &&
         clear >= clear_of_min_points * parameters_.min_points &&
         clear >= clear_of_points * points &&
         static_cast<double> (sums.leaks) <= few_leaks + max_leak * std::sqrt (points);
}

void
ObjectClusters::collect()
{
  constexpr std::size_t none = static_cast<std::size_t> (-1);
  std::size_t count = 0;
  for (auto& sums : sums_) {
    sums.cluster = isObject (sums) ? count++ : none;
    if (sums.cluster == none)
      continue;
    clusters_.resize (std::max (clusters_.size(), count));
    clusters_[sums.cluster].indices.clear();
    clusters_[sums.cluster].indices.reserve (sums.points);
    clusters_[sums.cluster].support = sums.support;
  }
  clusters_.resize (count);
  for (const std::uint32_t i : candidates_) {
    const std::size_t cluster = sums_[set_number_[sets_.root (i)]].cluster;
    if (cluster != none)
      clusters_[cluster].indices.push_back (static_cast<pcl::index_t> (i));
  }
}

} // namespace rgbd_planes
} // namespace pcl
