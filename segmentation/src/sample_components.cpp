// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/sample_components.h>

#include <algorithm>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr std::uint32_t nowhere = 0xffffffff;

} // namespace

void
SampleComponents::joinNeighbours (const PlaneSamples& samples,
                                  const std::vector<std::uint32_t>& clustered,
                                  const std::vector<std::int32_t>& clusters)
{
  for (const std::uint32_t i : clustered) {
    if (clusters[i] < 0)
      continue;
    const auto joined = [&] (std::uint32_t neighbour) {
      const bool same = neighbour != i && clusters[neighbour] == clusters[i];
      if (same)
        sets_.join (i, neighbour);
      return same;
    };
    const auto& around = samples.neighbours[i];
    // Neighbours that touch each other are joined without this sample.
    if (joined (around.above))
      continue;
    if (!joined (around.left))
      joined (around.above_left);
    joined (around.above_right);
  }
}

void
SampleComponents::joinClusters (const std::vector<std::uint32_t>& clustered,
                                const std::vector<std::int32_t>& clusters)
{
  places_.assign (places_.size(), nowhere);
  for (const std::uint32_t i : clustered)
    if (clusters[i] >= 0) {
      std::uint32_t& first = places_[static_cast<std::size_t> (clusters[i])];
      first = std::min (first, i);
      sets_.join (first, i);
    }
}

void
SampleComponents::compute (const PlaneSamples& samples,
                           const std::vector<std::uint32_t>& clustered,
                           const std::vector<std::int32_t>& clusters,
                           std::size_t min_points,
                           bool connected)
{
  sets_.resize (samples.size());
  roots_.resize (samples.size());
  places_.resize (samples.size());
  for (const std::uint32_t i : clustered)
    sets_.add (i);
  if (connected)
    joinNeighbours (samples, clustered, clusters);
  else
    joinClusters (clustered, clusters);
  for (const std::uint32_t i : clustered)
    places_[i] = 0;
  for (const std::uint32_t i : clustered)
    if (clusters[i] >= 0) {
      roots_[i] = sets_.root (i);
      ++places_[roots_[i]];
    }

  members_.resize (samples.size());
  components_.clear();
  std::uint32_t end = 0;
  for (const std::uint32_t i : clustered) {
    const std::uint32_t count = places_[i];
    if (count == 0)
      continue;
    places_[i] = count >= min_points ? end : nowhere;
    if (count >= min_points) {
      components_.push_back ({&members_[end], &members_[end] + count, clusters[i]});
      end += count;
    }
  }
  for (const std::uint32_t i : clustered)
    if (clusters[i] >= 0 && places_[roots_[i]] != nowhere)
      members_[places_[roots_[i]]++] = i;
  std::sort (components_.begin(),
             components_.end(),
             [] (const Component& a, const Component& b) {
               return a.size() != b.size() ? a.size() > b.size() : a.begin < b.begin;
             });
}

} // namespace rgbd_planes
} // namespace pcl
