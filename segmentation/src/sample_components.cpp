// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/sample_components.h>

#include <algorithm>

namespace pcl {
namespace rgbd_planes {

std::uint32_t
SampleComponents::find (std::uint32_t sample)
{
  while (parents_[sample] != sample) {
    parents_[sample] = parents_[parents_[sample]];
    sample = parents_[sample];
  }
  return sample;
}

void
SampleComponents::join (const PlaneSamples& samples,
                        const std::vector<std::int32_t>& clusters)
{
  parents_.resize (samples.size());
  for (std::uint32_t i = 0; i < parents_.size(); ++i)
    parents_[i] = i;
  for (int v = 0; v < samples.height; ++v)
    for (int u = 0; u < samples.width; ++u) {
      const std::size_t i = samples.at (u, v);
      if (clusters[i] < 0)
        continue;
      const auto joinWith = [&] (int other_u, int other_v) {
        if (other_u < 0 || other_u >= samples.width || other_v < 0)
          return;
        const std::size_t other = samples.at (other_u, other_v);
        if (clusters[other] != clusters[i])
          return;
        const std::uint32_t a = find (static_cast<std::uint32_t> (i));
        const std::uint32_t b = find (static_cast<std::uint32_t> (other));
        parents_[std::max (a, b)] = std::min (a, b);
      };
      joinWith (u - 1, v);
      joinWith (u - 1, v - 1);
      joinWith (u, v - 1);
      joinWith (u + 1, v - 1);
    }
}

void
SampleComponents::compute (const PlaneSamples& samples,
                           const std::vector<std::int32_t>& clusters,
                           std::size_t min_points)
{
  join (samples, clusters);
  places_.assign (samples.size(), 0);
  for (std::uint32_t i = 0; i < parents_.size(); ++i)
    if (clusters[i] >= 0)
      ++places_[find (i)];

  constexpr std::uint32_t nowhere = 0xffffffff;
  members_.resize (samples.size());
  components_.clear();
  std::uint32_t end = 0;
  for (std::uint32_t i = 0; i < parents_.size(); ++i) {
    if (clusters[i] < 0 || parents_[i] != i)
      continue;
    const std::uint32_t count = places_[i];
    places_[i] = count >= min_points ? end : nowhere;
    if (count >= min_points) {
      components_.push_back ({&members_[end], &members_[end] + count, clusters[i]});
      end += count;
    }
  }
  for (std::uint32_t i = 0; i < parents_.size(); ++i)
    if (clusters[i] >= 0 && places_[find (i)] != nowhere)
      members_[places_[find (i)]++] = i;
  std::sort (components_.begin(),
             components_.end(),
             [] (const Component& a, const Component& b) {
               return a.size() != b.size() ? a.size() > b.size() : a.begin < b.begin;
             });
}

} // namespace rgbd_planes
} // namespace pcl
