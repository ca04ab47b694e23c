// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/point_labels.h>
#include <pcl/common/centroid.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/type_traits.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace pcl {
namespace rgbd_planes {

namespace {

bool
hasField (const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  return std::any_of (cloud.fields.begin(),
                      cloud.fields.end(),
                      [&] (const auto& field) { return field.name == name; });
}

/** The values of a field; none where it is of another type. */
template <typename Value>
std::vector<Value>
valuesOf (const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  std::vector<Value> values;
  for (const auto& field : cloud.fields)
    if (field.name == name && field.datatype == pcl::traits::asEnum<Value>::value &&
        field.offset + sizeof (Value) <= cloud.point_step) {
      values.resize (cloud.data.size() / cloud.point_step);
      for (std::size_t i = 0; i < values.size(); ++i)
        std::memcpy (&values[i],
                     cloud.data.data() + i * cloud.point_step + field.offset,
                     sizeof (Value));
    }
  return values;
}

bool
areObjectsOfMosd (const std::vector<std::uint32_t>& labels)
{
  const auto isTable = [] (std::uint32_t label) { return label >= 1 && label <= 9; };
  const auto isUnknown = [] (std::uint32_t label) {
    return label >= 10 && label <= 19;
  };
  return std::any_of (labels.begin(), labels.end(), isTable) &&
         std::none_of (labels.begin(), labels.end(), isUnknown);
}

/** Whole numbers, several ones, mostly with their like beside them. */
bool
areLabels (const std::vector<float>& intensities)
{
  constexpr float max_label = 1e6f;
  std::size_t alike = 0;
  for (std::size_t i = 1; i < intensities.size(); ++i)
    alike += intensities[i] == intensities[i - 1];
  return 2 * alike >= intensities.size() && alike + 1 < intensities.size() &&
         std::all_of (intensities.begin(), intensities.end(), [] (float intensity) {
           return intensity >= 0.f && intensity <= max_label &&
                  std::floor (intensity) == intensity;
         });
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

std::map<std::uint32_t, Eigen::Vector4f>
fitPlanes (const pcl::PointCloud<pcl::Label>& labels,
           const pcl::PointCloud<pcl::PointXYZRGB>& points)
{
  std::map<std::uint32_t, pcl::Indices> points_of;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i].label != 0)
      points_of[labels[i].label].push_back (static_cast<pcl::index_t> (i));
  std::map<std::uint32_t, Eigen::Vector4f> planes;
  for (const auto& [label, indices] : points_of)
    planes[label] = fitPlane (points, indices);
  return planes;
}

/** Whether they are labels of planes, and no brightness. */
bool
lieOnPlanes (const pcl::PointCloud<pcl::PointXYZRGB>& points, const PointLabels& labels)
{
  constexpr double min_share = 0.95;
  std::size_t labelled = 0, near = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t label = labels.points[i].label;
    if (label == 0 || !isMeasured (points[i].data))
      continue;
    const float distance = labels.planes.at (label).dot (points[i].getVector4fMap());
    ++labelled;
    near += std::abs (distance) <= 0.005f + 0.004f * squaredRange (points[i].data);
  }
  return static_cast<double> (near) >= min_share * static_cast<double> (labelled);
}

template <typename Value>
PointLabels
makeLabels (PointLabels::Kind kind,
            const std::vector<Value>& values,
            const pcl::PCLPointCloud2& cloud)
{
  PointLabels labels{kind, {cloud.width, cloud.height}, {}};
  for (std::size_t i = 0; i < values.size(); ++i)
    labels.points[i].label = static_cast<std::uint32_t> (values[i]);
  return labels;
}

} // namespace

PointLabels
readPointLabels (const pcl::PCLPointCloud2& cloud,
                 const pcl::PointCloud<pcl::PointXYZRGB>& points)
{
  if (hasField (cloud, "label") == hasField (cloud, "intensity") ||
      hasField (cloud, "normal_x"))
    return {};
  const auto objects = valuesOf<std::uint32_t> (cloud, "label");
  if (areObjectsOfMosd (objects))
    return makeLabels (PointLabels::Kind::objects, objects, cloud);
  const auto planes = valuesOf<float> (cloud, "intensity");
  if (!areLabels (planes))
    return {};
  PointLabels labels = makeLabels (PointLabels::Kind::planes, planes, cloud);
  labels.planes = fitPlanes (labels.points, points);
  return lieOnPlanes (points, labels) ? labels : PointLabels();
}

} // namespace rgbd_planes
} // namespace pcl
