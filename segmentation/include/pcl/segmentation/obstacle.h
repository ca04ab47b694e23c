// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/types.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Something that a robot must not drive into, at any height: also what ScanLimits says
 * that it fits under. */
struct Obstacle {
  enum class Kind {
    obstacle, /**< anything but the floor */
    drop_off  /**< a step down or a hole in the floor */
  };
  Kind kind = Kind::obstacle;
  /** Its points in the input cloud, ascending. */
  pcl::Indices indices;
  /** Its closest point in the base frame, metres; of a drop-off, which is seen across its
   * edge, where the view onto it meets the floor. */
  Eigen::Vector3f nearest = Eigen::Vector3f::Zero();
  /** Of \a nearest from the origin of the base frame, in its xy plane, metres: r. */
  float distance = 0.f;
  /** Of \a nearest, radians counterclockwise from the x axis: phi. */
  float direction = 0.f;
  /** z of its lowest and of its highest point in the base frame, metres: what a robot that is
   * lower than \a min_height drives under. */
  float min_height = 0.f, max_height = 0.f;
};

/** \brief What part of the obstacles a virtual scan shows, in the base frame. */
struct ScanLimits {
  float angle_min = -1.5707963f; /**< first direction, radians from the x axis */
  /** The last direction, or beyond it where no whole number of increments leads there. In a
   * whole turn, each direction is there once: the last one is before the first one. */
  float angle_max = 1.5707963f;
  float angle_increment = 0.0087266463f; /**< half a degree */
  /** Directions whose closest point is nearer are negative infinity; metres in the xy
   * plane, 0 or more. */
  float range_min = 0.f;
  /** Points farther are left out; metres in the xy plane. */
  float range_max = 10.f;
  /** Points higher above z = 0 are left out: the robot fits under them; metres. */
  float max_height = 2.f;
};

/** \brief Distances to the closest obstacle in each direction (Holz et al. 2011, section 5.1): the
 * fields of a LaserScan message of ROS but its header, by the same names, in radians, metres and
 * seconds. The stamp of its header is that of the cloud, its frame the base frame. */
struct VirtualScan {
  float angle_min = 0.f;
  /** The last direction, angle_min + (ranges.size() - 1) * angle_increment. */
  float angle_max = 0.f;
  float angle_increment = 0.f;
  /** 0, as \a scan_time: all directions are seen at once, at times that the camera decides on. */
  float time_increment = 0.f;
  float scan_time = 0.f;
  float range_min = 0.f;
  float range_max = 0.f;
  /** ranges[i] is the distance in the xy plane of the base frame of the closest point
   * whose direction is angle_min + i * angle_increment, rounded; where columns of the
   * image that an obstacle fills are more than a direction apart, the directions between them have
   * the range of the column that is nearer in direction. Between rows, which take their place
   * where the camera is rolled by 90 degrees, such gaps stay. As REP 117 of ROS has it,
   * infinite where no obstacle is seen, which includes directions outside of the image, and
   * negative infinity where that point is nearer than range_min. */
  std::vector<float> ranges;
  /** Empty: cameras measure none. */
  std::vector<float> intensities;
};

} // namespace rgbd_planes
} // namespace pcl
