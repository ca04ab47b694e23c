// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/filters/obstacle_class.h>
#include <pcl/point_cloud.h>
#include <pcl/simulation/truth_point.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Numbers the true obstacles of a frame, from 1 on; 0 is the floor, or nothing.
 *
 * An obstacle is a connected part of what is not the floor: of a loose thing, or of
 * furniture and building. Neighbours in a row or column are connected while they are at
 * most 10 cm apart.
 * \param[in] truth organized, of full resolution
 */
std::vector<std::uint32_t>
numberObstacles (const pcl::PointCloud<TruthPoint>& truth);

/** \brief A frame and the truth about it. */
struct ObstacleTruth {
  OrganizedPoints points; /**< as measured */
  const pcl::PointCloud<TruthPoint>& truth;
  /** Of numberObstacles(), one for each point. */
  const std::vector<std::uint32_t>& obstacles;
  Eigen::Affine3f camera_to_base;
};

/** \brief How well obstacles are told from the floor, pooled over frames (Holz et al. 2011,
 * figure 6c).
 *
 * A true obstacle is asked for when its top is at least as high above the floor as the
 * larger of 1 cm and three standard deviations of depth at its mean range, and at least one
 * point in 6000 of the image (51 in VGA) is a measurement of it. It is found when at least
 * half of these points are obstacle or drop-off. Frames that see no floor do not count: all is an
 * obstacle there.
 *
 * Floor points are those that see the floor and measure it: their depth is within three
 * standard deviations of the truth. At the rims of obstacles, some pixels that see the
 * floor measure the obstacle; it is no error to call such points one.
 */
class ObstacleEvaluation {
public:
  /** \param[in] noise of the sensor */
  explicit ObstacleEvaluation (const DepthNoise& noise = DepthNoise::kinectV1())
  : noise_ (noise)
  {}

  /** \param[in] classes one for each point */
  void
  add (const ObstacleTruth& frame, const std::vector<ObstacleClass>& classes);

  std::size_t obstacles = 0;       /**< true ones that are asked for */
  std::size_t found_obstacles = 0; /**< of these */
  std::size_t floor_points = 0;
  std::size_t false_points = 0; /**< floor points that were called something else */
  /** Points that see the floor, whatever they measure, and those of them that were called
   * something else. */
  std::size_t all_floor_points = 0, all_false_points = 0;

  /** \brief Found obstacles in percent of those asked for; NaN where there are none. */
  double
  obstaclesPercent () const;

  /** \brief False points in percent of the floor points; NaN where there are none. */
  double
  falsePointsPercent () const;

private:
  void
  addFloorPoint (const float* point, const TruthPoint& truth, bool is_obstacle);

  DepthNoise noise_;
};

} // namespace rgbd_planes
} // namespace pcl
