// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/occlusion_steps.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl {
namespace rgbd_planes {

namespace {

// In parts of the longer side of the image:
/** The most that an edge lacks depth. */
constexpr int gaps = 100;
/** The most that is between two clusters. */
constexpr int ways = 10;
/** Pixels at a step that may belong to either side. */
constexpr int uncertainties = 160;

int
longerSide (const OrganizedPoints& points)
{
  return std::max (points.width, points.height);
}

} // namespace

void
OcclusionSteps::compute (const OrganizedPoints& points,
                         const ObjectClusters& clustering,
                         const std::vector<ObjectCluster>& clusters)
{
  points_ = points;
  own (clusters);
  extents_.resize (clusters.size());
  steps_.clear();
  lowest_of_all_.clear();
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    const auto& runs = clusters[k].runs;
    extents_[k].up = clustering.stepUpwards (runs[runs.size() / 2].first);
    findEnds (clusters[k], extents_[k]);
    for (std::size_t line = 0; line < lowest_.size(); ++line) {
      OcclusionStep step;
      step.line = extents_[k].first_line + line;
      step.behind = k;
      step.lowest = lowest_[line];
      step.highest = highest_[line];
      if (step.lowest != no_pixel && findFront (step))
        steps_.push_back (step);
    }
  }
  std::sort (steps_.begin(), steps_.end(), [] (const auto& a, const auto& b) {
    return std::tie (b.front, a.behind, a.line) < std::tie (a.front, b.behind, b.line);
  });
}

/** Clusters are a small part of the image. */
void
OcclusionSteps::own (const std::vector<ObjectCluster>& clusters)
{
  const auto give = [this] (const std::vector<PointRun>& runs, std::size_t owner) {
    for (const PointRun& run : runs)
      std::fill_n (
          owner_.begin() + run.first, run.length, static_cast<std::uint32_t> (owner));
  };
  if (owner_.size() == points_.size())
    give (owned_, 0);
  else
    owner_.assign (points_.size(), 0);
  owned_.clear();
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    give (clusters[k].runs, k + 1);
    owned_.insert (owned_.end(), clusters[k].runs.begin(), clusters[k].runs.end());
  }
}

/** The lowest and the highest point of the cluster in each of its lines. */
void
OcclusionSteps::findEnds (const ObjectCluster& cluster, Extent& extent)
{
  const auto forEachRun = [&] (const auto& use) {
    std::for_each (cluster.runs.begin(), cluster.runs.end(), use);
  };
  extent.first_line = findLineEnds (static_cast<std::size_t> (points_.width),
                                    alongRow (extent.up),
                                    forEachRun,
                                    extent.up > 0 ? lowest_ : highest_,
                                    extent.up > 0 ? highest_ : lowest_);
  extent.lines = lowest_.size();
  extent.begin = lowest_of_all_.size();
  lowest_of_all_.insert (lowest_of_all_.end(), lowest_.begin(), lowest_.end());
}

/** The next point of another cluster below the lowest one. */
bool
OcclusionSteps::findFront (OcclusionStep& step) const
{
  const std::ptrdiff_t up = extents_[step.behind].up;
  const auto front = nextCluster (
      step.lowest, -up, static_cast<std::size_t> (longerSide (points_) / ways));
  if (!front)
    return false;
  step.front = front->cluster;
  step.edge = front->point;
  step.skipped = front->skipped;
  step.depth = rangeFrom (step.lowest, up, true) - rangeFrom (step.edge, -up, false);
  return true;
}

std::optional<OcclusionSteps::Neighbour>
OcclusionSteps::nextCluster (std::uint32_t point,
                             std::ptrdiff_t step,
                             std::size_t pixels) const
{
  std::uint32_t i = point;
  for (std::size_t skipped = 0; skipped < pixels; ++skipped) {
    const std::uint32_t next = nextPixel (points_, i, step);
    if (next == i || owner_[next] == owner_[point])
      return {};
    i = next;
    if (owner_[i] != 0)
      return Neighbour{i, owner_[i] - 1u, skipped};
  }
  return {};
}

/** That of the nearest or the farthest of the next points of a cluster. */
float
OcclusionSteps::rangeFrom (std::uint32_t i, std::ptrdiff_t step, bool farthest) const
{
  const int count = std::max (longerSide (points_) / uncertainties, 2);
  float range = squaredRange (points_[i]);
  std::uint32_t k = i;
  for (int n = 1; n < count; ++n) {
    k = nextPixel (points_, k, step);
    if (owner_[k] != owner_[i])
      break;
    const float next = squaredRange (points_[k]);
    range = farthest ? std::max (range, next) : std::min (range, next);
  }
  return std::sqrt (range);
}

std::size_t
OcclusionSteps::maxGap() const
{
  return static_cast<std::size_t> (longerSide (points_) / gaps);
}

} // namespace rgbd_planes
} // namespace pcl
