// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/console/print.h>
#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/features/organized_view.h>
#include <pcl/filters/project_onto_planes.h>

#include <cmath>
#include <limits>

namespace pcl {

template <typename PointT>
void
ProjectOntoPlanes<PointT>::setPlanes (
    const std::vector<ModelCoefficients>& model_coefficients,
    const std::vector<PointIndices>& inlier_indices)
{
  setCoefficients (model_coefficients);
  inliers_ = inlier_indices;
  labels_.reset();
}

template <typename PointT>
void
ProjectOntoPlanes<PointT>::setPlanes (
    const std::vector<ModelCoefficients>& model_coefficients,
    const Labels::ConstPtr& labels)
{
  setCoefficients (model_coefficients);
  inliers_.clear();
  labels_ = labels;
}

template <typename PointT>
void
ProjectOntoPlanes<PointT>::setCoefficients (
    const std::vector<ModelCoefficients>& model_coefficients)
{
  planes_.clear();
  for (const auto& model : model_coefficients) {
    Eigen::Vector4f plane =
        Eigen::Vector4f::Constant (std::numeric_limits<float>::quiet_NaN());
    if (model.values.size() == 4)
      plane = Eigen::Map<const Eigen::Vector4f> (model.values.data());
    planes_.push_back (plane / plane.head<3>().norm());
  }
}

template <typename PointT>
bool
ProjectOntoPlanes<PointT>::assignPlanes()
{
  const std::size_t size = input_->size();
  bool is_inside = rgbd_planes::indicesInside (*indices_, size);
  for (const auto& inliers : inliers_)
    is_inside &= rgbd_planes::indicesInside (inliers.indices, size);
  if (!is_inside ||
      (labels_ ? labels_->size() != size : inliers_.size() != planes_.size())) {
    PCL_ERROR ("[pcl::%s] The planes are not those of the input cloud of %zu points: "
               "pass the coefficients of its planes, and a label for each point or "
               "the indices of the points of each plane, to setPlanes.\n",
               getClassName().c_str(),
               size);
    return false;
  }
  if (fit_together_ && !rgbd_planes::isImage (*input_)) {
    PCL_ERROR ("[pcl::%s] %s\n",
               getClassName().c_str(),
               rgbd_planes::notAnImage (*input_).c_str());
    return false;
  }
  plane_of_.assign (size, std::numeric_limits<std::uint32_t>::max());
  if (labels_)
    for (std::size_t i = 0; i < size; ++i)
      plane_of_[i] = (*labels_)[i].label;
  for (std::size_t k = 0; k < inliers_.size(); ++k)
    for (const pcl::index_t index : inliers_[k].indices)
      plane_of_[static_cast<std::size_t> (index)] = static_cast<std::uint32_t> (k);
  return true;
}

template <typename PointT>
void
ProjectOntoPlanes<PointT>::applyFilter (PointCloud& output)
{
  if (!assignPlanes()) {
    output.clear();
    return;
  }
  fitted_ = planes_;
  if (fit_together_)
    fit_.compute (rgbd_planes::viewPoints (*input_), plane_of_, noise_, fitted_);
  output = *input_;
  for (const pcl::index_t index : *indices_) {
    const auto i = static_cast<std::size_t> (index);
    if (plane_of_[i] < fitted_.size() && rgbd_planes::isMeasured (&output[i].x))
      project (fitted_[plane_of_[i]], output[i]);
  }
}

template <typename PointT>
void
ProjectOntoPlanes<PointT>::project (const Eigen::Vector4f& plane, PointT& point) const
{
  const Eigen::Vector3f normal = plane.head<3>();
  Eigen::Map<Eigen::Vector3f> xyz (&point.x);
  const Eigen::Vector3f p = xyz;
  const float along_normal = normal.dot (p);
  const float distance = along_normal + plane[3];
  if (!std::isfinite (distance))
    return;
  // The point where the ray meets the plane, relative to p.
  const float scale = -plane[3] / along_normal;
  const bool is_steep = std::abs (along_normal) * max_ray_factor_ >= p.norm();
  if (direction_ == Direction::viewing_ray && is_steep && scale > 0.f)
    xyz = scale * p;
  else
    xyz = p - distance * normal;
}

} // namespace pcl

#define PCL_INSTANTIATE_ProjectOntoPlanes(PointT)                                      \
  template class PCL_RGBD_PLANES_EXPORTS pcl::ProjectOntoPlanes<PointT>;
