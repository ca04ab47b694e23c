// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/organized_view.h>
#include <pcl/features/impl/tangent_normals.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/type_traits.h>
#include <pcl/types.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The points of an organized cloud in place; the cloud must not be empty. */
template <typename PointT>
OrganizedPoints
viewPoints (const pcl::PointCloud<PointT>& cloud)
{
  using namespace pcl::traits;
  static_assert (offset<PointT, fields::y>::value ==
                         offset<PointT, fields::x>::value + sizeof (float) &&
                     offset<PointT, fields::z>::value ==
                         offset<PointT, fields::x>::value + 2 * sizeof (float),
                 "x, y and z must be floats next to each other");
  static_assert (sizeof (PointT) % sizeof (float) == 0, "points must be whole floats");
  return {&cloud.front().x,
          sizeof (PointT) / sizeof (float),
          static_cast<int> (cloud.width),
          static_cast<int> (cloud.height)};
}

/** \brief The normals of a cloud in place; it must not be empty. */
template <typename PointT>
OrganizedNormals
viewNormals (const pcl::PointCloud<PointT>& cloud)
{
  using namespace pcl::traits;
  static_assert (offset<PointT, fields::normal_y>::value ==
                         offset<PointT, fields::normal_x>::value + sizeof (float) &&
                     offset<PointT, fields::normal_z>::value ==
                         offset<PointT, fields::normal_x>::value + 2 * sizeof (float),
                 "normal_x, normal_y and normal_z must be floats next to each other");
  static_assert (sizeof (PointT) % sizeof (float) == 0, "points must be whole floats");
  const PointT& first = cloud.front();
  return {&first.normal_x, &first.curvature, sizeof (PointT) / sizeof (float)};
}

/** \brief Where the normals of a cloud go; it must not be empty. */
template <typename PointT>
NormalOutput
normalOutput (pcl::PointCloud<PointT>& cloud)
{
  const std::size_t stride = viewNormals (cloud).stride;
  PointT& first = cloud.front();
  return {
      &first.normal_x, &first.curvature, stride, std::is_same_v<PointT, pcl::Normal>};
}

/** \brief Whether a normal is of unit length. */
template <typename PointT>
bool
hasUnit (const pcl::PointCloud<PointT>& normals)
{
  return std::any_of (normals.begin(), normals.end(), [] (const PointT& normal) {
    return isUnit (&normal.normal_x);
  });
}

/** \brief Whether there are normals, also of length 0, but none of unit length. */
template <typename PointT>
bool
noneIsUnit (const pcl::PointCloud<PointT>& normals)
{
  return !hasUnit (normals) &&
         std::any_of (normals.begin(), normals.end(), [] (const PointT& normal) {
           return std::isfinite (squaredRange (&normal.normal_x));
         });
}

/** \brief Sets \a selected to 1 for the points of \a indices and 0 for the others of \a size
 * points; without indices, which stands for all points, it is empty. */
PCL_RGBD_PLANES_EXPORTS void
selectPoints (const pcl::Indices* indices,
              std::size_t size,
              std::vector<std::uint8_t>& selected);

} // namespace rgbd_planes
} // namespace pcl
