// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/detection_pipeline.h>
#include <pcl/apps/estimated_pose.h>
#include <pcl/apps/min_points.h>

namespace pcl {
namespace rgbd_planes {

template <typename PointT>
DetectionPipeline<PointT>::DetectionPipeline (const DepthNoise& noise, bool split)
{
  estimation.setDepthNoise (noise);
  segmentation.setDepthNoise (noise);
  extraction.setDepthNoise (noise);
  detection.setDepthNoise (noise);
  extraction.setSplitAtConcaveEdges (split);
}

template <typename PointT>
void
DetectionPipeline<PointT>::estimateNormals (const typename Cloud::ConstPtr& input)
{
  cloud = input;
  estimation.setInputCloud (cloud);
  estimation.compute (*normals);
}

template <typename PointT>
void
DetectionPipeline<PointT>::findPlanes (unsigned min_inliers)
{
  segmentation.setInputCloud (cloud);
  segmentation.setInputNormals (normals);
  segmentation.setMinInliers (min_inliers);
  segmentation.segment (models, inliers, *labels);
}

template <typename PointT>
void
DetectionPipeline<PointT>::setPose (const Eigen::Affine3f& camera_to_base,
                                    bool is_known)
{
  detection.setCameraToBase (camera_to_base);
  extraction.setCameraToBase (camera_to_base);
  const auto [lowest_m, highest_m] = planeHeights (is_known);
  extraction.setPlaneHeights (lowest_m, highest_m);
}

template <typename PointT>
void
DetectionPipeline<PointT>::findObjects()
{
  extraction.setMinPoints (minObjectPoints (cloud->size()));
  extraction.setInputCloud (cloud);
  extraction.setInputNormals (normals);
  extraction.extract (models, inliers, objects);
}

template <typename PointT>
void
DetectionPipeline<PointT>::findObstacles()
{
  detection.setInputCloud (cloud);
  detection.setInputNormals (normals);
  detection.setInputPlanes (models, labels);
  detection.detect (obstacles);
}

template <typename PointT>
void
DetectionPipeline<PointT>::segment (
    const typename Cloud::ConstPtr& input,
    const std::optional<Eigen::Affine3f>& camera_to_base)
{
  estimateNormals (input);
  findPlanes (minPlanePoints (input->size()));
  setPose (camera_to_base
               ? *camera_to_base
               : estimateCameraToBase (models).value_or (defaultCameraToBase()),
           camera_to_base.has_value());
}

template <typename PointT>
void
DetectionPipeline<PointT>::detect (const typename Cloud::ConstPtr& input,
                                   const std::optional<Eigen::Affine3f>& camera_to_base)
{
  segment (input, camera_to_base);
  findObjects();
  findObstacles();
}

template struct DetectionPipeline<pcl::PointXYZ>;
template struct DetectionPipeline<pcl::PointXYZRGB>;

} // namespace rgbd_planes
} // namespace pcl
