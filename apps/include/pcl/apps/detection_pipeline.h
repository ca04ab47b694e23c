// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>
#include <pcl/segmentation/obstacle_detection.h>
#include <pcl/segmentation/supported_object_extraction.h>

#include <optional>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief All stages, normals, planes, objects and obstacles, on one thread, with their buffers.
 * Each stage is a call, which takes what those before it gave. */
template <typename PointT>
struct DetectionPipeline {
  using Cloud = pcl::PointCloud<PointT>;

  /** \param[in] noise of the sensor, for all stages
   * \param[in] split objects at concave edges
   */
  explicit DetectionPipeline (const DepthNoise& noise = DepthNoise::kinectV1(),
                              bool split = true);

  /** \brief Normals. */
  void
  estimateNormals (const typename Cloud::ConstPtr& cloud);

  /** \brief Planes. */
  void
  findPlanes (unsigned min_inliers);

  /** \brief For objects and obstacles.
   * \param[in] camera_to_base where the camera is
   * \param[in] is_known whether that is no guess, so that planeHeights() are those of the paper
   */
  void
  setPose (const Eigen::Affine3f& camera_to_base, bool is_known);

  void
  findObjects ();

  void
  findObstacles ();

  /** \brief Normals and planes, of minPlanePoints().
   * \param[in] camera_to_base where the camera is; without, estimateCameraToBase()
   */
  void
  segment (const typename Cloud::ConstPtr& cloud,
           const std::optional<Eigen::Affine3f>& camera_to_base);

  /** \brief All stages: segment(), findObjects() and findObstacles(). */
  void
  detect (const typename Cloud::ConstPtr& cloud,
          const std::optional<Eigen::Affine3f>& camera_to_base);

  pcl::IntegralImageTangentNormalEstimation<PointT, pcl::Normal> estimation;
  pcl::NormalSpacePlaneSegmentation<PointT, pcl::Normal> segmentation;
  pcl::SupportedObjectExtraction<PointT, pcl::Normal> extraction;
  pcl::ObstacleDetection<PointT, pcl::Normal> detection;

  typename Cloud::ConstPtr cloud;
  pcl::PointCloud<pcl::Normal>::Ptr normals =
      pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::PointCloud<pcl::Label>::Ptr labels =
      pcl::make_shared<pcl::PointCloud<pcl::Label>>();
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  std::vector<pcl::SupportedObject> objects;
  std::vector<Obstacle> obstacles;
};

} // namespace rgbd_planes
} // namespace pcl
