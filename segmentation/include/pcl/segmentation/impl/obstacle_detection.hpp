// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/console/print.h>
#include <pcl/features/impl/first_in_a_row.h>
#include <pcl/features/impl/frame_noise.h>
#include <pcl/features/impl/input_faults.h>
#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/segmentation/obstacle_detection.h>

#include <cmath>

namespace pcl {

template <typename PointT, typename PointNT, typename PointLT>
void
ObstacleDetection<PointT, PointNT, PointLT>::setInputPlanes (
    const std::vector<ModelCoefficients>& model_coefficients,
    const PointCloudLConstPtr& labels)
{
  labels_ = labels;
  coefficients_.clear();
  for (const auto& model : model_coefficients) {
    // What is no plane becomes one that is no floor: labels keep their meaning.
    const Eigen::Vector4f plane = rgbd_planes::planeVector (model);
    coefficients_.push_back (plane.allFinite() ? plane : Eigen::Vector4f::Zero());
  }
}

template <typename PointT, typename PointNT, typename PointLT>
void
ObstacleDetection<PointT, PointNT, PointLT>::setCameraToBase (
    const Eigen::Affine3f& camera_to_base)
{
  is_posed_ |= rgbd_planes::setTransform (
      getClassName() + "::setCameraToBase", camera_to_base, parameters_.camera_to_base);
}

template <typename PointT, typename PointNT, typename PointLT>
void
ObstacleDetection<PointT, PointNT, PointLT>::setScanLimits (const ScanLimits& limits)
{
  constexpr float turn = 6.2832f; // as 2 * pi may have been rounded
  constexpr float min_increment = 1e-4f;
  if (!(limits.angle_min >= -turn && limits.angle_min <= limits.angle_max &&
        limits.angle_max <= turn && limits.angle_max - limits.angle_min <= turn &&
        limits.angle_increment >= min_increment &&
        std::isfinite (limits.angle_increment) && limits.range_min >= 0.f &&
        std::isfinite (limits.range_min) && limits.range_min <= limits.range_max &&
        !std::isnan (limits.max_height))) {
    PCL_ERROR (
        "[pcl::%s::setScanLimits] From %g to %g in steps of %g radians, at %g "
        "to %g m, up to %g m high is no scan: give a first angle, a last one up to a "
        "turn further, both within a turn of 0, a step of 0.0001 or more, ranges of "
        "0 or more, the nearer first, and a height that is no NaN. Keeping the limits "
        "before.\n",
        getClassName().c_str(),
        limits.angle_min,
        limits.angle_max,
        limits.angle_increment,
        limits.range_min,
        limits.range_max,
        limits.max_height);
    return;
  }
  parameters_.scan = limits;
}

template <typename PointT, typename PointNT, typename PointLT>
bool
ObstacleDetection<PointT, PointNT, PointLT>::checkInput() const
{
  std::string fault = rgbd_planes::faultOfInput (input_.get(), indices_.get());
  if (fault.empty()) {
    fault = rgbd_planes::faultOfIndices (excluded_.get(), input_->size());
    if (!fault.empty())
      fault.insert (0, "setExcludedIndices: ");
  }
  if (fault.empty() && !(rgbd_planes::areOfPoints (normals_.get(), *input_) &&
                         rgbd_planes::areOfPoints (labels_.get(), *input_)))
    fault = "The input has " + rgbd_planes::numberOfPoints (input_.get()) +
            " points, " + rgbd_planes::numberOfPoints (normals_.get()) +
            " normals and " + rgbd_planes::numberOfPoints (labels_.get()) +
            " labels: pass a normal and a label for each point of the whole cloud to "
            "setInputNormals and setInputPlanes.";
  return !rgbd_planes::isFault ("ObstacleDetection", fault);
}

template <typename PointT, typename PointNT, typename PointLT>
void
ObstacleDetection<PointT, PointNT, PointLT>::detect (std::vector<Obstacle>& obstacles)
{
  const auto forget = [&] {
    obstacles.clear();
    floor_.setZero();
    extraction_ = rgbd_planes::ObstacleExtraction();
  };
  if (!checkInput())
    return forget();
  try {
    findObstacles (obstacles);
  }
  catch (...) { // without memory: what is half done is not gone on with
    forget();
    throw;
  }
}

template <typename PointT, typename PointNT, typename PointLT>
void
ObstacleDetection<PointT, PointNT, PointLT>::findObstacles (
    std::vector<Obstacle>& obstacles)
{
  const Eigen::Vector3f origin = input_->sensor_origin_.template head<3>();
  rgbd_planes::ObstacleParameters parameters = parameters_;
  parameters.camera_to_base.translate (origin);
  const auto points = relative_points_.of (*input_);
  planes_.coefficients.clear();
  for (const auto& plane : coefficients_)
    planes_.coefficients.push_back (rgbd_planes::shifted (plane, -origin));
  rgbd_planes::selectPoints (indices_.get(), input_->size(), selected_);
  parameters.points.noise = noiseIn (points, selected_, parameters_.points.noise);
  planes_.labels = &labels_->front().label;
  planes_.stride = sizeof (PointLT) / sizeof (std::uint32_t);
  extraction_.compute (points,
                       rgbd_planes::viewNormals (*normals_),
                       planes_,
                       indices_ ? selected_.data() : nullptr,
                       excluded_.get(),
                       parameters,
                       obstacles);
  warnOfPose (!extraction_.floor().isFound());
  warnOfNormals (!obstacles.empty() && rgbd_planes::noneIsUnit (*normals_));
  floor_ = extraction_.floor().coefficients();
  floor_[3] -= floor_.head<3>().dot (origin);
}

template <typename PointT, typename PointNT, typename PointLT>
void
ObstacleDetection<PointT, PointNT, PointLT>::warnOfPose (bool is_lost)
{
  if (rgbd_planes::isFirstInARow (is_lost && !is_posed_, is_warned_))
    PCL_WARN (
        "[pcl::%s] No floor at z = 0, which is the height of the camera as long as "
        "setCameraToBase was not called: give the pose of your camera.\n",
        getClassName().c_str());
}

template <typename PointT, typename PointNT, typename PointLT>
void
ObstacleDetection<PointT, PointNT, PointLT>::warnOfNormals (bool have_no_length)
{
  if (rgbd_planes::isFirstInARow (have_no_length, is_warned_of_normals_))
    PCL_WARN (
        "[pcl::%s] Floor may be taken for obstacles, for no normal has a length of "
        "1: give unit normals to setInputNormals, NaN where there is none.\n",
        getClassName().c_str());
}

template <typename PointT, typename PointNT, typename PointLT>
void
ObstacleDetection<PointT, PointNT, PointLT>::detect (std::vector<Obstacle>& obstacles,
                                                     PointCloudL& classes)
{
  detect (obstacles);
  const auto& found = extraction_.classes();
  if (found.empty()) {
    classes.clear();
    return;
  }
  classes.header = input_->header;
  classes.sensor_origin_ = input_->sensor_origin_;
  classes.sensor_orientation_ = input_->sensor_orientation_;
  if constexpr (!pcl::traits::has_xyz<PointLT>::value)
    classes.is_dense = true;
  classes.resize (input_->width, input_->height);
  for (std::size_t i = 0; i < found.size(); ++i)
    classes[i].label = static_cast<std::uint32_t> (found[i]);
}

} // namespace pcl

#define PCL_INSTANTIATE_ObstacleDetection(PointT, PointNT, PointLT)                    \
  template class PCL_RGBD_PLANES_EXPORTS                                               \
      pcl::ObstacleDetection<PointT, PointNT, PointLT>;
