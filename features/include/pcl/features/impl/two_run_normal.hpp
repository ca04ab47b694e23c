// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/console/print.h>
#include <pcl/features/impl/input_faults.h>
#include <pcl/features/impl/normal_estimation_base.hpp>
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

/** \brief What to tell a user whose \a cloud, called \a name, has no points, or not as many as
 * an image of its width and height; empty if it has. */
template <typename PointT>
std::string
faultOfCloud (const std::string& name, const pcl::PointCloud<PointT>& cloud)
{
  if (cloud.empty())
    return "The " + name + " has no points: give some.";
  if (cloud.isOrganized() && !faultOfImage (cloud).empty())
    return "The " + name + " has " + std::to_string (cloud.size()) + " points where " +
           std::to_string (cloud.width) + " x " + std::to_string (cloud.height) +
           " are needed: give as many as its width and height say.";
  return {};
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
    PCL_ERROR ("[pcl::%s::setRadius] The numbers must be finite, not negative and not "
               "all 0, got "
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
std::string
TwoRunNormalEstimation<PointInT, PointOutT>::complaint() const
{
  std::string fault = rgbd_planes::faultOfCloud ("input", *input_);
  if (fault.empty() && surface_)
    fault = rgbd_planes::faultOfCloud ("search surface", *surface_);
  if (!fault.empty())
    return fault;
  if (!input_->sensor_orientation_.coeffs().allFinite())
    return "The sensor_orientation_ of the input cloud is not finite: set it to the "
           "rotation of the camera, the identity in its own frame.";
  if (parameters_.window_size > 0 && (surface_ || !input_->isOrganized()))
    return "A window of pixels needs an organized cloud (an image of points) and no "
           "search surface: call setWindowSize (0) for neighbours in space.";
  return "";
}

template <typename PointInT, typename PointOutT>
std::size_t
TwoRunNormalEstimation<PointInT, PointOutT>::computeNormals (PointCloudOut& output)
{
  const void* resized = &output; // by Feature::compute
  if (surface_ != input_ && resized == surface_.get()) {
    PCL_ERROR ("[pcl::%s] The output is the search surface, whose points are lost: "
               "compute into another cloud.\n",
               feature_name_.c_str());
    output.clear();
    return 0;
  }
  parameters_.sensor_origin = this->sensorOrigin();
  Eigen::Vector3f::Map (parameters_.viewing_axis.data()) =
      (input_->sensor_orientation_ * Eigen::Vector3f::UnitZ()).normalized();
  return rgbd_planes::computeTwoRunNormals (
      rgbd_planes::viewAnyPoints (*input_),
      *indices_,
      rgbd_planes::viewAnyPoints (surface_ ? *surface_ : *input_),
      parameters_,
      rgbd_planes::normalOutput (output));
}

} // namespace pcl

#define PCL_INSTANTIATE_TwoRunNormalEstimation(PointInT, PointOutT)                    \
  template class PCL_RGBD_PLANES_EXPORTS                                               \
      pcl::TwoRunNormalEstimation<PointInT, PointOutT>;
