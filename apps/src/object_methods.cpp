// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/detection_pipeline.h>
#include <pcl/apps/min_points.h>
#include <pcl/apps/object_methods.h>
#include <pcl/apps/stopwatch.h>
#include <pcl/segmentation/lccp_segmentation.h>
#include <pcl/segmentation/supervoxel_clustering.h>

#include <algorithm>
#include <map>
#include <memory>

namespace pcl {
namespace rgbd_planes {

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** The segment of each point, 0 for none. */
pcl::PointCloud<pcl::PointXYZL>::Ptr
segmentWithLccp (const Cloud::ConstPtr& cloud)
{
  constexpr float voxel_m = 0.0075f, seed_m = 0.03f, concavity_degrees = 10.f;
  constexpr std::uint32_t min_supervoxels = 3;
  pcl::SupervoxelClustering<pcl::PointXYZ> clustering (voxel_m, seed_m);
  clustering.setUseSingleCameraTransform (true);
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
  lccp.setMinSegmentSize (min_supervoxels);
  lccp.segment();
  auto labelled = clustering.getLabeledCloud();
  lccp.relabelCloud (*labelled);
  return labelled;
}

} // namespace

std::vector<ObjectMethod>
objectMethods (const DepthNoise& noise)
{
  std::vector<ObjectMethod> methods;
  for (const bool split : {false, true}) {
    const auto pipeline =
        std::make_shared<DetectionPipeline<pcl::PointXYZ>> (noise, split);
    methods.push_back (
        {split ? "supported_split" : "supported",
         [pipeline] (const ObjectInput& input, std::vector<FoundObject>& found) {
           const Stopwatch watch;
           pipeline->segment (input.cloud, input.camera_to_base);
           pipeline->findObjects();
           const double milliseconds = watch.milliseconds();
           found = foundObjects (pipeline->objects);
           return milliseconds;
         }});
  }
  return methods;
}

ObjectMethod
lccpMethod ()
{
  const auto compute = [] (const ObjectInput& input, std::vector<FoundObject>& found) {
    const Stopwatch watch;
    const auto labelled = segmentWithLccp (input.cloud);
    const double milliseconds = watch.milliseconds();
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
      if (segment != table &&
          points (*segment) >= minObjectPoints (input.cloud->size()))
        found.push_back (std::move (segment->second));
    return milliseconds;
  };
  return {"pcl_lccp", compute};
}

} // namespace rgbd_planes
} // namespace pcl
