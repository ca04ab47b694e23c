// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/console/print.h>
#include <pcl/features/impl/input_faults.h>
#include <pcl/features/normal_estimation_base.h>
#include <pcl/type_traits.h>

#include <cmath>
#include <cstdint>

namespace pcl {
namespace rgbd_planes {

template <typename PointInT, typename PointOutT>
void
NormalEstimationBase<PointInT, PointOutT>::setViewPoint (float vpx,
                                                         float vpy,
                                                         float vpz)
{
  if (!std::isfinite (vpx) || !std::isfinite (vpy) || !std::isfinite (vpz)) {
    PCL_ERROR ("[pcl::%s::setViewPoint] The viewpoint must be finite numbers, got %g, "
               "%g and %g. Keeping the one before.\n",
               feature_name_.c_str(),
               vpx,
               vpy,
               vpz);
    return;
  }
  viewpoint_ = {{vpx, vpy, vpz}};
  use_sensor_origin_ = false;
}

template <typename PointInT, typename PointOutT>
void
NormalEstimationBase<PointInT, PointOutT>::getViewPoint (float& vpx,
                                                         float& vpy,
                                                         float& vpz) const
{
  const std::array<float, 3> used = use_sensor_origin_ ? sensorOrigin() : viewpoint_;
  vpx = used[0];
  vpy = used[1];
  vpz = used[2];
}

template <typename PointInT, typename PointOutT>
std::array<float, 3>
NormalEstimationBase<PointInT, PointOutT>::sensorOrigin() const
{
  if (!input_)
    return {{0.f, 0.f, 0.f}};
  const Eigen::Vector4f& origin = input_->sensor_origin_;
  return {{origin[0], origin[1], origin[2]}};
}

template <typename PointInT, typename PointOutT>
bool
NormalEstimationBase<PointInT, PointOutT>::initCompute()
{
  std::string fault =
      input_ ? complaint() : "No input cloud: call setInputCloud first.";
  if (fault.empty())
    fault = faultOfOrigin (input_->sensor_origin_);
  if (fault.empty() && forIndices())
    fault = faultOfIndices (indices_.get(), input_->size());
  if (isFault (feature_name_.c_str(), fault))
    return false;
  // Copies of an estimator share the indices that PCL makes up for whole clouds; they
  // would resize them under each other's feet.
  if (fake_indices_ && indices_.use_count() > 1)
    indices_.reset();
  // Without memory, PCL keeps the indices of an earlier cloud after an error message.
  return PCLBase<PointInT>::initCompute() &&
         (!fake_indices_ || indices_->size() == input_->size());
}

template <typename PointInT, typename PointOutT>
void
NormalEstimationBase<PointInT, PointOutT>::computeFeature (PointCloudOut& output)
{
  // Feature::compute has given the output its size already.
  const void* resized = &output;
  if (forIndices() && resized == input_.get()) {
    PCL_ERROR ("[pcl::%s] The output is the input cloud, which has lost points for the "
               "number of indices: compute into another cloud, or without indices.\n",
               feature_name_.c_str());
    output.clear();
    return;
  }
  output.sensor_origin_ = input_->sensor_origin_;
  output.sensor_orientation_ = input_->sensor_orientation_;
  if (forIndices()) {
    output.width = static_cast<std::uint32_t> (indices_->size());
    output.height = 1;
  }
  const std::size_t valid = output.empty() ? 0 : computeNormals (output);
  output.is_dense = valid == output.size();
  if (!use_sensor_origin_ && viewpoint_ != sensorOrigin())
    faceViewpoint (output);

  if constexpr (pcl::traits::has_xyz<PointOutT>::value)
    for (std::size_t i = 0; i < output.size(); ++i) {
      const auto& point = (*input_)[static_cast<std::size_t> ((*indices_)[i])];
      output[i].x = point.x;
      output[i].y = point.y;
      output[i].z = point.z;
    }
}

template <typename PointInT, typename PointOutT>
void
NormalEstimationBase<PointInT, PointOutT>::faceViewpoint (PointCloudOut& output) const
{
  const auto [x, y, z] = viewpoint_;
  for (std::size_t i = 0; i < output.size(); ++i) {
    auto& n = output[i];
    const auto& point = (*input_)[static_cast<std::size_t> ((*indices_)[i])];
    flipNormalTowardsViewpoint (point, x, y, z, n.normal_x, n.normal_y, n.normal_z);
  }
}

} // namespace rgbd_planes
} // namespace pcl

#define PCL_INSTANTIATE_NormalEstimationBase(PointInT, PointOutT)                      \
  template class PCL_RGBD_PLANES_EXPORTS                                               \
      pcl::rgbd_planes::NormalEstimationBase<PointInT, PointOutT>;
