// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/common/io.h>
#include <pcl/features/impl/input_faults.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/filters/impl/copy_points.h>
#include <pcl/filters/impl/filter_indices.hpp>
#include <pcl/filters/obstacle_filter.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace pcl {

template <typename PointT>
void
ObstacleFilter<PointT>::applyFilter (Indices& indices)
{
  removed_indices_->clear();
  std::string fault = rgbd_planes::faultOfIndices (indices_.get(), input_->size());
  const bool have_indices = fault.empty();
  if (have_indices)
    fault = rgbd_planes::faultOfOthers (
        "classes",
        classes_.get(),
        *input_,
        "pass the classes of ObstacleDetection::detect for this cloud to setClasses.");
  if (rgbd_planes::isFault (getClassName().c_str(), fault)) {
    if (extract_removed_indices_ && have_indices)
      *removed_indices_ = *indices_;
    else if (extract_removed_indices_) {
      removed_indices_->resize (input_->size());
      std::iota (removed_indices_->begin(), removed_indices_->end(), 0);
    }
    indices.clear();
    return;
  }
  using rgbd_planes::ObstacleClass;
  constexpr auto last_class = static_cast<std::uint32_t> (ObstacleClass::excluded);
  // The output may be the list of indices itself.
  const std::size_t number = indices_->size();
  std::size_t kept = 0;
  indices.resize (number);
  for (std::size_t k = 0; k < number; ++k) {
    const pcl::index_t index = (*indices_)[k];
    const auto i = static_cast<std::size_t> (index);
    const std::uint32_t label = (*classes_)[i].label;
    const auto c =
        label <= last_class ? ObstacleClass (label) : ObstacleClass::unmeasured;
    const bool is_obstacle =
        c == ObstacleClass::obstacle || c == ObstacleClass::drop_off;
    const bool is_known =
        c != ObstacleClass::unmeasured && rgbd_planes::isMeasured (&(*input_)[i].x);
    if (is_known && is_obstacle != negative_)
      indices[kept++] = index;
    else if (extract_removed_indices_)
      removed_indices_->push_back (index);
  }
  indices.resize (kept);
}

template <typename PointT>
void
ObstacleFilter<PointT>::applyFilter (PointCloud& output)
{
  if (keep_organized_) {
    FilterIndices<PointT>::applyFilter (output);
    if (!fake_indices_)
      removeOthers (output);
    return;
  }
  applyFilter (kept_);
  rgbd_planes::copyPoints (*input_, kept_, output);
}

/** Points that were not asked for get the user filter value, as FilterIndices gives removed
 * ones. */
template <typename PointT>
void
ObstacleFilter<PointT>::removeOthers (PointCloud& output) const
{
  std::vector<bool> is_asked_for (output.size(), false);
  for (const pcl::index_t index : *indices_)
    if (static_cast<std::size_t> (index) < output.size()) // the error was told
      is_asked_for[static_cast<std::size_t> (index)] = true;
  const PointXYZ removed (user_filter_value_, user_filter_value_, user_filter_value_);
  for (std::size_t i = 0; i < output.size(); ++i)
    if (!is_asked_for[i])
      copyPoint (removed, output[i]);
}

} // namespace pcl

#define PCL_INSTANTIATE_ObstacleFilter(PointT)                                         \
  template class PCL_RGBD_PLANES_EXPORTS pcl::ObstacleFilter<PointT>;
