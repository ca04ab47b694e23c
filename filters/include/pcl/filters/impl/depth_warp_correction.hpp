// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/console/print.h>
#include <pcl/features/impl/input_faults.h>
#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/filters/depth_warp_correction.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace pcl {

template <typename PointT>
bool
DepthWarpCorrection<PointT>::addFrame (
    const PointCloudConstPtr& cloud,
    const std::vector<ModelCoefficients>& model_coefficients,
    const std::vector<PointIndices>& inlier_indices)
{
  std::string fault = cloud ? faultOf (*cloud)
                            : "There is no cloud: pass the one whose planes these are.";
  const auto isInside = [&] (const PointIndices& inliers) {
    return rgbd_planes::indicesInside (inliers.indices, cloud->size());
  };
  if (fault.empty() &&
      (inlier_indices.size() != model_coefficients.size() ||
       !std::all_of (inlier_indices.begin(), inlier_indices.end(), isInside)))
    fault =
        "The planes are not those of the cloud of " + std::to_string (cloud->size()) +
        " points: pass the coefficients of each plane and the indices of its points.";
  if (fault.empty()) {
    rgbd_planes::fillPlaneOf (inlier_indices, cloud->size(), plane_of_);
    if (!warp_.add (rgbd_planes::viewPoints (*cloud),
                    plane_of_,
                    rgbd_planes::planeVectors (model_coefficients),
                    noise_,
                    right_angles_))
      fault =
          "Most points are nowhere near their planes: pass the planes of this cloud, "
          "in the frame of the camera.";
  }
  return !rgbd_planes::isFault ("DepthWarpCorrection::addFrame", fault);
}

template <typename PointT>
pcl::PointCloud<pcl::Intensity>
DepthWarpCorrection<PointT>::getWarp() const
{
  pcl::PointCloud<pcl::Intensity> warp;
  if (!warp_.isKnown())
    return warp;
  warp.resize (static_cast<std::uint32_t> (warp_.width()),
               static_cast<std::uint32_t> (warp_.height()));
  for (std::size_t i = 0; i < warp.size(); ++i)
    warp[i].intensity = warp_.image().data()[i];
  return warp;
}

template <typename PointT>
bool
DepthWarpCorrection<PointT>::setWarp (const pcl::PointCloud<pcl::Intensity>& warp)
{
  const auto isFinite = [] (const pcl::Intensity& point) {
    return std::isfinite (point.intensity);
  };
  const bool is_image = rgbd_planes::faultOfImage (warp).empty();
  if (!is_image || !std::all_of (warp.begin(), warp.end(), isFinite)) {
    PCL_ERROR ("[pcl::%s::setWarp] The warp %s: set what getWarp gave.\n",
               getClassName().c_str(),
               is_image ? "has values that are not finite" : "is no image");
    return false;
  }
  Eigen::MatrixXf image (warp.width, warp.height);
  for (std::size_t i = 0; i < warp.size(); ++i)
    image.data()[i] = warp[i].intensity;
  warp_.setImage (image);
  return true;
}

template <typename PointT>
std::string
DepthWarpCorrection<PointT>::faultOf (const PointCloud& cloud) const
{
  const std::string fault = rgbd_planes::faultOfImage (cloud);
  if (!fault.empty())
    return fault;
  if (!cloud.sensor_origin_.template head<3>().isZero (0.f))
    return "The cloud is in another frame than that of the camera, for its "
           "sensor_origin_ is not 0: correct it before you transform it.";
  if (warp_.isKnown() && (static_cast<int> (cloud.width) != warp_.width() ||
                          static_cast<int> (cloud.height) != warp_.height()))
    return "The cloud is " + std::to_string (cloud.width) + " x " +
           std::to_string (cloud.height) + ", the warp is of " +
           std::to_string (warp_.width()) + " x " + std::to_string (warp_.height()) +
           ": call clearFrames for another camera or resolution.";
  return {};
}

template <typename PointT>
void
DepthWarpCorrection<PointT>::applyFilter (PointCloud& output)
{
  std::string fault = faultOf (*input_);
  if (fault.empty() && !warp_.isKnown())
    fault =
        "There are no frames yet: pass their planes to addFrame, or a warp to setWarp.";
  if (fault.empty())
    fault = rgbd_planes::faultOfIndices (indices_.get(), input_->size());
  if (rgbd_planes::isFault (getClassName().c_str(), fault)) {
    output.clear();
    return;
  }
  output = *input_;
  const float* warp = warp_.image().data();
  for (const pcl::index_t index : *indices_) {
    const auto i = static_cast<std::size_t> (index);
    // Not of the output, for indices may be given twice.
    const Eigen::Map<const Eigen::Vector3f> p (&(*input_)[i].x);
    const float true_part = 1.f - warp[i] * p.z(); // of the inverse depth
    if (rgbd_planes::isMeasured (p.data()) && p.z() > 0.f && true_part > 0.5f &&
        true_part < 1.5f)
      Eigen::Map<Eigen::Vector3f> (&output[i].x) = p / true_part;
  }
}

} // namespace pcl

#define PCL_INSTANTIATE_DepthWarpCorrection(PointT)                                    \
  template class PCL_RGBD_PLANES_EXPORTS pcl::DepthWarpCorrection<PointT>;
