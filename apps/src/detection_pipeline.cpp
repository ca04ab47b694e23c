// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/detection_pipeline.h>
#include <pcl/apps/min_points.h>
#include <pcl/apps/object_methods.h>

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

  detection_.setCameraToBase (setPose (camera_to_base, models_, extraction_));
}

void
DetectionPipeline::findObjects()
{
  extraction_.setMinPoints (minObjectPoints (cloud_->size()));
  extraction_.setInputCloud (cloud_);
  extraction_.setInputNormals (normals_);
  extraction_.extract (models_, inliers_, objects_);
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
