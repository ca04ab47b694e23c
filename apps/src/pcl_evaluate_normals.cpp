// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/evaluation_command.h>
#include <pcl/apps/normal_comparison.h>
#include <pcl/apps/normal_report.h>

using namespace pcl::rgbd_planes;

namespace {

const char usage[] = "pcl_evaluate_normals INPUT... [options]\n\n"
                     "Compares the normals of our method, of PCL and of OpenCV with "
                     "true ones where the\n"
                     "input is simulated, and elsewhere with two-run principal "
                     "component analysis of the\n"
                     "full image. All frames of all inputs count together; without "
                     "--resolution, each of\n"
                     "the three is tried. Times are of one thread.\n";

void
evaluateNormals (int argc, char** argv)
{
  boost::program_options::options_description own ("Reference");
  own.add_options() (
      "far-reference",
      "let the radius of the reference grow as max (0.01 m + 0.01 z, 0.0085 z^2 / m) "
      "instead of 0.01 m + 0.01 z: for scenes beyond 2.5 m");
  const auto command = readEvaluationCommand (argc, argv, usage, own);
  if (!command)
    return;
  NormalComparison comparison (command->steps, command->values.count ("far-reference"));
  runEvaluation (
      *command,
      [&] (const Frame& frame) { comparison.add (frame); },
      [&] { return normalTable (comparison.results()); },
      [&] { return normalTableJson (comparison.results()); });
}

} // namespace

int
main (int argc, char** argv)
{
  return runApp ("pcl_evaluate_normals", [&] { evaluateNormals (argc, argv); });
}
