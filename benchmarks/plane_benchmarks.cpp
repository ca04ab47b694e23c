// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "benchmarks.h"

#include <pcl/apps/input_options.h>
#include <pcl/apps/min_points.h>
#include <pcl/apps/plane_methods.h>
#include <pcl/features/integral_image_tangent_normal.h>
#include <pcl/segmentation/normal_space_plane_segmentation.h>

namespace pcl {
namespace rgbd_planes {

namespace {

void
normalSpace (benchmark::State& state, const Clouds& clouds)
{
  pcl::IntegralImageTangentNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  pcl::NormalSpacePlaneSegmentation<pcl::PointXYZ, pcl::Normal> segmentation;
  segmentation.setMinInliers (minPlanePoints (clouds.front()->size()));
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  double normal_space_s = 0., distance_space_s = 0., calls = 0.;
  measure (state, clouds, [&] (const Cloud::ConstPtr& cloud) {
    estimation.setInputCloud (cloud);
    estimation.compute (*normals);
    segmentation.setInputCloud (cloud);
    segmentation.setInputNormals (normals);
    segmentation.segment (models, inliers);
    const PlaneStageTimes& times = segmentation.getStageTimes();
    normal_space_s += times.normal_space;
    distance_space_s += times.distance_space;
    calls += 1.;
  });
  state.counters["normal_space_ms"] = 1e3 * normal_space_s / calls;
  state.counters["distance_space_ms"] = 1e3 * distance_space_s / calls;
}

void
organizedMultiPlane (benchmark::State& state, const Clouds& clouds)
{
  const auto find = organizedMultiPlanes();
  const unsigned min_inliers = minPlanePoints (clouds.front()->size());
  SegmentedPlanes planes;
  measure (state, clouds, [&] (const Cloud::ConstPtr& cloud) {
    find (cloud, min_inliers, planes);
  });
}

} // namespace

void
registerPlaneBenchmarks (const Clouds& frames)
{
  for (const std::uint32_t step : {1u, 2u, 4u}) {
    const std::string resolution = '/' + resolutionName (step);
    addBenchmark ("planes/normal_space" + resolution, [=] (benchmark::State& state) {
      normalSpace (state, subsample (frames, step));
    });
    addBenchmark ("planes/pcl_omps" + resolution, [=] (benchmark::State& state) {
      organizedMultiPlane (state, subsample (frames, step));
    });
  }
  addInstructionBenchmarks (
      "planes/normal_space_instructions",
      [=] (benchmark::State& state) { normalSpace (state, frames); });
}

} // namespace rgbd_planes
} // namespace pcl
