// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/simulation/truth_point.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief How depth is measured: without error, with the noise and the gaps of a
 * structured-light camera like Microsoft's first Kinect, or with those of an active stereo
 * camera like the RealSense D4xx. */
enum class Sensor { ideal, kinect, active_stereo };

/** \brief A pinhole camera: pixel (u, v) sees along ((u - cx) / fx, (v - cy) / fy, 1).
 */
struct Camera {
  int width = 640, height = 480;
  float fx = 525.f, fy = 525.f, cx = 319.5f, cy = 239.5f;
};

/** \brief A loose thing of a simulated scene, seen or not. */
struct TrueObject {
  enum class Shape { box, cylinder, sphere };
  /** TruthPoint::object of its points. */
  std::uint32_t id = 0;
  Shape shape = Shape::box;
  /** Sides of the smallest box around it that stands as it does, height last; metres. */
  Eigen::Vector3f size = Eigen::Vector3f::Zero();
  /** To the camera frame, from one whose axes are along its sides, z up, with the origin in
   * the middle of the side it stands on. */
  Eigen::Affine3f pose = Eigen::Affine3f::Identity();
};

/** \brief A simulated frame of Camera{} and its ground truth. */
struct SimulatedFrame {
  /** Organized, in the camera optical frame (x right, y down, z forward), metres; NaN
   * is missing depth, \c is_dense false then. Missing points keep their colour. */
  pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud;
  /** As many points as \a cloud. */
  pcl::PointCloud<TruthPoint>::Ptr truth;
  /** planes[label - 1] holds a, b, c, d with a x + b y + c z + d = 0 in the camera
   * frame, unit normal, d >= 0: the normal faces the camera. Only planes that are seen.
   */
  std::vector<Eigen::Vector4f> planes;
  std::vector<TrueObject> objects;
  /** To the base frame of the robot: x forward, y left, z up, the floor at z = 0. */
  Eigen::Affine3f camera_to_base;
};

/** \brief The scenes that simulate() knows. */
const std::vector<std::string>&
sceneNames ();

/** \brief Renders a scene.
 * \param[in] scene one of sceneNames(); std::invalid_argument for others
 * \param[in] seed varies layout, viewpoint and noise; the same seed gives the same
 * bytes, and all sensors see the same scene
 * \param[in] sensor how depth is measured
 * \param[in] camera varies the smooth error of depth that belongs to a Kinect; none: every
 * seed has a camera of its own
 */
SimulatedFrame
simulate (const std::string& scene,
          unsigned seed,
          Sensor sensor,
          const std::optional<unsigned>& camera = std::nullopt);

} // namespace rgbd_planes
} // namespace pcl
