// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/evaluation_command.h>
#include <pcl/apps/plane_comparison.h>

using namespace pcl::rgbd_planes;

namespace {

const char usage[] =
    "pcl_evaluate_planes INPUT... [options]\n\n"
    "Compares our planes and those of PCL's OrganizedMultiPlaneSegmentation with true "
    "ones"
    "\nwhere the input is simulated, after Hoover et al. (1996) at 80 % overlap. All "
    "frames"
    "\nof all inputs count together; without --resolution, each of the three is tried."
    "\nTimes are of one thread and include the normals. Labelled points further than"
    "\n5 mm + 4 mm z^2 from their plane are off.\n";

void
evaluatePlanes (int argc, char** argv)
{
  const auto command = readEvaluationCommand (argc, argv, usage, {});
  if (!command)
    return;
  PlaneComparison comparison (command->steps);
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
  return runApp ("pcl_evaluate_planes", [&] { evaluatePlanes (argc, argv); });
}
