// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/curved_points.h>
#include <pcl/apps/statistics.h>
#include <pcl/common/point_tests.h>
#include <pcl/segmentation/plane_assignment.h>

namespace pcl {
namespace rgbd_planes {

void
CurvedPoints::add (const OrganizedPoints& points,
                   const PlaneSet& found,
                   const pcl::PointCloud<TruthPoint>& truth)
{
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (truth[i].label != 0 || !pcl::isFinite (truth[i]) || !isMeasured (points[i]))
      continue;
    ++points_;
    labelled_ += found.labels[i] != unlabelled;
  }
}

double
CurvedPoints::labelledPercent() const
{
  return percentOf (labelled_, points_);
}

} // namespace rgbd_planes
} // namespace pcl
