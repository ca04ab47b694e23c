// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/min_points.h>
#include <pcl/apps/plane_truth.h>
#include <pcl/segmentation/impl/label_runs.h>
#include <pcl/simulation/subsample.h>

#include <map>

namespace pcl {
namespace rgbd_planes {

namespace {

PlaneSet
simulatedPlanes (const Frame& frame, std::uint32_t step)
{
  PlaneSet planes;
  planes.coefficients = frame.true_planes;
  for (const auto& point : subsample (*frame.truth, step))
    planes.labels.push_back (point.label == 0 ? unlabelled : point.label - 1);
  return planes;
}

PlaneSet
labelledPlanes (const Frame& frame, std::uint32_t step)
{
  const auto& labels = frame.labels.points;
  PlaneSet planes;
  std::map<std::uint32_t, std::uint32_t> plane_of{{0, unlabelled}};
  for (const auto& [label, plane] : frame.labels.planes) {
    plane_of[label] = static_cast<std::uint32_t> (planes.coefficients.size());
    planes.coefficients.push_back (plane);
  }
  for (const auto& point : subsample (labels, step))
    planes.labels.push_back (plane_of.at (point.label));
  return planes;
}

} // namespace

std::optional<PlaneSet>
truePlanes (const Frame& frame, std::uint32_t step)
{
  if (frame.truth)
    return simulatedPlanes (frame, step);
  if (frame.labels.kind == PointLabels::Kind::planes)
    return labelledPlanes (frame, step);
  return std::nullopt;
}

unsigned
minPlanePoints (const Frame& frame, std::size_t points)
{
  if (frame.labels.kind == PointLabels::Kind::planes)
    return static_cast<unsigned> (points * 300 / (500 * 500));
  return minPlanePoints (points);
}

} // namespace rgbd_planes
} // namespace pcl
