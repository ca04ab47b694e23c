// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "floor_scene.h"

#include <pcl/common/io.h>
#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/features/two_run_normal.h>
#include <pcl/filters/camera_to_base.h>
#include <pcl/filters/depth_warp_correction.h>
#include <pcl/filters/obstacle_filter.h>
#include <pcl/filters/project_onto_planes.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>
#include <pcl/segmentation/obstacle_detection.h>
#include <pcl/segmentation/supported_object_extraction.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

/** What all classes of the library make of a box on a floor, with any types of points,
 * normals and labels. */
template <typename PointT, typename PointNT, typename PointLT>
class NumbersOfAllClasses {
public:
  NumbersOfAllClasses() { find(); }

  /** Sets all inputs anew, and gives other numbers from then on. */
  void
  find ()
  {
    numbers_.clear();
    std::vector<synthetic::Patch> patches{synthetic::floorAt (0.f)};
    synthetic::addBox ({1.2f, -0.1f, 0.f}, {1.5f, 0.2f, 0.25f}, patches);
    const synthetic::FloorScene scene (patches,
                                       synthetic::cameraPose (0.8f, 0.45f),
                                       160,
                                       [] (float z) { return 0.001f * z; });
    cloud_ = pcl::make_shared<Cloud>();
    normals_ = pcl::make_shared<pcl::PointCloud<PointNT>>();
    pcl::copyPointCloud (*scene.cloud, *cloud_);
    pcl::copyPointCloud (*scene.normals, *normals_);
    estimate (tangents_, "tangent");
    estimate (two_runs_, "two_run");
    segment();
    findObjects (scene.camera_to_base);
    findObstacles (scene.camera_to_base);
    filter (scene.camera_to_base);
  }

  /** By what they are of. */
  const std::map<std::string, std::vector<double>>&
  get () const
  {
    return numbers_;
  }

private:
  void
  add (const std::string& name, double number)
  {
    numbers_[name].push_back (std::isnan (number) ? -1e9 : number);
  }

  void
  add (const std::string& name, const pcl::Indices& indices)
  {
    for (const auto index : indices)
      add (name, index);
  }

  void
  add (const std::string& name, const pcl::PointCloud<PointT>& points)
  {
    for (const auto& point : points) {
      add (name, point.x);
      add (name, point.y);
      add (name, point.z);
    }
  }

  template <typename Estimation>
  void
  estimate (Estimation& estimation, const std::string& name)
  {
    estimation.setInputCloud (cloud_);
    pcl::PointCloud<PointNT> normals;
    estimation.compute (normals);
    for (const auto& normal : normals)
      for (const float number :
           {normal.normal_x, normal.normal_y, normal.normal_z, normal.curvature})
        add (name, number);
  }

  void
  segment ()
  {
    segmentation_.setMinInliers (200);
    segmentation_.setProjectPoints (true);
    segmentation_.setInputCloud (cloud_);
    segmentation_.setInputNormals (normals_);
    typename decltype (segmentation_)::Regions regions;
    std::vector<pcl::PointIndices> label_indices, boundary_indices;
    segmentation_.segmentAndRefine (
        regions, models_, inliers_, labels_, label_indices, boundary_indices);
    for (const auto& model : models_)
      for (const float number : model.values)
        add ("planes", number);
    for (const auto& inliers : inliers_)
      add ("inliers", inliers.indices);
    for (auto& region : regions)
      for (const auto& point : region.getContour())
        add ("contours", point.x + point.y + point.z);
    for (const auto& label : *labels_)
      add ("labels", label.label);
  }

  void
  findObjects (const Eigen::Affine3f& camera_to_base)
  {
    extraction_.setInputCloud (cloud_);
    extraction_.setInputNormals (normals_);
    extraction_.setSplitAtConcaveEdges (true);
    extraction_.setCameraToBase (camera_to_base);
    std::vector<pcl::SupportedObject> objects;
    extraction_.extract (models_, inliers_, objects);
    for (const auto& object : objects) {
      add ("objects", object.indices.indices);
      add ("objects", object.box_size.sum());
    }
  }

  void
  findObstacles (const Eigen::Affine3f& camera_to_base)
  {
    detection_.setCameraToBase (camera_to_base);
    detection_.setInputCloud (cloud_);
    detection_.setInputNormals (normals_);
    detection_.setInputPlanes (models_, labels_);
    classes_ = pcl::make_shared<pcl::PointCloud<pcl::Label>>();
    std::vector<pcl::rgbd_planes::Obstacle> obstacles;
    pcl::PointCloud<PointLT> classes;
    detection_.detect (obstacles, classes);
    for (const auto& obstacle : obstacles)
      add ("obstacles", obstacle.indices);
    for (const auto& point : classes) {
      add ("classes", point.label);
      pcl::Label label;
      label.label = point.label;
      classes_->push_back (label);
    }
  }

  void
  filter (const Eigen::Affine3f& camera_to_base)
  {
    pcl::PointCloud<PointT> output;
    obstacle_filter_.setInputCloud (cloud_);
    obstacle_filter_.setClasses (classes_);
    obstacle_filter_.filter (output);
    add ("obstacle points", output);
    projection_.setInputCloud (cloud_);
    projection_.setInputPlanes (models_, inliers_);
    projection_.filter (output);
    add ("projected points", output);
    correction_.clearFrames();
    correction_.addFrame (cloud_, models_, inliers_);
    correction_.setInputCloud (cloud_);
    correction_.filter (output);
    add ("corrected points", output);
    to_base_.setTransform (camera_to_base);
    to_base_.setInputCloud (cloud_);
    to_base_.filter (output);
    add ("points in the base frame", output);
  }

  using Cloud = pcl::PointCloud<PointT>;
  pcl::IntegralImageTangentNormalEstimation<PointT, PointNT> tangents_;
  pcl::TwoRunNormalEstimation<PointT, PointNT> two_runs_;
  pcl::NormalSpacePlaneSegmentation<PointT, PointNT, PointLT> segmentation_;
  pcl::SupportedObjectExtraction<PointT, PointNT> extraction_;
  pcl::ObstacleDetection<PointT, PointNT, PointLT> detection_;
  pcl::ObstacleFilter<PointT> obstacle_filter_;
  pcl::ProjectOntoPlanes<PointT> projection_;
  pcl::DepthWarpCorrection<PointT> correction_;
  pcl::CameraToBase<PointT> to_base_;
  typename Cloud::Ptr cloud_;
  typename pcl::PointCloud<PointNT>::Ptr normals_;
  std::vector<pcl::ModelCoefficients> models_;
  std::vector<pcl::PointIndices> inliers_;
  typename pcl::PointCloud<PointLT>::Ptr labels_;
  pcl::PointCloud<pcl::Label>::Ptr classes_;
  std::map<std::string, std::vector<double>> numbers_;
};

/** Other types of points change nothing. */
template <typename PointT, typename PointNT, typename PointLT>
void
expectSameAsPointXYZ ()
{
  static const NumbersOfAllClasses<pcl::PointXYZ, pcl::Normal, pcl::Label> expected;
  EXPECT_EQ (expected.get().size(), 13u) << "there is a box, and all classes find it";
  const NumbersOfAllClasses<PointT, PointNT, PointLT> found;
  for (const auto& [name, numbers] : expected.get())
    EXPECT_TRUE (found.get().count (name) && found.get().at (name) == numbers) << name;
}
