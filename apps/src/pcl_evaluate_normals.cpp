// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/evaluation_command.h>
#include <pcl/apps/input_options.h>
#include <pcl/apps/normal_comparison.h>
#include <pcl/apps/normal_report.h>

#include <boost/program_options/value_semantic.hpp>

#include <algorithm>

namespace po = boost::program_options;

using namespace pcl::rgbd_planes;

namespace {

const char usage[] =
    R"(pcl_evaluate_normals INPUT... [options]

Compares the normals of our method, of PCL and of OpenCV with true ones where the input is
simulated, and elsewhere with two-run principal component analysis of the full image. Prints
a table: errors in degrees, the share of normals more than 25 degrees off, of points with a
normal (coverage), and times in ms on one thread. All frames of all inputs count together;
without --resolution, each of the three is tried.

  pcl_evaluate_normals sim:room sim:table_single --json normals.json
  pcl_evaluate_normals my.pcd --resolution qvga
)";

RadiusFunction
readRadius (const po::variables_map& values)
{
  if (!values.count ("far-reference")) {
    const auto [a, b] =
        parseCoefficients ("--radius", values["radius"].as<std::string>(), "A,B");
    return [a = a, b = b] (float z) { return a + b * z; };
  }
  if (!values["radius"].defaulted())
    throw AppError ("--radius and --far-reference exclude each other");
  return [] (float z) { return std::max (0.01f + 0.01f * z, 0.0085f * z * z); };
}

void
evaluateNormals (int argc, char** argv)
{
  po::options_description own ("Two-run principal component analysis", help_width);
  own.add_options() (
      "radius",
      po::value<std::string>()->value_name ("A,B")->default_value ("0.01,0.01"),
      "take neighbours within A + B z, in metres") (
      "far-reference",
      "take neighbours within max (0.01 m + 0.01 z, 0.0085 z^2 / m): for scenes beyond "
      "2.5 m");
  const auto command = readEvaluationCommand (argc, argv, usage, own);
  if (!command)
    return;
  NormalComparison comparison (command->steps, readRadius (command->values));
  runEvaluation (
      *command,
      [&] (const Frame& frame, OutputFiles&) { comparison.add (frame); },
      [&] { return normalTable (comparison.results()); },
      [&] { return normalTableJson (comparison.results()); });
}

} // namespace

int
main (int argc, char** argv)
{
  return runApp ("pcl_evaluate_normals", [&] { evaluateNormals (argc, argv); });
}
