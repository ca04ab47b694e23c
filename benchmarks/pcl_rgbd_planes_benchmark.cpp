// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "benchmarks.h"

#include <pcl/apps/app_error.h>
#include <pcl/apps/command_line.h>
#include <pcl/apps/input_options.h>

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

#include <iostream>

using namespace pcl::rgbd_planes;

namespace {

void
printHelp ()
{
  std::cout << R"(pcl_rgbd_planes_benchmark [INPUT...] [options]

Times our normals, planes and objects beside those of PCL, in ms per frame of the inputs;
without INPUT, of sim:table_cluttered and sim:room. Resolutions are chosen with
--benchmark_filter, not --resolution.

  pcl_rgbd_planes_benchmark --benchmark_filter=planes/.*/vga
  pcl_rgbd_planes_benchmark my.pcd --benchmark_out=times.json

)" << input_help
            << '\n'
            << inputOptionsDescription() << '\n'
            << exit_help << "\nGoogle Benchmark:\n";
  benchmark::PrintDefaultHelp();
}

std::vector<InputOptions>
readInputs (int argc, char** argv)
{
  const auto values =
      parseCommandLine (argc, argv, inputOptionsDescription(), "input", -1);
  if (!values["resolution"].defaulted())
    throw AppError (
        "--resolution: is part of a benchmark's name; use --benchmark_filter");
  std::vector<std::string> names{"sim:table_cluttered", "sim:room"};
  if (values.count ("input"))
    names = values["input"].as<std::vector<std::string>>();
  std::vector<InputOptions> inputs;
  for (const auto& name : names)
    inputs.push_back (readInputOptions (name, values));
  return inputs;
}

void
runBenchmarks (int argc, char** argv)
{
  benchmark::Initialize (&argc, argv, printHelp);
  BaseTransforms camera_to_base;
  const Clouds frames = readClouds (readInputs (argc, argv), camera_to_base);
  registerNormalBenchmarks (frames);
  registerPlaneBenchmarks (frames);
  registerObjectBenchmarks (frames, camera_to_base);
  if (benchmark::RunSpecifiedBenchmarks() == 0)
    throw AppError ("nothing matches --benchmark_filter; see --benchmark_list_tests");
  benchmark::Shutdown();
}

} // namespace

int
main (int argc, char** argv)
{
  return runApp ("pcl_rgbd_planes_benchmark", [&] { runBenchmarks (argc, argv); });
}
