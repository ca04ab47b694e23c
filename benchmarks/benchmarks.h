// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "clouds.h"
#include <hwy/targets.h>

#include <pcl/apps/interruption.h>

#include <benchmark/benchmark.h>

#include <string>

namespace pcl {
namespace rgbd_planes {

void
registerNormalBenchmarks (const Clouds& frames);

void
registerPlaneBenchmarks (const Clouds& frames);

void
registerObjectBenchmarks (const Clouds& frames, const BaseTransforms& camera_to_base);

/** \brief Registers run (state), which reports an error or calls measure(). */
template <typename Run>
void
addBenchmark (const std::string& name, const Run& run)
{
  benchmark::RegisterBenchmark (name.c_str(), run)->Unit (benchmark::kMillisecond);
}

/** \brief Registers run (state) once for each set of instructions that this processor has, and
 * for none: as name/SET. */
template <typename Run>
void
addInstructionBenchmarks (const std::string& name, const Run& run)
{
  for (const auto instructions : hwy::SupportedAndGeneratedTargets())
    addBenchmark (name + '/' + hwy::TargetName (instructions),
                  [=] (benchmark::State& state) {
                    hwy::SetSupportedTargetsForTest (instructions);
                    run (state);
                    hwy::SetSupportedTargetsForTest (0);
                  });
}

/** \brief Times compute (cloud). An iteration is one cloud, and all of them get as many;
 * before that, each is computed once so that all memory is in place. */
template <typename Compute>
void
measure (benchmark::State& state, const Clouds& clouds, const Compute& compute)
{
  const auto compute_all = [&] {
    for (const auto& cloud : clouds) {
      stopIfInterrupted();
      compute (cloud);
    }
  };
  compute_all();
  while (
      state.KeepRunningBatch (static_cast<benchmark::IterationCount> (clouds.size())))
    compute_all();
  const auto points = static_cast<std::int64_t> (clouds.front()->size());
  state.SetItemsProcessed (state.iterations() * points);
  state.counters["points"] = static_cast<double> (points);
}

} // namespace rgbd_planes
} // namespace pcl
