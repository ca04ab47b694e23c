// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/detection_pipeline.h>
#include <pcl/apps/estimated_pose.h>
#include <pcl/apps/min_points.h>

namespace pcl {
namespace rgbd_planes {

void
DetectionPipeline::findPlanes (const Cloud::ConstPtr& cloud,
                               const std::optional<Eigen::Affine3f>& camera_to_base)
{
  cloud_ = cloud;
  estimation_.setInputCloud (cloud);
  estimation_.compute (*normals_);
  segmentation_.setInputCloud (cloud);
  segmentation_.setInputNormals (normals_);
  segmentation_.setMinInliers (minPlanePoints (cloud->size()));
  segmentation_.segment (models_, inliers_, *labels_);

  setPose (camera_to_base);
}

void
DetectionPipeline::setPose (const std::optional<Eigen::Affine3f>& camera_to_base)
{
  const Eigen::Affine3f pose =
      camera_to_base ? *camera_to_base
                     : estimateCameraToBase (models_).value_or (defaultCameraToBase());
  detection_.setCameraToBase (pose);
  extraction_.setCameraToBase (pose);
  const auto [lowest_m, highest_m] = planeHeights (camera_to_base.has_value());
  extraction_.setPlaneHeights (lowest_m, highest_m);
}

void
DetectionPipeline::findObjects()
{
  extraction_.setMinPoints (minObjectPoints (cloud_->size()));
  extraction_.setInputCloud (cloud_);
  extraction_.setInputNormals (normals_);
  extraction_.extract (models_, inliers_, objects_);
}

std::vector<FoundObject>
DetectionPipeline::objects() const
{
  std::vector<FoundObject> found;
  for (const auto& object : objects_)
    found.push_back ({object.indices.indices, object.box_size, object.graspable});
  return found;
}

void
DetectionPipeline::findObstacles()
{
  detection_.setInputCloud (cloud_);
  detection_.setInputNormals (normals_);
  detection_.setInputPlanes (models_, labels_);
  detection_.detect (obstacles_);
}

} // namespace rgbd_planes
} // namespace pcl
