// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/impl/whole_things.h>

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
  collect (clusters, pieces_);
  sets_.start (pieces_.size());
  resting_things_.find (points,
                        clustering.pixelAngle(),
                        occlusions_,
                        supports.planes(),
                        parameters,
                        piece_of_,
                        pieces_,
                        sets_);
  collect (pieces_, things_);
}

/** What was joined is where the first of its pieces is, and begins where the lowest does. Parts
 * of what is no object are left out. */
void
WholeThings::collect (const std::vector<ObjectCluster>& pieces,
                      std::vector<ObjectCluster>& things)
{
  std::size_t count = 0;
  piece_of_.resize (pieces.size());
  for (std::uint32_t k = 0; k < pieces.size(); ++k) {
    const std::uint32_t root = sets_.root (k);
    if (pieces[root].is_part)
      continue;
    piece_of_[k] = root == k ? count++ : piece_of_[root];
    things.resize (std::max (things.size(), count));
    ObjectCluster& thing = things[piece_of_[k]];
    if (root == k) {
      thing.runs.clear();
      thing.support = pieces[k].support;
      thing.bottom = pieces[k].bottom;
      thing.is_part = false;
    }
    thing.runs.insert (thing.runs.end(), pieces[k].runs.begin(), pieces[k].runs.end());
    thing.bottom = std::min (thing.bottom, pieces[k].bottom);
  }
  things.resize (count);
  const auto isBefore = [] (const PointRun& a, const PointRun& b) {
    return a.first < b.first;
  };
  for (auto& thing : things)
    if (!std::is_sorted (thing.runs.begin(), thing.runs.end(), isBefore))
      std::sort (thing.runs.begin(), thing.runs.end(), isBefore);
}

} // namespace rgbd_planes
} // namespace pcl
