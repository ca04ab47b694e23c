// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/impl/organized_cloud_view.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The points of an organized cloud relative to its sensor, whose noise grows with the
 * distance from it: in place, or a copy where \c sensor_origin_ is not (0, 0, 0). */
class SensorPoints {
public:
  /** \param[in] cloud not empty; has to stay as it is while the points are in use */
  template <typename PointT>
  OrganizedPoints
  of (const pcl::PointCloud<PointT>& cloud)
  {
    OrganizedPoints points = viewPoints (cloud);
    const Eigen::Vector3f origin = cloud.sensor_origin_.template head<3>();
    if (origin.isZero (0.f))
      return points;
    constexpr std::size_t floats = 4;
    copy_.resize (floats * points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      Eigen::Map<Eigen::Vector3f> p (&copy_[floats * i]);
      p = Eigen::Map<const Eigen::Vector3f> (points[i]) - origin;
      // Those at the sensor were (0, 0, 0) there, but for what is rounded.
      if (!isMeasured (points[i]) || p.squaredNorm() <= DepthNoise::min_squared_range)
        p.setConstant (std::numeric_limits<float>::quiet_NaN());
    }
    return {copy_.data(), floats, points.width, points.height};
  }

private:
  std::vector<float> copy_;
};

} // namespace rgbd_planes
} // namespace pcl
