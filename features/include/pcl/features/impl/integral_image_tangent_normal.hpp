// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/common/point_tests.h>
#include <pcl/console/print.h>
#include <pcl/features/impl/first_in_a_row.h>
#include <pcl/features/impl/input_faults.h>
#include <pcl/features/impl/normal_estimation_base.hpp>
#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/features/impl/set_parameter.h>
#include <pcl/features/integral_image_tangent_normal.h>

#include <algorithm>

namespace pcl {

template <typename PointInT, typename PointOutT>
void
IntegralImageTangentNormalEstimation<PointInT, PointOutT>::setNormalSmoothingSize (
    float normal_smoothing_size)
{
  if (rgbd_planes::setParameter (feature_name_ + "::setNormalSmoothingSize",
                                 normal_smoothing_size,
                                 parameters_.smoothing_width,
                                 rgbd_planes::Zero::refused,
                                 rgbd_planes::any_finite))
    parameters_.smoothing_height = normal_smoothing_size;
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
}

template <typename PointInT, typename PointOutT>
void
IntegralImageTangentNormalEstimation<PointInT, PointOutT>::setMaxDepthChangeFactor (
    float max_depth_change_factor)
{
  rgbd_planes::setParameter (feature_name_ + "::setMaxDepthChangeFactor",
                             max_depth_change_factor,
                             parameters_.max_depth_change_factor);
}

template <typename PointInT, typename PointOutT>
std::string
IntegralImageTangentNormalEstimation<PointInT, PointOutT>::complaint() const
{
  const std::string fault = rgbd_planes::faultOfImage (*input_);
  if (fault.empty() || !this->surface_)
    return fault;
  return fault + " Search surfaces have no effect: the whole cloud is the input, and "
                 "setIndices takes the points whose normals are wanted.";
}

template <typename PointInT, typename PointOutT>
std::size_t
IntegralImageTangentNormalEstimation<PointInT, PointOutT>::computeNormals (
    PointCloudOut& output)
{
  parameters_.sensor_origin = this->sensorOrigin();
  const auto computeAll = [this] (auto& cloud) {
    const std::size_t valid =
        tangent_normals_.compute (rgbd_planes::viewPoints (*input_),
                                  parameters_,
                                  rgbd_planes::normalOutput (cloud));
    warnOfFew (valid);
    return valid;
  };
  if (!this->forIndices())
    return computeAll (output);

  all_normals_.resize (input_->width, input_->height);
  computeAll (all_normals_);
  std::size_t valid = 0;
  for (std::size_t i = 0; i < indices_->size(); ++i) {
    const auto index = static_cast<std::size_t> ((*indices_)[i]);
    const pcl::Normal& normal = all_normals_[index];
    output[i].normal_x = normal.normal_x;
    output[i].normal_y = normal.normal_y;
    output[i].normal_z = normal.normal_z;
    output[i].curvature = normal.curvature;
    valid += pcl::isNormalFinite (normal);
  }
  return valid;
}

template <typename PointInT, typename PointOutT>
void
IntegralImageTangentNormalEstimation<PointInT, PointOutT>::warnOfFew (std::size_t valid)
{
  std::size_t measured = 0;
  if (2 * valid < input_->size() && !parameters_.ignore_border)
    measured = static_cast<std::size_t> (
        std::count_if (input_->begin(), input_->end(), [] (const PointInT& p) {
          return rgbd_planes::isMeasured (&p.x);
        }));
  const bool are_more_than_specks = 100 * measured > input_->size();
  if (rgbd_planes::isFirstInARow (2 * valid < measured && are_more_than_specks,
                                  is_warned_))
    PCL_WARN (
        "[pcl::%s] Only %zu of the %zu measured points have a normal, for a point "
        "needs measured neighbours near it along both axes of the image. If every "
        "second row or column is missing, take every second pixel in both "
        "directions.\n",
        feature_name_.c_str(),
        valid,
        measured);
}

} // namespace pcl

#define PCL_INSTANTIATE_IntegralImageTangentNormalEstimation(PointInT, PointOutT)      \
  template class PCL_RGBD_PLANES_EXPORTS                                               \
      pcl::IntegralImageTangentNormalEstimation<PointInT, PointOutT>;
