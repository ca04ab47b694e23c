// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/min_points.h>
#include <pcl/apps/plane_truth.h>
#include <pcl/common/centroid.h>
#include <pcl/segmentation/plane_assignment.h>
#include <pcl/simulation/subsample.h>

#include <Eigen/Eigenvalues>

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

Eigen::Vector4f
fitPlane (const pcl::PointCloud<pcl::PointXYZRGB>& cloud, const pcl::Indices& points)
{
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  Eigen::Vector4d centroid = Eigen::Vector4d::Zero();
  pcl::computeMeanAndCovarianceMatrix (cloud, points, covariance, centroid);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (covariance);
  const Eigen::Vector3d normal = solver.eigenvectors().col (0);
  const double d = -normal.dot (centroid.head<3>());
  const Eigen::Vector4d plane (normal.x(), normal.y(), normal.z(), d);
  return (d < 0. ? Eigen::Vector4d (-plane) : plane).cast<float>();
}

PlaneSet
labelledPlanes (const Frame& frame, std::uint32_t step)
{
  const auto& labels = frame.labels.points;
  std::map<std::uint32_t, pcl::Indices> points_of;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i].label != 0)
      points_of[labels[i].label].push_back (static_cast<pcl::index_t> (i));

  PlaneSet planes;
  std::map<std::uint32_t, std::uint32_t> plane_of{{0, unlabelled}};
  for (const auto& [label, points] : points_of) {
    plane_of[label] = static_cast<std::uint32_t> (planes.coefficients.size());
    planes.coefficients.push_back (fitPlane (*frame.cloud, points));
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
