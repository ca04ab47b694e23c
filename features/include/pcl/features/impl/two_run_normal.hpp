// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/features/two_run_normal.h>

#include <algorithm>
#include <cmath>

namespace pcl {

namespace rgbd_planes {

/** \brief The points of any cloud that is not empty in place, unorganized ones as one
 * row.
 */
template <typename PointT>
OrganizedPoints
viewAnyPoints (const pcl::PointCloud<PointT>& cloud)
{
  OrganizedPoints points = viewPoints (cloud);
  if (!cloud.isOrganized()) {
    points.width = static_cast<int> (cloud.size());
    points.height = 1;
  }
  return points;
}

/** \brief Whether the cloud has points, and as many as its width and height say if it
 * is organized. */
template <typename PointT>
bool
isFilled (const pcl::PointCloud<PointT>& cloud)
{
  return !cloud.empty() &&
         (!cloud.isOrganized() ||
          cloud.size() == static_cast<std::size_t> (cloud.width) * cloud.height);
}

} // namespace rgbd_planes

template <typename PointInT, typename PointOutT>
void
TwoRunNormalEstimation<PointInT, PointOutT>::setRadius (float constant,
                                                        float linear,
                                                        float quadratic)
{
  const auto allowed = [] (float value) {
    return value >= 0.f && std::isfinite (value);
  };
  if (!allowed (constant) || !allowed (linear) || !allowed (quadratic) ||
      constant + linear + quadratic == 0.f) {
    PCL_ERROR (
        "[pcl::%s::setRadius] The numbers must not be negative and not all 0, got "
        "%g, %g and %g. Nothing changed.\n",
        feature_name_.c_str(),
        constant,
        linear,
        quadratic);
    return;
  }
  parameters_.radius = [=] (float z) {
    return std::max (constant + linear * z, quadratic * z * z);
  };
}

template <typename PointInT, typename PointOutT>
void
TwoRunNormalEstimation<PointInT, PointOutT>::setRadius (
    const std::function<float (float)>& radius)
{
  if (!radius) {
    PCL_ERROR ("[pcl::%s::setRadius] The function is empty. Nothing changed.\n",
               feature_name_.c_str());
    return;
  }
  parameters_.radius = radius;
}

template <typename PointInT, typename PointOutT>
void
TwoRunNormalEstimation<PointInT, PointOutT>::setWindowSize (int window_size)
{
  if (window_size != 0 && (window_size < 3 || window_size % 2 == 0)) {
    PCL_ERROR ("[pcl::%s::setWindowSize] The size must be 0 or an odd number of pixels "
               "from 3 on, got %d. Keeping %d.\n",
               feature_name_.c_str(),
               window_size,
               parameters_.window_size);
    return;
  }
  parameters_.window_size = window_size;
}

template <typename PointInT, typename PointOutT>
void
TwoRunNormalEstimation<PointInT, PointOutT>::getViewPoint (float& vpx,
                                                           float& vpy,
                                                           float& vpz) const
{
  Eigen::Vector3f viewpoint = Eigen::Vector3f::Map (parameters_.viewpoint.data());
  if (use_sensor_origin_)
    viewpoint = input_ ? Eigen::Vector3f (input_->sensor_origin_.template head<3>())
                       : Eigen::Vector3f::Zero();
  vpx = viewpoint[0];
  vpy = viewpoint[1];
  vpz = viewpoint[2];
}

template <typename PointInT, typename PointOutT>
bool
TwoRunNormalEstimation<PointInT, PointOutT>::initCompute()
{
  const char* name = feature_name_.c_str();
  if (!input_) {
    PCL_ERROR ("[pcl::%s] No input cloud: call setInputCloud first.\n", name);
    return false;
  }
  if (!rgbd_planes::isFilled (*input_)) {
    PCL_ERROR (
        "[pcl::%s] The input has %zu points where %u x %u are needed: give a cloud "
        "with points, and as many as its width and height say.\n",
        name,
        input_->size(),
        input_->width,
        input_->height);
    return false;
  }
  if (!checkNeighbourhood() || !PCLBase<PointInT>::initCompute())
    return false;
  if (use_indices_ && !rgbd_planes::indicesInside (*indices_, input_->size())) {
    PCL_ERROR (
        "[pcl::%s] An index lies outside of the input cloud: give indices from 0 "
        "to %zu.\n",
        name,
        input_->size() - 1);
    return false;
  }
  return true;
}

template <typename PointInT, typename PointOutT>
bool
TwoRunNormalEstimation<PointInT, PointOutT>::checkNeighbourhood() const
{
  const char* name = feature_name_.c_str();
  if (surface_ && !rgbd_planes::isFilled (*surface_)) {
    PCL_ERROR (
        "[pcl::%s] The search surface has %zu points where %u x %u are needed.\n",
        name,
        surface_->size(),
        surface_->width,
        surface_->height);
    return false;
  }
  if (parameters_.window_size > 0 && (surface_ || !input_->isOrganized())) {
    PCL_ERROR (
        "[pcl::%s] A window of pixels needs an organized cloud (an image of points) "
        "and no search surface: call setWindowSize (0) for neighbours in space.\n",
        name);
    return false;
  }
  return true;
}

template <typename PointInT, typename PointOutT>
void
TwoRunNormalEstimation<PointInT, PointOutT>::computeFeature (PointCloudOut& output)
{
  output.sensor_origin_ = input_->sensor_origin_;
  output.sensor_orientation_ = input_->sensor_orientation_;
  if (use_indices_) {
    output.width = static_cast<std::uint32_t> (indices_->size());
    output.height = 1;
  }
  if (output.empty())
    return;

  getViewPoint (
      parameters_.viewpoint[0], parameters_.viewpoint[1], parameters_.viewpoint[2]);
  Eigen::Vector3f::Map (parameters_.viewing_axis.data()) =
      (input_->sensor_orientation_ * Eigen::Vector3f::UnitZ()).normalized();
  PointOutT& first = output.front();
  output.is_dense =
      rgbd_planes::computeTwoRunNormals (
          rgbd_planes::viewAnyPoints (*input_),
          *indices_,
          rgbd_planes::viewAnyPoints (surface_ ? *surface_ : *input_),
          parameters_,
          {&first.normal_x, &first.curvature, sizeof (PointOutT) / sizeof (float)}) ==
      output.size();

  if constexpr (pcl::traits::has_xyz<PointOutT>::value)
    for (std::size_t i = 0; i < output.size(); ++i)
      output[i].getVector3fMap() = (*input_)[(*indices_)[i]].getVector3fMap();
}

} // namespace pcl

#define PCL_INSTANTIATE_TwoRunNormalEstimation(PointInT, PointOutT)                    \
  template class PCL_RGBD_PLANES_EXPORTS                                               \
      pcl::TwoRunNormalEstimation<PointInT, PointOutT>;
