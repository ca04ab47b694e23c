// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/common/point_tests.h>
#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/features/integral_image_tangent_normal.h>

#include <algorithm>

namespace pcl {

template <typename PointInT, typename PointOutT>
void
IntegralImageTangentNormalEstimation<PointInT, PointOutT>::setNormalSmoothingSize (
    float normal_smoothing_size)
{
  if (!(normal_smoothing_size > 0.f)) {
    PCL_ERROR ("[pcl::%s::setNormalSmoothingSize] The size must be more than 0 pixels, "
               "got %g. Nothing changed.\n",
               feature_name_.c_str(),
               normal_smoothing_size);
    return;
  }
  parameters_.smoothing_width = parameters_.smoothing_height = normal_smoothing_size;
}

template <typename PointInT, typename PointOutT>
void
IntegralImageTangentNormalEstimation<PointInT, PointOutT>::setRectSize (int width,
                                                                        int height)
{
  if (width <= 0 || height <= 0) {
    PCL_ERROR (
        "[pcl::%s::setRectSize] Width and height must be more than 0 pixels, got %d "
        "x %d. Nothing changed.\n",
        feature_name_.c_str(),
        width,
        height);
    return;
  }
  parameters_.smoothing_width = static_cast<float> (width);
  parameters_.smoothing_height = static_cast<float> (height);
  parameters_.depth_dependent_smoothing = false;
}

template <typename PointInT, typename PointOutT>
void
IntegralImageTangentNormalEstimation<PointInT, PointOutT>::setMaxDepthChangeFactor (
    float max_depth_change_factor)
{
  if (!(max_depth_change_factor >= 0.f)) {
    PCL_ERROR (
        "[pcl::%s::setMaxDepthChangeFactor] The factor must not be negative, got %g. "
        "Keeping %g.\n",
        feature_name_.c_str(),
        max_depth_change_factor,
        parameters_.max_depth_change_factor);
    return;
  }
  parameters_.max_depth_change_factor = max_depth_change_factor;
}

template <typename PointInT, typename PointOutT>
void
IntegralImageTangentNormalEstimation<PointInT, PointOutT>::getViewPoint (
    float& vpx, float& vpy, float& vpz) const
{
  std::array<float, 3> viewpoint = parameters_.viewpoint;
  if (use_sensor_origin_)
    for (int i = 0; i < 3; ++i)
      viewpoint[static_cast<std::size_t> (i)] =
          input_ ? input_->sensor_origin_[i] : 0.f;
  vpx = viewpoint[0];
  vpy = viewpoint[1];
  vpz = viewpoint[2];
}

template <typename PointInT, typename PointOutT>
bool
IntegralImageTangentNormalEstimation<PointInT, PointOutT>::initCompute()
{
  const char* name = feature_name_.c_str();
  if (!input_) {
    PCL_ERROR ("[pcl::%s] No input cloud: call setInputCloud first.\n", name);
    return false;
  }
  if (!rgbd_planes::isImage (*input_)) {
    PCL_ERROR ("[pcl::%s] %s\n", name, rgbd_planes::notAnImage (*input_).c_str());
    return false;
  }
  if (!PCLBase<PointInT>::initCompute())
    return false;
  if (use_indices_ && !rgbd_planes::indicesInside (*indices_, input_->size())) {
    PCL_ERROR (
        "[pcl::%s] An index lies outside of the input cloud: give indices from 0 to "
        "%zu.\n",
        name,
        input_->size() - 1);
    return false;
  }
  return true;
}

template <typename PointInT, typename PointOutT>
void
IntegralImageTangentNormalEstimation<PointInT, PointOutT>::computeFeature (
    PointCloudOut& output)
{
  output.sensor_origin_ = input_->sensor_origin_;
  output.sensor_orientation_ = input_->sensor_orientation_;
  getViewPoint (
      parameters_.viewpoint[0], parameters_.viewpoint[1], parameters_.viewpoint[2]);

  const rgbd_planes::OrganizedPoints points = rgbd_planes::viewPoints (*input_);
  const auto compute = [&] (auto& cloud) {
    using PointT = typename std::decay_t<decltype (cloud)>::PointType;
    auto& first = cloud.front();
    return tangent_normals_.compute (
        points,
        parameters_,
        {&first.normal_x, &first.curvature, sizeof (PointT) / sizeof (float)});
  };

  if (use_indices_) {
    all_normals_.resize (input_->width, input_->height);
    compute (all_normals_);
    output.width = static_cast<std::uint32_t> (indices_->size());
    output.height = 1;
    output.is_dense = true;
    for (std::size_t i = 0; i < indices_->size(); ++i) {
      const pcl::Normal& normal = all_normals_[(*indices_)[i]];
      output[i].normal_x = normal.normal_x;
      output[i].normal_y = normal.normal_y;
      output[i].normal_z = normal.normal_z;
      output[i].curvature = normal.curvature;
      output.is_dense = output.is_dense && pcl::isNormalFinite (normal);
    }
  }
  else {
    output.is_dense = compute (output) == output.size();
  }

  if constexpr (pcl::traits::has_xyz<PointOutT>::value)
    for (std::size_t i = 0; i < output.size(); ++i)
      output[i].getVector3fMap() = (*input_)[(*indices_)[i]].getVector3fMap();
}

} // namespace pcl

#define PCL_INSTANTIATE_IntegralImageTangentNormalEstimation(PointInT, PointOutT)      \
  template class PCL_RGBD_PLANES_EXPORTS                                               \
      pcl::IntegralImageTangentNormalEstimation<PointInT, PointOutT>;
