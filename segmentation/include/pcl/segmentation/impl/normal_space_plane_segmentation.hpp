// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>

#include <cmath>

namespace pcl {

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::setAngularThreshold (
    double angular_threshold)
{
  if (!(angular_threshold > 0. && angular_threshold <= M_PI / 4.)) {
    PCL_ERROR (
        "[pcl::%s::setAngularThreshold] The threshold must be more than 0 and at "
        "most pi / 4 radians, got %g. Keeping %g.\n",
        getClassName().c_str(),
        angular_threshold,
        parameters_.angular_threshold);
    return;
  }
  parameters_.angular_threshold = angular_threshold;
}

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::setDistanceThreshold (
    double distance_threshold)
{
  if (!(distance_threshold > 0. && std::isfinite (distance_threshold))) {
    PCL_ERROR (
        "[pcl::%s::setDistanceThreshold] The threshold must be more than 0 m, got "
        "%g. Keeping %g.\n",
        getClassName().c_str(),
        distance_threshold,
        parameters_.distance_threshold);
    return;
  }
  parameters_.distance_threshold = distance_threshold;
}

template <typename PointT, typename PointNT, typename PointLT>
bool
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::checkInput() const
{
  const std::string name = getClassName();
  if (!input_) {
    PCL_ERROR ("[pcl::%s] No input cloud: call setInputCloud first.\n", name.c_str());
    return false;
  }
  if (!rgbd_planes::isImage (*input_)) {
    PCL_ERROR (
        "[pcl::%s] %s\n", name.c_str(), rgbd_planes::notAnImage (*input_).c_str());
    return false;
  }
  if (!normals_ || normals_->size() != input_->size()) {
    PCL_ERROR (
        "[pcl::%s] The input has %zu points and %zu normals: compute a normal for "
        "each point of the whole cloud and pass them to setInputNormals.\n",
        name.c_str(),
        input_->size(),
        normals_ ? normals_->size() : std::size_t{0});
    return false;
  }
  if (use_indices_ && !rgbd_planes::indicesInside (*indices_, input_->size())) {
    PCL_ERROR (
        "[pcl::%s] An index lies outside of the input cloud: give indices from 0 to "
        "%zu.\n",
        name.c_str(),
        input_->size() - 1);
    return false;
  }
  return true;
}

template <typename PointT, typename PointNT, typename PointLT>
bool
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::extract()
{
  if (!checkInput())
    return false;
  selected_.assign (input_->size(), use_indices_ ? 0 : 1);
  if (use_indices_)
    for (const pcl::index_t index : *indices_)
      selected_[static_cast<std::size_t> (index)] = 1;

  const PointNT& first = normals_->front();
  plane_extraction_.compute (
      rgbd_planes::viewPoints (*input_),
      {&first.normal_x, &first.curvature, sizeof (PointNT) / sizeof (float)},
      selected_,
      parameters_);
  return true;
}

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::fillModels (
    std::vector<ModelCoefficients>& model_coefficients,
    std::vector<PointIndices>& inlier_indices) const
{
  const auto& planes = plane_extraction_.planes();
  model_coefficients.resize (planes.size());
  inlier_indices.resize (planes.size());
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const auto& plane = planes[k];
    model_coefficients[k].header = input_->header;
    model_coefficients[k].values = {
        plane.normal[0], plane.normal[1], plane.normal[2], plane.d};
    inlier_indices[k].header = input_->header;
    inlier_indices[k].indices.clear();
    inlier_indices[k].indices.reserve (plane_extraction_.moments()[k].points);
  }
  const auto& labels = plane_extraction_.labels();
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != unlabelled)
      inlier_indices[labels[i]].indices.push_back (static_cast<pcl::index_t> (i));
}

template <typename PointT, typename PointNT, typename PointLT>
void
NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>::segment (
    std::vector<ModelCoefficients>& model_coefficients,
    std::vector<PointIndices>& inlier_indices)
{
  if (!extract()) {
    model_coefficients.clear();
    inlier_indices.clear();
    return;
  }
  fillModels (model_coefficients, inlier_indices);
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
  centroids.clear();
  covariances.clear();
  if (!extract()) {
    model_coefficients.clear();
    inlier_indices.clear();
    label_indices.clear();
    labels.clear();
    return;
  }
  fillModels (model_coefficients, inlier_indices);
  label_indices = inlier_indices;
  for (const auto& moments : plane_extraction_.moments()) {
    centroids.emplace_back (moments.mean().template cast<float>().homogeneous());
    covariances.emplace_back (moments.covariance().template cast<float>());
  }
  labels.header = input_->header;
  labels.sensor_origin_ = input_->sensor_origin_;
  labels.sensor_orientation_ = input_->sensor_orientation_;
  labels.is_dense = true;
  labels.resize (input_->width, input_->height);
  for (std::size_t i = 0; i < labels.size(); ++i)
    labels[i].label = plane_extraction_.labels()[i];
}

} // namespace pcl

#define PCL_INSTANTIATE_NormalSpacePlaneSegmentation(PointT, PointNT, PointLT)         \
  template class PCL_RGBD_PLANES_EXPORTS                                               \
      pcl::NormalSpacePlaneSegmentation<PointT, PointNT, PointLT>;
