// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/console/print.h>
#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/features/organized_view.h>
#include <pcl/filters/impl/filter_indices.hpp>
#include <pcl/filters/obstacle_filter.h>

#include <numeric>

namespace pcl {

template <typename PointT>
void
ObstacleFilter<PointT>::applyFilter (Indices& indices)
{
  indices.clear();
  removed_indices_->clear();
  const bool is_inside = rgbd_planes::indicesInside (*indices_, input_->size());
  const bool has_classes = classes_ && classes_->size() == input_->size();
  if (!is_inside || !has_classes) {
    PCL_ERROR ("[pcl::%s] The input has %zu points and %zu classes%s: pass the classes "
               "of ObstacleDetection::detect for this cloud to setClasses.\n",
               getClassName().c_str(),
               input_->size(),
               classes_ ? classes_->size() : std::size_t{0},
               is_inside ? "" : ", and an index lies outside of it");
    if (extract_removed_indices_) {
      removed_indices_->resize (input_->size());
      std::iota (removed_indices_->begin(), removed_indices_->end(), 0);
    }
    return;
  }
  for (const pcl::index_t index : *indices_) {
    const auto i = static_cast<std::size_t> (index);
    const auto c = static_cast<rgbd_planes::ObstacleClass> ((*classes_)[i].label);
    const bool is_obstacle = c == rgbd_planes::ObstacleClass::obstacle ||
                             c == rgbd_planes::ObstacleClass::drop_off;
    if (rgbd_planes::isMeasured (&(*input_)[i].x) && is_obstacle != negative_)
      indices.push_back (index);
    else if (extract_removed_indices_)
      removed_indices_->push_back (index);
  }
}

} // namespace pcl

#define PCL_INSTANTIATE_ObstacleFilter(PointT)                                         \
  template class PCL_RGBD_PLANES_EXPORTS pcl::ObstacleFilter<PointT>;
