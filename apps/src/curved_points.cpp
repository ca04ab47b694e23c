// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/curved_points.h>
#include <pcl/apps/statistics.h>
#include <pcl/common/point_tests.h>
#include <pcl/segmentation/impl/label_runs.h>

#include <vector>

namespace pcl {
namespace rgbd_planes {

void
CurvedPoints::add (const OrganizedPoints& points,
                   const PlaneSet& found,
                   const pcl::PointCloud<TruthPoint>& truth)
{
  std::vector<std::size_t> all (found.coefficients.size(), 0), curved (all);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!isMeasured (points[i]))
      continue;
    const bool is_curved = truth[i].label == 0 && pcl::isFinite (truth[i]);
    const std::uint32_t plane = found.labels[i];
    points_ += is_curved;
    if (plane == unlabelled)
      continue;
    ++all[plane];
    curved[plane] += is_curved;
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    labelled_ += curved[k];
    if (2 * curved[k] > all[k])
      shattered_ += curved[k];
  }
}

double
CurvedPoints::labelledPercent() const
{
  return percentOf (labelled_, points_);
}

double
CurvedPoints::shatteredPercent() const
{
  return percentOf (shattered_, points_);
}

} // namespace rgbd_planes
} // namespace pcl
