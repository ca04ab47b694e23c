// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/filters/filter_indices.h>
#include <pcl/filters/impl/own_indices.h>
#include <pcl/filters/obstacle_class.h>
#include <pcl/point_types.h>

namespace pcl {

/** \brief Keeps the points of obstacles and drop-offs, or with setNegative (true) those of
 * the floor, specks and excluded objects (Holz et al. 2011, section 5.1).
 *
 * What a point is comes from ObstacleDetection::detect, as the labels of a cloud with one
 * rgbd_planes::ObstacleClass for each point.
 *
 * \code
 * detection.detect (obstacles, *classes);
 * pcl::ObstacleFilter<pcl::PointXYZ> filter;
 * filter.setInputCloud (cloud);
 * filter.setClasses (classes);
 * filter.setNegative (true);
 * filter.filter (*without_obstacles);
 * \endcode
 *
 * Points of which nothing is known are always removed, for what is kept by setNegative (true)
 * may be taken for free: those without a measurement (NaN, Inf or (0, 0, 0)), those of
 * class \c unmeasured, which are beyond the range of the sensor or were not asked for, and
 * those with a label that is no class.
 *
 * As in all FilterIndices: with indices, only these points are looked at; setKeepOrganized
 * keeps the organization and gives removed points the user filter value, also those that are not
 * among the indices; getRemovedIndices has the removed points that are, unless the
 * constructor was told not to collect them. Classes that are missing or of another size than
 * the input, or an index outside of it: an error message, and nothing is kept; after such an
 * index all points are removed. Without an
 * input, after an error message of PCL, the output stays as it was.
 *
 * \ingroup filters
 */
template <typename PointT>
class PCL_RGBD_PLANES_EXPORTS ObstacleFilter
: public rgbd_planes::OwnIndices<FilterIndices<PointT>> {
  using Filter<PointT>::extract_removed_indices_;
  using Filter<PointT>::filter_name_;
  using Filter<PointT>::getClassName;
  using Filter<PointT>::indices_;
  using Filter<PointT>::input_;
  using Filter<PointT>::removed_indices_;
  using FilterIndices<PointT>::keep_organized_;
  using FilterIndices<PointT>::negative_;
  using FilterIndices<PointT>::user_filter_value_;
  using PCLBase<PointT>::fake_indices_;

public:
  using Ptr = shared_ptr<ObstacleFilter<PointT>>;
  using ConstPtr = shared_ptr<const ObstacleFilter<PointT>>;
  using typename Filter<PointT>::PointCloud;
  using Classes = pcl::PointCloud<pcl::Label>;

  explicit ObstacleFilter (bool extract_removed_indices = true)
  : rgbd_planes::OwnIndices<FilterIndices<PointT>> (extract_removed_indices)
  {
    filter_name_ = "ObstacleFilter";
  }

  /** \brief Declared so that moving copies: what was moved from can be used on. */
  ~ObstacleFilter() override = default;

  /** \brief The rgbd_planes::ObstacleClass of each point of the input cloud. */
  void
  setClasses (const Classes::ConstPtr& classes)
  {
    classes_ = classes;
  }

  Classes::ConstPtr
  getClasses () const
  {
    return classes_;
  }

protected:
  void
  applyFilter (Indices& indices) override;

  void
  applyFilter (PointCloud& output) override;

private:
  void
  removeOthers (PointCloud& output) const;

  Classes::ConstPtr classes_;
  Indices kept_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/filters/impl/obstacle_filter.hpp>
#endif
