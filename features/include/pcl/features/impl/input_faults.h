// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/point_cloud.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief Whether there is a \a fault, which then is the error message of \a where: a class, or a
 * function of one. */
PCL_RGBD_PLANES_EXPORTS bool
isFault (const char* where, const std::string& fault);

/** \brief What to tell a user whose cloud of \a size points is not an image that holds all of
 * them; empty if it is. */
PCL_RGBD_PLANES_EXPORTS std::string
faultOfImage (std::size_t size, std::uint32_t width, std::uint32_t height);

template <typename PointT>
std::string
faultOfImage (const pcl::PointCloud<PointT>& cloud)
{
  return faultOfImage (cloud.size(), cloud.width, cloud.height);
}

/** \brief Whether there is one of \a others, as normals or labels, for each point of \a cloud:
 * images of another shape have the same number in another order. */
template <typename OtherT, typename PointT>
bool
areOfPoints (const pcl::PointCloud<OtherT>* others,
             const pcl::PointCloud<PointT>& cloud)
{
  return others && others->size() == cloud.size() &&
         (others->width == cloud.width || !others->isOrganized() ||
          !cloud.isOrganized());
}

/** \brief How many points \a cloud has, for messages: 0 for null, 640 x 480 for an image. */
template <typename PointT>
std::string
numberOfPoints (const pcl::PointCloud<PointT>* cloud)
{
  if (!cloud || !faultOfImage (*cloud).empty())
    return std::to_string (cloud ? cloud->size() : 0);
  return std::to_string (cloud->width) + " x " + std::to_string (cloud->height);
}

/** \brief What to tell a user whose cloud does not say where the sensor was; empty if it
 * does.
 * \param[in] sensor_origin the member of the cloud
 */
PCL_RGBD_PLANES_EXPORTS std::string
faultOfOrigin (const Eigen::Vector4f& sensor_origin);

/** \brief Whether every index is one of a cloud of \a size points. */
PCL_RGBD_PLANES_EXPORTS bool
indicesInside (const pcl::Indices& indices, std::size_t size);

/** \brief What to tell a user whose \a indices are not all of a cloud of \a size points;
 * empty if they are, and without indices. */
PCL_RGBD_PLANES_EXPORTS std::string
faultOfIndices (const pcl::Indices* indices, std::size_t size);

/** \brief What to tell a user whose \a cloud is missing or no image, or who gave \a indices
 * outside of it; empty if all is well. */
template <typename PointT>
std::string
faultOfInput (const pcl::PointCloud<PointT>* cloud, const pcl::Indices* indices)
{
  if (!cloud)
    return "No input cloud: call setInputCloud first.";
  std::string fault = faultOfImage (*cloud);
  if (fault.empty())
    fault = faultOfOrigin (cloud->sensor_origin_);
  return fault.empty() ? faultOfIndices (indices, cloud->size()) : fault;
}

/** \brief What to tell a user who has not given one of \a others for each point of \a cloud;
 * empty if he has.
 * \param[in] what these are
 * \param[in] advice whose to give, and where to
 */
template <typename OtherT, typename PointT>
std::string
faultOfOthers (const char* what,
               const pcl::PointCloud<OtherT>* others,
               const pcl::PointCloud<PointT>& cloud,
               const char* advice)
{
  if (areOfPoints (others, cloud))
    return {};
  return "The input has " + numberOfPoints (&cloud) + " points and " +
         numberOfPoints (others) + ' ' + what + ": " + advice;
}

} // namespace rgbd_planes
} // namespace pcl
