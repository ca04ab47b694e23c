// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/whole_things.h>

#include <algorithm>

namespace pcl {
namespace rgbd_planes {

void
WholeThings::compute (const OrganizedPoints& points,
                      const OrganizedNormals& normals,
                      const ObjectClusters& clustering,
                      const SupportPlanes& supports,
                      const ObjectParameters& parameters,
                      const std::vector<ObjectCluster>& clusters)
{
  sets_.start (clusters.size());
  occlusions_.compute (points, clustering, clusters);
  hollow_things_.find (
      points, clustering.pixelAngle(), occlusions_, supports.planes(), clusters, sets_);
  attached_parts_.find (
      points, normals, occlusions_, supports, parameters, clusters, sets_);
  collect (clusters);
  resting_things_.find (points,
                        clustering.pixelAngle(),
                        occlusions_,
                        supports.planes(),
                        parameters,
                        thing_of_,
                        things_);
}

/** What was joined is where the first of its clusters is. */
void
WholeThings::collect (const std::vector<ObjectCluster>& clusters)
{
  std::size_t count = 0;
  thing_of_.resize (clusters.size());
  for (std::uint32_t k = 0; k < clusters.size(); ++k) {
    const std::uint32_t root = sets_.root (k);
    const auto& runs = clusters[k].runs;
    if (root != k) {
      auto& joined = things_[thing_of_[root]].runs;
      joined.insert (joined.end(), runs.begin(), runs.end());
      thing_of_[k] = thing_of_[root];
      continue;
    }
    thing_of_[k] = count++;
    things_.resize (std::max (things_.size(), count));
    things_[thing_of_[k]].runs.assign (runs.begin(), runs.end());
    things_[thing_of_[k]].support = clusters[k].support;
    things_[thing_of_[k]].bottom = 0.f;
  }
  things_.resize (count);
  const auto isBefore = [] (const PointRun& a, const PointRun& b) {
    return a.first < b.first;
  };
  for (auto& thing : things_)
    if (!std::is_sorted (thing.runs.begin(), thing.runs.end(), isBefore))
      std::sort (thing.runs.begin(), thing.runs.end(), isBefore);
}

} // namespace rgbd_planes
} // namespace pcl
