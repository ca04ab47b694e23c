// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "benchmarks.h"

#include <pcl/apps/app_error.h>
#include <pcl/apps/command_line.h>
#include <pcl/apps/input_options.h>
#include <pcl/apps/interruption.h>
#include <pcl/apps/output_files.h>

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

#include <algorithm>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>

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

)" << inputHelp()
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

/** Keeps the rows for a file in memory. Google Benchmark itself writes one by one, does not see
 * when a disk is full, and leaves half a file after an interruption. */
class Results : public benchmark::JSONReporter {
public:
  bool
  ReportContext (const Context& context) override
  {
    SetOutputStream (&json_);
    return JSONReporter::ReportContext (context);
  }

  std::string
  json () const
  {
    return json_.str();
  }

private:
  std::ostringstream json_;
};

/** Takes the file of --benchmark_out=FILE from the arguments, where there is one. */
std::optional<std::string>
takeResultFile (int argc, char** argv)
{
  static char nowhere[] = "--benchmark_out=/dev/null";
  const std::string option = "--benchmark_out=", format = "--benchmark_out_format=";
  std::optional<std::string> file;
  std::for_each (argv + 1, argv + argc, [&] (char*& argument) {
    const std::string text = argument;
    if (text.rfind (format, 0) == 0 && text != format + "json")
      throw AppError (text +
                      ": files are JSON; for other formats use --benchmark_format");
    if (text.rfind (option, 0) == 0 && text != option) {
      file = text.substr (option.size());
      argument = nowhere;
    }
  });
  return file;
}

void
runBenchmarks (int argc, char** argv)
{
  const auto file = takeResultFile (argc, argv);
  benchmark::Initialize (&argc, argv, printHelp);
  catchInterruption();
  const auto inputs = readInputs (argc, argv);
  OutputFiles files;
  // An unwritable place is known before the work is done.
  if (file) {
    for (const auto& input : inputs)
      files.protect (FrameSource (input).files());
    files.reserve (*file);
  }
  BaseTransforms camera_to_base;
  const Clouds frames = readClouds (inputs, camera_to_base);
  registerNormalBenchmarks (frames);
  registerPlaneBenchmarks (frames);
  registerObjectBenchmarks (frames, camera_to_base);
  Results results;
  if (benchmark::RunSpecifiedBenchmarks (nullptr, file ? &results : nullptr) == 0)
    throw AppError ("nothing matches --benchmark_filter; see --benchmark_list_tests");
  benchmark::Shutdown();
  if (file)
    files.write (*file, results.json());
  files.commit();
}

} // namespace

int
main (int argc, char** argv)
{
  return runApp ("pcl_rgbd_planes_benchmark", [&] { runBenchmarks (argc, argv); });
}
