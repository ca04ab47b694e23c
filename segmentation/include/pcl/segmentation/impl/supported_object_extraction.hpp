// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/console/print.h>
#include <pcl/features/impl/first_in_a_row.h>
#include <pcl/features/impl/frame_noise.h>
#include <pcl/features/impl/input_faults.h>
#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/filters/impl/plane_points.h>
#include <pcl/segmentation/supported_object_extraction.h>

#include <algorithm>
#include <string>

namespace pcl {

template <typename PointT, typename PointNT>
void
SupportedObjectExtraction<PointT, PointNT>::setRange (
    const char* setter, double low, double high, float& min, float& max)
{
  if (!(low <= high)) {
    PCL_ERROR (
        "[pcl::%s::%s] The first value must not be larger than the second one, got "
        "%g and %g. Keeping %g and %g.\n",
        getClassName().c_str(),
        setter,
        low,
        high,
        static_cast<double> (min),
        static_cast<double> (max));
    return;
  }
  min = static_cast<float> (low);
  max = static_cast<float> (high);
}

template <typename PointT, typename PointNT>
std::string
SupportedObjectExtraction<PointT, PointNT>::faultOf (
    const std::vector<ModelCoefficients>& model_coefficients,
    const std::vector<PointIndices>& inlier_indices) const
{
  std::string fault = rgbd_planes::faultOfInput (input_.get(), indices_.get());
  if (!fault.empty())
    return fault;
  if (parameters_.split_at_concave_edges &&
      !rgbd_planes::areOfPoints (normals_.get(), *input_))
    return "Splitting at concave edges needs a normal for each point of the whole "
           "cloud: "
           "pass them to setInputNormals.";
  if (model_coefficients.size() != inlier_indices.size())
    return "There are " + std::to_string (model_coefficients.size()) +
           " planes and inliers of " + std::to_string (inlier_indices.size()) +
           ": give both as the segmentation returned them.";
  for (std::size_t k = 0; k < inlier_indices.size(); ++k)
    if (model_coefficients[k].values.size() != 4 ||
        !rgbd_planes::indicesInside (inlier_indices[k].indices, input_->size()))
      return "Plane " + std::to_string (k) +
             " needs four coefficients and inliers that lie inside the input cloud: is "
             "it "
             "from another cloud?";
  return {};
}

template <typename PointT, typename PointNT>
void
SupportedObjectExtraction<PointT, PointNT>::extract (
    const std::vector<ModelCoefficients>& model_coefficients,
    const std::vector<PointIndices>& inlier_indices,
    std::vector<SupportedObject>& objects)
{
  const auto forget = [&] {
    objects.clear();
    support_planes_.clear();
    supports_ = rgbd_planes::SupportPlanes();
    clustering_ = rgbd_planes::ObjectClusters();
    split_ = rgbd_planes::ConcaveSplit();
    whole_things_ = rgbd_planes::WholeThings();
    boxes_ = rgbd_planes::ObjectBoxFinder();
  };
  if (rgbd_planes::isFault ("SupportedObjectExtraction",
                            faultOf (model_coefficients, inlier_indices)))
    return forget();
  try {
    findObjects (model_coefficients, inlier_indices, objects);
  }
  catch (...) { // without memory: what is half done is not gone on with
    forget();
    throw;
  }
}

template <typename PointT, typename PointNT>
void
SupportedObjectExtraction<PointT, PointNT>::findObjects (
    const std::vector<ModelCoefficients>& model_coefficients,
    const std::vector<PointIndices>& inlier_indices,
    std::vector<SupportedObject>& objects)
{
  const Eigen::Vector3f origin = input_->sensor_origin_.template head<3>();
  planes_.clear();
  for (std::size_t k = 0; k < inlier_indices.size(); ++k) {
    const Eigen::Vector4f plane = rgbd_planes::shifted (
        rgbd_planes::planeVector (model_coefficients[k]), -origin);
    planes_.push_back ({{plane.head<3>(), plane[3]}, &inlier_indices[k].indices});
  }
  rgbd_planes::selectPoints (indices_.get(), input_->size(), selected_);
  const auto points = relative_points_.of (*input_);
  rgbd_planes::ObjectParameters parameters = parameters_;
  parameters.noise = noiseIn (points, selected_, parameters_.noise);
  std::size_t count = 0;
  for (const auto& cluster : findClusters (points, parameters)) {
    // A strip of the wall behind a table is no object.
    if (rgbd_planes::liesOnOneOf (
            supports_.background(), points, cluster.runs, parameters.noise))
      continue;
    objects.resize (std::max (objects.size(), count + 1));
    describe (points, cluster, parameters, objects[count]);
    objects[count].centroid += origin;
    objects[count++].box_center += origin;
  }
  objects.resize (count);
  rgbd_planes::describe (supports_.planes(), origin, input_->header, support_planes_);
  warnOfPose (!planes_.empty() && supports_.planes().empty());
  warnOfNormals (parameters_.split_at_concave_edges && !objects.empty() &&
                 rgbd_planes::noneIsUnit (*normals_));
}

template <typename PointT, typename PointNT>
void
SupportedObjectExtraction<PointT, PointNT>::warnOfPose (bool is_lost)
{
  if (rgbd_planes::isFirstInARow (is_lost && !is_posed_, is_warned_))
    PCL_WARN (
        "[pcl::%s] No plane is level and %g to %g m above z = 0, which is the height "
        "of the camera as long as setCameraToBase was not called: give the pose of "
        "your camera.\n",
        getClassName().c_str(),
        getMinPlaneHeight(),
        getMaxPlaneHeight());
}

template <typename PointT, typename PointNT>
void
SupportedObjectExtraction<PointT, PointNT>::warnOfNormals (bool have_no_length)
{
  if (rgbd_planes::isFirstInARow (have_no_length, is_warned_of_normals_))
    PCL_WARN (
        "[pcl::%s] Objects may be split wrongly, for no normal has a length of 1: "
        "give unit normals to setInputNormals, NaN where there is none.\n",
        getClassName().c_str());
}

template <typename PointT, typename PointNT>
const std::vector<rgbd_planes::ObjectCluster>&
SupportedObjectExtraction<PointT, PointNT>::findClusters (
    const rgbd_planes::OrganizedPoints& points,
    const rgbd_planes::ObjectParameters& parameters)
{
  const Eigen::Translation3f sensor (input_->sensor_origin_.template head<3>());
  supports_.compute (points, planes_, camera_to_base_ * sensor, parameters);
  clustering_.compute (points, selected_, supports_, parameters);
  rgbd_planes::OrganizedNormals normals;
  if (parameters_.split_at_concave_edges) {
    normals = rgbd_planes::viewNormals (*normals_);
    split_.compute (points,
                    normals,
                    clustering_.pixelAngle(),
                    planes_,
                    supports_.planes(),
                    parameters,
                    clustering_.clusters());
  }
  whole_things_.compute (points,
                         normals,
                         clustering_,
                         supports_,
                         parameters,
                         parameters_.split_at_concave_edges ? split_.parts()
                                                            : clustering_.clusters());
  return whole_things_.things();
}

template <typename PointT, typename PointNT>
void
SupportedObjectExtraction<PointT, PointNT>::describe (
    const rgbd_planes::OrganizedPoints& points,
    const rgbd_planes::ObjectCluster& cluster,
    const rgbd_planes::ObjectParameters& parameters,
    SupportedObject& object)
{
  const auto& support = supports_.planes()[cluster.support];
  object.indices.header = input_->header;
  auto& indices = object.indices.indices;
  indices.resize (rgbd_planes::pointsOf (cluster.runs));
  auto next = indices.begin();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& run : cluster.runs)
    for (std::uint32_t i = run.first; i < run.first + run.length; ++i) {
      *next++ = static_cast<pcl::index_t> (i);
      sum += Eigen::Map<const Eigen::Vector3f> (points[i]).template cast<double>();
    }
  object.centroid = (sum / static_cast<double> (indices.size())).template cast<float>();
  const rgbd_planes::ObjectBox box =
      boxes_.compute (points, indices, support, cluster.bottom, parameters.noise);
  object.box_center = box.center;
  object.box_axes = box.axes;
  object.box_size = box.size;
  object.support = support.index;
  object.truncated = clustering_.isTruncated (cluster.runs);
  object.graspable = !object.truncated &&
                     box.smallest_known_side >= parameters.min_graspable_side &&
                     box.smallest_known_side <= parameters.max_graspable_side;
}

} // namespace pcl

#define PCL_INSTANTIATE_SupportedObjectExtraction(PointT, PointNT)                     \
  template class PCL_RGBD_PLANES_EXPORTS                                               \
      pcl::SupportedObjectExtraction<PointT, PointNT>;
