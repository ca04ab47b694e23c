// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "benchmarks.h"

#include <pcl/apps/detection_pipeline.h>
#include <pcl/apps/input_options.h>
#include <pcl/apps/object_methods.h>

namespace pcl {
namespace rgbd_planes {

namespace {

void
findObjects (benchmark::State& state,
             const Clouds& clouds,
             const BaseTransforms& camera_to_base,
             const ObjectMethod& method)
{
  ObjectInput input;
  std::vector<FoundObject> found;
  std::size_t frame = 0; // the clouds come in turn
  measure (state, clouds, [&] (const Cloud::ConstPtr& cloud) {
    input.cloud = cloud;
    input.camera_to_base = camera_to_base[frame++ % clouds.size()];
    method.compute (input, found);
  });
}

/** Normals, planes, objects and obstacles. */
void
runPipeline (benchmark::State& state,
             const Clouds& clouds,
             const BaseTransforms& camera_to_base)
{
  DetectionPipeline<pcl::PointXYZ> pipeline;
  std::size_t frame = 0; // the clouds come in turn
  measure (state, clouds, [&] (const Cloud::ConstPtr& cloud) {
    pipeline.detect (cloud, camera_to_base[frame++ % clouds.size()]);
  });
}

/** Obstacles alone, of planes that are known. */
void
findObstacles (benchmark::State& state,
               const Clouds& clouds,
               const BaseTransforms& camera_to_base)
{
  std::vector<DetectionPipeline<pcl::PointXYZ>> pipelines (clouds.size());
  for (std::size_t i = 0; i < clouds.size(); ++i)
    pipelines[i].segment (clouds[i], camera_to_base[i]);
  std::size_t frame = 0; // the clouds come in turn
  measure (state, clouds, [&] (const Cloud::ConstPtr&) {
    pipelines[frame++ % clouds.size()].findObstacles();
  });
}

} // namespace

void
registerObjectBenchmarks (const Clouds& frames, const BaseTransforms& camera_to_base)
{
  auto methods = objectMethods();
  methods.push_back (lccpMethod());
  for (const std::uint32_t step : {1u, 2u, 4u}) {
    addBenchmark ("pipeline/all/" + resolutionName (step),
                  [=] (benchmark::State& state) {
                    runPipeline (state, subsample (frames, step), camera_to_base);
                  });
    addBenchmark ("obstacles/detection/" + resolutionName (step),
                  [=] (benchmark::State& state) {
                    findObstacles (state, subsample (frames, step), camera_to_base);
                  });
    for (const auto& method : methods)
      addBenchmark ("objects/" + method.name + '/' + resolutionName (step),
                    [=] (benchmark::State& state) {
                      findObjects (
                          state, subsample (frames, step), camera_to_base, method);
                    });
  }
  addInstructionBenchmarks ("pipeline/all_instructions", [=] (benchmark::State& state) {
    runPipeline (state, frames, camera_to_base);
  });
}

} // namespace rgbd_planes
} // namespace pcl
