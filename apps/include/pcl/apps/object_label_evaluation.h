// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/plane_evaluation.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief How well found planes keep to the table and the objects of labelled recordings,
 * pooled over frames. Measured points count; those with label 0 do not. */
class ObjectLabelEvaluation {
public:
  /** \param[in] labels of PointLabels::Kind::objects, one for each point */
  void
  add (const OrganizedPoints& points,
       const PlaneSet& found,
       const pcl::PointCloud<pcl::Label>& labels);

  /** \brief Mean over the frames of the intersection over union of the points of the
   * table, all its parts, and those of the found plane where it is largest; NaN without
   * a table. */
  double
  tableIou () const;

  /** \brief The smallest of what \ref tableIou is the mean of. */
  double
  worstTableIou () const;

  /** \brief Points of planes that belong to what most labelled points of their plane belong
   * to, the table or one object, in percent of all labelled points of planes; NaN where
   * there are none. */
  double
  purityPercent () const;

private:
  std::vector<double> table_ious_;
  std::size_t in_planes_ = 0;
  std::size_t majority_ = 0;
};

} // namespace rgbd_planes
} // namespace pcl
