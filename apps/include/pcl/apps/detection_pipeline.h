// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/object_evaluation.h>
#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>
#include <pcl/segmentation/obstacle_detection.h>
#include <pcl/segmentation/supported_object_extraction.h>

#include <optional>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief All stages in one go: normals, planes, objects and obstacles, on one
 * thread, with their buffers. */
class DetectionPipeline {
public:
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;

  /** \param[in] split objects at concave edges */
  explicit DetectionPipeline (bool split = true)
  {
    extraction_.setSplitAtConcaveEdges (split);
  }

  /** \brief Of the sensor, for all stages. */
  void
  setDepthNoise (const DepthNoise& noise)
  {
    estimation_.setDepthNoise (noise);
    segmentation_.setDepthNoise (noise);
    extraction_.setDepthNoise (noise);
    detection_.setDepthNoise (noise);
  }

  /** \brief All stages, of findPlanes(), findObjects() and findObstacles(). */
  void
  detect (const Cloud::ConstPtr& cloud,
          const std::optional<Eigen::Affine3f>& camera_to_base)
  {
    findPlanes (cloud, camera_to_base);
    findObjects();
    findObstacles();
  }

  /** \brief Normals and planes.
   * \param[in] camera_to_base where the camera is; without, estimateCameraToBase()
   */
  void
  findPlanes (const Cloud::ConstPtr& cloud,
              const std::optional<Eigen::Affine3f>& camera_to_base);

  /** \brief Objects on the planes of the last call of findPlanes(). */
  void
  findObjects ();

  /** \brief Obstacles, from the planes of the last call of findPlanes(). */
  void
  findObstacles ();

  /** \brief Those of the last call of findObjects(). */
  std::vector<FoundObject>
  objects () const;

  /** \brief The class of each point. */
  const std::vector<ObstacleClass>&
  classes () const
  {
    return detection_.getClasses();
  }

private:
  /** \brief Also sets at which heights planes are looked for: at all, if it is only
   * estimated. */
  void
  setPose (const std::optional<Eigen::Affine3f>& camera_to_base);

  pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation_;
  pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> segmentation_;
  pcl::SupportedObjectExtraction<pcl::PointXYZ, pcl::Normal> extraction_;
  pcl::ObstacleDetection<pcl::PointXYZ, pcl::Normal> detection_;
  Cloud::ConstPtr cloud_;
  pcl::PointCloud<pcl::Normal>::Ptr normals_ =
      pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::PointCloud<pcl::Label>::Ptr labels_ =
      pcl::make_shared<pcl::PointCloud<pcl::Label>>();
  std::vector<pcl::ModelCoefficients> models_;
  std::vector<pcl::PointIndices> inliers_;
  std::vector<pcl::SupportedObject> objects_;
  std::vector<Obstacle> obstacles_;
};

} // namespace rgbd_planes
} // namespace pcl
