// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/input_faults.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/filters/project_onto_planes.h>

#include <string>

namespace pcl {

template <typename PointT>
void
ProjectOntoPlanes<PointT>::setInputPlanes (
    const std::vector<ModelCoefficients>& model_coefficients,
    const std::vector<PointIndices>& inlier_indices)
{
  planes_ = rgbd_planes::planeVectors (model_coefficients);
  inliers_ = inlier_indices;
  labels_.reset();
}

template <typename PointT>
void
ProjectOntoPlanes<PointT>::setInputPlanes (
    const std::vector<ModelCoefficients>& model_coefficients,
    const Labels::ConstPtr& labels)
{
  planes_ = rgbd_planes::planeVectors (model_coefficients);
  inliers_.clear();
  labels_ = labels;
}

template <typename PointT>
std::string
ProjectOntoPlanes<PointT>::faultOfPlanes() const
{
  const std::size_t size = input_->size();
  if (labels_)
    return rgbd_planes::faultOfOthers (
        "labels",
        labels_.get(),
        *input_,
        "pass a label for each point to setInputPlanes.");
  if (inliers_.size() != planes_.size())
    return "There are " + std::to_string (planes_.size()) + " planes and " +
           std::to_string (inliers_.size()) +
           " lists of their points: pass a label for each point, or the indices of the "
           "points of each plane, to setInputPlanes.";
  for (const auto& inliers : inliers_)
    if (!rgbd_planes::indicesInside (inliers.indices, size))
      return "A point of a plane lies outside of the input cloud of " +
             std::to_string (size) +
             " points: pass the planes of this cloud to setInputPlanes.";
  return {};
}

template <typename PointT>
bool
ProjectOntoPlanes<PointT>::assignPlanes()
{
  const std::size_t size = input_->size();
  std::string fault = rgbd_planes::faultOfIndices (indices_.get(), size);
  if (fault.empty())
    fault = rgbd_planes::faultOfOrigin (input_->sensor_origin_);
  if (fault.empty())
    fault = faultOfPlanes();
  if (rgbd_planes::isFault (getClassName().c_str(), fault))
    return false;
  if (!labels_) {
    rgbd_planes::fillPlaneOf (inliers_, size, plane_of_);
    return true;
  }
  plane_of_.resize (size);
  for (std::size_t i = 0; i < size; ++i)
    plane_of_[i] = (*labels_)[i].label;
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
  const Eigen::Vector3f sensor = input_->sensor_origin_.template head<3>();
  const bool follows_ray = direction_ == Direction::viewing_ray;
  const float max_ray_factor = follows_ray ? max_ray_factor_ : 0.f;
  output = *input_;
  for (const pcl::index_t index : *indices_) {
    const auto i = static_cast<std::size_t> (index);
    if (plane_of_[i] < planes_.size() && rgbd_planes::isMeasured (&output[i].x)) {
      Eigen::Map<Eigen::Vector3f> xyz (&output[i].x);
      xyz =
          rgbd_planes::projectOnto (planes_[plane_of_[i]], sensor, xyz, max_ray_factor);
    }
  }
}

} // namespace pcl

#define PCL_INSTANTIATE_ProjectOntoPlanes(PointT)                                      \
  template class PCL_RGBD_PLANES_EXPORTS pcl::ProjectOntoPlanes<PointT>;
