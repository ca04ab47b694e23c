// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/estimated_pose.h>
#include <pcl/apps/min_points.h>
#include <pcl/apps/object_methods.h>
#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/segmentation/lccp_segmentation.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>
#include <pcl/segmentation/supervoxel_clustering.h>
#include <pcl/segmentation/supported_object_extraction.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>

namespace pcl {
namespace rgbd_planes {

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Clock = std::chrono::steady_clock;

double
millisecondsSince (Clock::time_point start)
{
  return std::chrono::duration<double, std::milli> (Clock::now() - start).count();
}

/** Normals, planes and objects, with their buffers. */
class SupportedObjects {
public:
  explicit SupportedObjects (bool split) { extraction_.setSplitAtConcaveEdges (split); }

  double
  compute (const ObjectInput& input, std::vector<FoundObject>& found)
  {
    const auto start = Clock::now();
    estimation_.setInputCloud (input.cloud);
    estimation_.compute (*normals_);
    segmentation_.setMinInliers (minPlanePoints (input.cloud->size()));
    segmentation_.setInputCloud (input.cloud);
    segmentation_.setInputNormals (normals_);
    segmentation_.segment (models_, inliers_);
    setPose (input.camera_to_base, models_, extraction_);
    extraction_.setMinPoints (input.min_points);
    extraction_.setInputCloud (input.cloud);
    extraction_.setInputNormals (normals_);
    extraction_.extract (models_, inliers_, objects_);
    const double milliseconds = millisecondsSince (start);

    found.clear();
    for (const auto& object : objects_)
      found.push_back ({object.indices.indices, object.box_size, object.graspable});
    return milliseconds;
  }

private:
  pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation_;
  pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> segmentation_;
  pcl::SupportedObjectExtraction<pcl::PointXYZ, pcl::Normal> extraction_;
  pcl::PointCloud<pcl::Normal>::Ptr normals_ =
      pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  std::vector<pcl::ModelCoefficients> models_;
  std::vector<pcl::PointIndices> inliers_;
  std::vector<pcl::SupportedObject> objects_;
};

/** The segment of each point, 0 for none. */
pcl::PointCloud<pcl::PointXYZL>::Ptr
segmentWithLccp (const Cloud::ConstPtr& cloud)
{
  constexpr float voxel_m = 0.0075f, seed_m = 0.03f, concavity_degrees = 10.f;
  pcl::SupervoxelClustering<pcl::PointXYZ> clustering (voxel_m, seed_m);
  clustering.setUseSingleCameraTransform (false);
  clustering.setInputCloud (cloud);
  clustering.setColorImportance (0.f);
  clustering.setSpatialImportance (1.f);
  clustering.setNormalImportance (4.f);
  std::map<std::uint32_t, pcl::Supervoxel<pcl::PointXYZ>::Ptr> supervoxels;
  clustering.extract (supervoxels);
  std::multimap<std::uint32_t, std::uint32_t> adjacency;
  clustering.getSupervoxelAdjacency (adjacency);

  pcl::LCCPSegmentation<pcl::PointXYZ> lccp;
  lccp.setConcavityToleranceThreshold (concavity_degrees);
  lccp.setSanityCheck (true);
  lccp.setSmoothnessCheck (true, voxel_m, seed_m, 0.1f);
  lccp.setKFactor (0);
  lccp.setInputSupervoxels (supervoxels, adjacency);
  lccp.setMinSegmentSize (0);
  lccp.segment();
  auto labelled = clustering.getLabeledCloud();
  lccp.relabelCloud (*labelled);
  return labelled;
}

} // namespace

Eigen::Affine3f
setPose (const std::optional<Eigen::Affine3f>& camera_to_base,
         const std::vector<pcl::ModelCoefficients>& models,
         pcl::SupportedObjectExtraction<pcl::PointXYZ, pcl::Normal>& extraction)
{
  const Eigen::Affine3f pose =
      camera_to_base ? *camera_to_base
                     : estimateCameraToBase (models).value_or (defaultCameraToBase());
  extraction.setBaseTransform (pose);
  const double lowest_m = camera_to_base ? 0. : -2.; // what has height 0 may be a table
  const double highest_m = camera_to_base ? 1.2 : 2.;
  extraction.setPlaneHeights (lowest_m, highest_m);
  return pose;
}

std::vector<ObjectMethod>
objectMethods ()
{
  std::vector<ObjectMethod> methods;
  for (const bool split : {false, true}) {
    const auto objects = std::make_shared<SupportedObjects> (split);
    methods.push_back (
        {split ? "supported_split" : "supported",
         [objects] (const ObjectInput& input, std::vector<FoundObject>& found) {
           return objects->compute (input, found);
         }});
  }
  return methods;
}

ObjectMethod
lccpMethod ()
{
  const auto compute = [] (const ObjectInput& input, std::vector<FoundObject>& found) {
    const auto start = Clock::now();
    const auto labelled = segmentWithLccp (input.cloud);
    const double milliseconds = millisecondsSince (start);
    std::map<std::uint32_t, FoundObject> segments;
    for (std::size_t i = 0; i < labelled->size(); ++i)
      if ((*labelled)[i].label != 0)
        segments[(*labelled)[i].label].indices.push_back (
            static_cast<pcl::index_t> (i));
    const auto points = [] (const auto& segment) {
      return segment.second.indices.size();
    };
    const auto table = std::max_element (
        segments.begin(), segments.end(), [&] (const auto& a, const auto& b) {
          return points (a) < points (b);
        });
    found.clear();
    for (auto segment = segments.begin(); segment != segments.end(); ++segment)
      if (segment != table && points (*segment) >= input.min_points)
        found.push_back (std::move (segment->second));
    return milliseconds;
  };
  return {"pcl_lccp", compute};
}

} // namespace rgbd_planes
} // namespace pcl
