// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/console/print.h>
#include <pcl/features/impl/input_faults.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/filters/camera_to_base.h>
#include <pcl/filters/impl/copy_points.h>
#include <pcl/type_traits.h>

#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace pcl {

template <typename PointT>
void
CameraToBase<PointT>::setTransform (const Eigen::Affine3f& camera_to_base)
{
  rgbd_planes::setTransform (
      getClassName() + "::setTransform", camera_to_base, transform_);
}

template <typename PointT>
bool
CameraToBase<PointT>::estimateFromFloor (const ModelCoefficients& floor)
{
  std::optional<Eigen::Affine3f> estimate;
  if (floor.values.size() == 4)
    estimate = rgbd_planes::cameraToBaseFromFloor (
        Eigen::Map<const Eigen::Vector4f> (floor.values.data()));
  if (!estimate) {
    PCL_ERROR ("[pcl::%s::estimateFromFloor] The floor is no plane: give a, b, c, d, "
               "finite and with a normal (a, b, c) that is not zero.\n",
               getClassName().c_str());
    return false;
  }
  transform_ = *estimate;
  return true;
}

template <typename PointT>
void
CameraToBase<PointT>::filter (PointCloud& output)
{
  if (!input_ || &output == input_.get()) {
    PointCloud result;
    Filter<PointT>::filter (result);
    output = std::move (result);
  }
  else
    Filter<PointT>::filter (output);
}

template <typename PointT>
void
CameraToBase<PointT>::applyFilter (PointCloud& output)
{
  const bool for_indices = use_indices_ && !fake_indices_;
  const std::string fault = rgbd_planes::faultOfIndices (
      for_indices ? indices_.get() : nullptr, input_->size());
  if (rgbd_planes::isFault (getClassName().c_str(), fault)) {
    output.clear();
    return;
  }
  if (for_indices)
    rgbd_planes::copyPoints (*input_, *indices_, output);
  else
    output = *input_;
  output.header.frame_id = base_frame_;

  const Eigen::Matrix3f rotation = transform_.linear();
  const Eigen::Vector3f translation = transform_.translation();
  output.sensor_origin_.template head<3>() =
      rotation * input_->sensor_origin_.template head<3>() + translation;
  output.sensor_origin_[3] = 1.f;
  output.sensor_orientation_ =
      Eigen::Quaternionf (rotation) * input_->sensor_orientation_;
  for (auto& point : output) {
    if constexpr (traits::has_xyz<PointT>::value) {
      Eigen::Map<Eigen::Vector3f> xyz (&point.x);
      if (rgbd_planes::isMeasured (&point.x))
        xyz = (rotation * xyz + translation).eval();
      else {
        xyz.setConstant (std::numeric_limits<float>::quiet_NaN());
        output.is_dense = false;
      }
    }
    if constexpr (traits::has_normal<PointT>::value) {
      Eigen::Map<Eigen::Vector3f> normal (&point.normal_x);
      normal = (rotation * normal).eval();
    }
  }
}

} // namespace pcl

#define PCL_INSTANTIATE_CameraToBase(PointT)                                           \
  template class PCL_RGBD_PLANES_EXPORTS pcl::CameraToBase<PointT>;
