// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/input_faults.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/point_cloud.h>
#include <pcl/register_point_struct.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <limits>

namespace pcl {

/** \brief A normal in spherical coordinates, and the distance of the plane through its
 * point (Holz, Holzer, Rusu, Behnke: Real-Time Plane Segmentation using RGB-D Cameras,
 * 2011, section 3).
 *
 * The axes are those of the cloud. The paper uses the base frame of a robot, x forward and
 * z up: there, theta is pi / 2 on floors and tables, 0 on walls and -pi / 2 on ceilings.
 */
struct NormalSpherical {
  /** The signed distance of the plane from the origin, in metres: d in
   * normal_x x + normal_y y + normal_z z + d = 0. It is positive where the normal faces the
   * origin, as those of estimators do in the frame of the sensor. */
  float r = std::numeric_limits<float>::quiet_NaN();
  /** The angle from the x axis to the normal as projected onto the xy plane, towards the y
   * axis; radians, -pi to pi; 0 where the normal is along the z axis. */
  float phi = std::numeric_limits<float>::quiet_NaN();
  /** The angle between the normal and the xy plane; radians, -pi / 2 to pi / 2, positive
   * where the normal points along the z axis. */
  float theta = std::numeric_limits<float>::quiet_NaN();
};

/** \brief Spherical coordinates of the plane through \a point with a \a normal of unit
 * length. NaN where the point or the normal has NaN or Inf or is (0, 0, 0). */
inline NormalSpherical
toSpherical (const Eigen::Vector3f& point, const Eigen::Vector3f& normal)
{
  if (!rgbd_planes::isMeasured (point.data()) ||
      !rgbd_planes::isMeasured (normal.data()))
    return {};
  // Adding 0 takes the sign from -0, which would turn phi to pi.
  return {-normal.dot (point),
          std::atan2 (normal.y() + 0.f, normal.x() + 0.f),
          std::atan2 (normal.z(), std::hypot (normal.x(), normal.y()))};
}

/** \brief The plane a x + b y + c z + d = 0 that toSpherical () takes to
 * \a spherical: (a, b, c, d) with a normal of unit length. NaN gives NaN. */
inline Eigen::Vector4f
toPlane (const NormalSpherical& spherical)
{
  const float horizontal = std::cos (spherical.theta);
  return {horizontal * std::cos (spherical.phi),
          horizontal * std::sin (spherical.phi),
          std::sin (spherical.theta),
          spherical.r};
}

/** \brief Spherical coordinates of all normals of a cloud, as toSpherical () has them.
 *
 * \param[in] cloud points with x, y, z in metres, organized or not
 * \param[in] normals one of unit length for each point, in the same frame; may be the same
 * cloud
 * \param[out] spherical as many as points, width x height kept; \c is_dense says whether
 * there is no NaN
 * \return false, with an error message and an empty output, where the sizes differ
 */
template <typename PointT, typename PointNT>
bool
computeNormalsSpherical (const pcl::PointCloud<PointT>& cloud,
                         const pcl::PointCloud<PointNT>& normals,
                         pcl::PointCloud<NormalSpherical>& spherical)
{
  spherical.clear();
  if (rgbd_planes::isFault (
          "computeNormalsSpherical",
          rgbd_planes::faultOfOthers (
              "normals", &normals, cloud, "give one normal for each point.")))
    return false;
  spherical.header = cloud.header;
  spherical.sensor_origin_ = cloud.sensor_origin_;
  spherical.sensor_orientation_ = cloud.sensor_orientation_;
  spherical.resize (cloud.size());
  spherical.width = cloud.width;
  spherical.height = cloud.height;
  spherical.is_dense = true;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    spherical[i] =
        toSpherical (cloud[i].getVector3fMap(), normals[i].getNormalVector3fMap());
    spherical.is_dense = spherical.is_dense && !std::isnan (spherical[i].r);
  }
  return true;
}

} // namespace pcl

POINT_CLOUD_REGISTER_POINT_STRUCT (
    pcl::NormalSpherical, (float, r, r) (float, phi, phi) (float, theta, theta))
