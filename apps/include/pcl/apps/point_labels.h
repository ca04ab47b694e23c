// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstdint>
#include <map>

namespace pcl {
namespace rgbd_planes {

/** \brief What someone wrote down about the points of a recording; label 0 is for points
 * that nothing is known of. */
struct PointLabels {
  enum class Kind {
    none,
    /** Labels of the object segmentation database mOSD: 1 to 9 are parts of the table,
     * 20 to 29 those of the first object, 30 to 39 of the second, and so on. */
    objects,
    /** Points with the same label lie on the same plane. */
    planes
  };
  Kind kind = Kind::none;
  /** One for each point, none without a kind. */
  pcl::PointCloud<pcl::Label> points;
  /** Of the kind planes, for each label but 0 the plane that fits all measured points with it:
   * a, b, c, d, unit normal, d >= 0. */
  std::map<std::uint32_t, Eigen::Vector4f> planes;
};

/** \brief The labels that the fields of a cloud hold, where it is clear what they mean.
 *
 * Of the kind objects from a field label of unsigned 32-bit integers that all are numbers
 * of mOSD, some of them of the table. Of the kind planes from a field intensity of 32-bit
 * floats that are whole numbers, several ones, mostly the same for neighbours in a row, as in
 * SynPEB, where 95 % of the points with a label are within 5 mm + 4 mm r^2 (r: their range in
 * metres) of a plane: those that are equally bright are not. None from clouds
 * with both fields, or with normals, as results of a segmentation have.
 * \param[in] points of the cloud, in the same order
 */
PointLabels
readPointLabels (const pcl::PCLPointCloud2& cloud,
                 const pcl::PointCloud<pcl::PointXYZRGB>& points);

} // namespace rgbd_planes
} // namespace pcl
