// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/detection_comparison.h>
#include <pcl/apps/evaluation_command.h>

using namespace pcl::rgbd_planes;

namespace {

const char usage[] =
    "pcl_evaluate_detection INPUT... [options]\n\n"
    "Compares detected obstacles with true ones where the input is simulated. All "
    "frames"
    "\nof all inputs count together; without --resolution, each of the three is tried."
    "\nObstacles count from the larger of 1 cm and three standard deviations of depth "
    "on,"
    "\nand are found when half of their points are. False are floor points that are "
    "called"
    "\nan obstacle. The rate is that of all stages on one thread.\n";

void
evaluateDetection (int argc, char** argv)
{
  const auto command = readEvaluationCommand (argc, argv, usage, {});
  if (!command)
    return;
  DetectionComparison comparison (command->steps);
  runEvaluation (
      *command,
      [&] (const Frame& frame) { comparison.add (frame); },
      [&] { return comparison.table(); },
      [&] { return comparison.json(); });
}

} // namespace

int
main (int argc, char** argv)
{
  return runApp ("pcl_evaluate_detection", [&] { evaluateDetection (argc, argv); });
}
