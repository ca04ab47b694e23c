// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/console/print.h>
#include <pcl/features/impl/first_in_a_row.h>
#include <pcl/features/impl/input_faults.h>
#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/filters/impl/plane_points.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace pcl {

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::setAngularThreshold (
    double angular_threshold)
{
  rgbd_planes::setParameter (getClassName() + "::setAngularThreshold",
                             angular_threshold,
                             parameters_.angular_threshold,
                             rgbd_planes::Zero::refused,
                             M_PI / 4.);
}

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::setDistanceThreshold (
    double distance_threshold)
{
  double threshold = parameters_.distanceThreshold();
  if (rgbd_planes::setParameter (getClassName() + "::setDistanceThreshold",
                                 distance_threshold,
                                 threshold,
                                 rgbd_planes::Zero::refused,
                                 rgbd_planes::any_finite))
    parameters_.distance_threshold = threshold;
}

template <typename PointT, typename PointNT, typename PointLT>
bool
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::checkInput() const
{
  std::string fault = rgbd_planes::faultOfInput (input_.get(), indices_.get());
  if (fault.empty())
    fault = rgbd_planes::faultOfOthers (
        "normals",
        normals_.get(),
        *input_,
        "compute a normal for each point of the whole cloud and pass them to "
        "setInputNormals.");
  return !rgbd_planes::isFault ("NormalSpacePlaneSegmentation", fault);
}

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::extract()
{
  is_segmented_ = false;
  try {
    findPlanes();
  }
  catch (...) { // without memory: what is half done is not gone on with
    plane_extraction_ = rgbd_planes::PlaneExtraction();
    rms_.clear();
    throw;
  }
  is_segmented_ = true;
}

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::findPlanes()
{
  if (checkInput()) {
    rgbd_planes::selectPoints (indices_.get(), input_->size(), selected_);
    plane_extraction_.compute (relative_points_.of (*input_),
                               rgbd_planes::viewNormals (*normals_),
                               selected_,
                               parameters_);
    header_ = input_->header;
    sensor_origin_ = input_->sensor_origin_;
    if (!sensor_origin_.head<3>().isZero (0.f))
      plane_extraction_.shift (sensor_origin_.head<3>());
    sensor_orientation_ = input_->sensor_orientation_;
    width_ = input_->width;
    warnOfInput();
  }
  else
    plane_extraction_ = rgbd_planes::PlaneExtraction();
  rgbd_planes::fillRms (plane_extraction_, rms_);
}

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::warnOfInput()
{
  constexpr float farther_than_any_room = 100.f;
  const auto areAllFarther = [this] (float range) {
    return rgbd_planes::areAllFarther (
        range, sensor_origin_.head<3>(), rgbd_planes::viewPoints (*input_));
  };
  const bool are_none = plane_extraction_.planes().empty();
  const bool have_no_length =
      are_none && !rgbd_planes::hasUnit (*normals_) && areAllFarther (0.f);
  if (rgbd_planes::isFirstInARow (have_no_length, is_warned_of_normals_))
    PCL_WARN (
        "[pcl::%s] There are no planes, for no normal has a length of 1: give unit "
        "normals to setInputNormals, NaN where there is none.\n",
        getClassName().c_str());
  const float max_range = parameters_.noise.max_range;
  const bool are_far = areAllFarther (farther_than_any_room);
  const bool are_beyond = are_none && !are_far && areAllFarther (max_range);
  if (rgbd_planes::isFirstInARow (are_far, is_warned_of_units_))
    PCL_WARN (
        "[pcl::%s] All points are more than 100 m away: give points in metres, are "
        "these millimetres?\n",
        getClassName().c_str());
  if (rgbd_planes::isFirstInARow (are_beyond, is_warned_of_range_))
    PCL_WARN (
        "[pcl::%s] There are no planes, for all points are beyond %g m, the range of "
        "the sensor: give one of more range to setDepthNoise.\n",
        getClassName().c_str(),
        max_range);
}

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::fillLabels (
    PointCloudL& labels) const
{
  const auto& label_of_point = plane_extraction_.labels();
  if (label_of_point.empty()) {
    labels.clear();
    return;
  }
  labels.header = header_;
  labels.sensor_origin_ = sensor_origin_;
  labels.sensor_orientation_ = sensor_orientation_;
  if constexpr (!pcl::traits::has_xyz<PointLT>::value)
    labels.is_dense = true;
  labels.resize (width_, static_cast<uindex_t> (label_of_point.size() / width_));
  for (std::size_t i = 0; i < label_of_point.size(); ++i)
    labels[i].label = label_of_point[i];
}

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::fillRegions (
    Regions& regions, std::vector<PointIndices>& boundary_indices)
{
  const auto& planes = plane_extraction_.planes();
  outputs_.fillBoundaries (plane_extraction_, width_, header_, boundary_indices);
  regions.resize (planes.size());
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const auto& moments = plane_extraction_.moments()[k];
    Eigen::Vector4f coefficients;
    coefficients << planes[k].normal, planes[k].d;
    // Assigned without a contour, a region keeps the memory of its own.
    regions[k] = PlanarRegion<PointT> (moments.mean().template cast<float>(),
                                       moments.covariance().template cast<float>(),
                                       static_cast<unsigned> (moments.points),
                                       {},
                                       coefficients);
    regions[k].setCurvature (static_cast<float> (moments.curvature()));
    fillContour (boundary_indices[k].indices, coefficients, regions[k].getContour());
  }
}

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::fillContour (
    const Indices& boundary,
    const Eigen::Vector4f& plane,
    typename pcl::PointCloud<PointT>::VectorType& contour) const
{
  const Eigen::Vector3f sensor = sensor_origin_.head<3>();
  contour.resize (boundary.size());
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    contour[i] = (*input_)[static_cast<std::size_t> (boundary[i])];
    if (project_points_) {
      Eigen::Map<Eigen::Vector3f> xyz (&contour[i].x);
      xyz = rgbd_planes::projectOnto (
          plane, sensor, xyz, rgbd_planes::default_max_ray_factor);
    }
  }
}

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::segment (
    std::vector<ModelCoefficients>& model_coefficients,
    std::vector<PointIndices>& inlier_indices)
{
  extract();
  outputs_.fillModels (plane_extraction_, header_, model_coefficients, inlier_indices);
}

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::segment (
    std::vector<ModelCoefficients>& model_coefficients,
    std::vector<PointIndices>& inlier_indices,
    PointCloudL& labels)
{
  segment (model_coefficients, inlier_indices);
  fillLabels (labels);
}

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::segment (
    std::vector<ModelCoefficients>& model_coefficients,
    std::vector<PointIndices>& inlier_indices,
    Centroids& centroids,
    Covariances& covariances,
    PointCloudL& labels,
    std::vector<PointIndices>& label_indices)
{
  segment (model_coefficients, inlier_indices, labels);
  label_indices = inlier_indices;
  centroids.clear();
  covariances.clear();
  for (const auto& moments : plane_extraction_.moments()) {
    centroids.emplace_back (moments.mean().template cast<float>().homogeneous());
    covariances.emplace_back (moments.covariance().template cast<float>());
  }
}

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::segment (Regions& regions)
{
  extract();
  fillRegions (regions, boundary_indices_);
}

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::segmentAndRefine (
    Regions& regions,
    std::vector<ModelCoefficients>& model_coefficients,
    std::vector<PointIndices>& inlier_indices,
    PointCloudLPtr& labels,
    std::vector<PointIndices>& label_indices,
    std::vector<PointIndices>& boundary_indices)
{
  extract();
  refine (model_coefficients, inlier_indices, labels, label_indices);
  fillRegions (regions, boundary_indices);
}

template <typename PointT, typename PointNT, typename PointLT>
bool
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::isSegmented() const
{
  const std::size_t points = plane_extraction_.labels().size();
  // Of bad input, there are none.
  return is_segmented_ &&
         (points == 0 || (points == input_->size() && width_ == input_->width &&
                          header_.stamp == input_->header.stamp));
}

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::refine (
    std::vector<ModelCoefficients>& model_coefficients,
    std::vector<PointIndices>& inlier_indices,
    PointCloudLPtr& labels,
    std::vector<PointIndices>& label_indices)
{
  if (!isSegmented()) {
    PCL_ERROR (
        "[pcl::%s::refine] The input cloud is not segmented: call segment () first, "
        "for refine () gives the planes that it found.\n",
        getClassName().c_str());
    return;
  }
  outputs_.fillModels (plane_extraction_, header_, model_coefficients, inlier_indices);
  label_indices = inlier_indices;
  if (!labels)
    labels = pcl::make_shared<PointCloudL>();
  fillLabels (*labels);
}

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::getSegments (
    std::vector<PointIndices>& segment_indices,
    std::vector<std::size_t>& plane_of_segment)
{
  outputs_.fillSegments (plane_extraction_,
                         parameters_.min_inliers,
                         header_,
                         segment_indices,
                         plane_of_segment);
}

} // namespace pcl

#define PCL_INSTANTIATE_NormalSpacePlaneSegmentation(PointT, PointNT, PointLT)         \
  template class PCL_RGBD_PLANES_EXPORTS                                               \
      pcl::NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>;
