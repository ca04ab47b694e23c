// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/depth_correction.h>
#include <pcl/apps/detection_comparison.h>
#include <pcl/apps/evaluation_command.h>
#include <pcl/apps/input_options.h>
#include <pcl/apps/object_comparison.h>
#include <pcl/apps/plane_truth.h>

#include <boost/program_options/options_description.hpp>
#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace po = boost::program_options;

using namespace pcl::rgbd_planes;

namespace {

const char usage[] =
    R"(pcl_evaluate_detection INPUT... [options]

Compares detected objects and obstacles with true ones where the input is simulated, and
objects where it is a .pcd file with labels of objects (field label, as in mOSD). All
frames of all inputs count together; without --resolution, each of the three is tried.

Objects count if they have 50 points (so at smaller sizes fewer count), are 1 to 30 cm high, and
are within 3.5 m. One is found when the points of one cluster and its own have an intersection
over union of 0.5. It stands apart when no other is within 2 cm at full resolution, and is in
pieces when two or more clusters have at least half of their points on it. False is a cluster
with less than half of its points on any object. The file of --json also tells how many are found
of the objects that count at full resolution, and how many of the boxes that stand apart and were
found have sides within 1 cm or 10 % of the true ones: of all, and of those that are seen, with
measured points over both horizontal sides and up to the top.

Obstacles count in frames that see the floor, from the larger of 1 cm and three standard
deviations of depth on, and are found when half of their points are. False are floor points that
are called an obstacle. The rate is that of all stages on one thread: normals, planes, objects,
obstacles, without the correction of points.

  pcl_evaluate_detection sim:table_cluttered sim:floor_obstacles --json detection.json
  pcl_evaluate_detection folder_of_pcds --resolution qvga
)";

using FrameCallbacks = std::vector<std::function<void (const Frame&)>>;

unsigned
minInliers (const Frame& frame)
{
  return minPlanePoints (frame, frame.cloud->size());
}

FrameCallbacks
calibration (DepthCorrection& correction)
{
  FrameCallbacks steps;
  for (const auto& calibrate : correction.calibration())
    steps.push_back ([calibrate] (const Frame& frame) {
      calibrate (coordinates (frame), minInliers (frame));
    });
  return steps;
}

void
evaluateDetection (int argc, char** argv)
{
  po::options_description own ("Objects", help_width);
  own.add_options() ("object-methods",
                     "a second table: objects with and without the split at concave "
                     "edges, and those of PCL's LCCPSegmentation, which takes long");
  addCorrectedOption (own);
  addDepthNoiseOption (own);
  const auto command = readEvaluationCommand (argc, argv, usage, own);
  if (!command)
    return;
  const DepthNoise noise = readDepthNoise (command->values);
  DetectionComparison comparison (command->steps, noise);
  std::optional<ObjectComparison> objects;
  if (command->values.count ("object-methods"))
    objects.emplace (command->steps, noise);
  std::optional<DepthCorrection> correction;
  if (const auto option = readCorrected (command->values))
    correction.emplace (*option);
  std::size_t frames = 0, with_truth = 0;
  const auto add = [&] (const Frame& frame) {
    ++frames;
    with_truth += frame.truth || frame.labels.kind == PointLabels::Kind::objects;
    comparison.add (frame);
    if (objects)
      objects->add (frame);
  };
  runEvaluation (
      *command,
      [&] (const Frame& measured, OutputFiles&) {
        if (correction)
          add (correction->correct (measured, minInliers (measured)));
        else
          add (measured);
      },
      [&] { return comparison.table() + (objects ? '\n' + objects->table() : ""); },
      [&] {
        nlohmann::ordered_json json = {{"results", comparison.rows()}};
        if (objects)
          json["object_methods"] = objects->rows();
        return json.dump (2) + '\n';
      },
      correction ? calibration (*correction) : FrameCallbacks());
  if (with_truth == 0)
    printNotice ("no truth in this input: only the rate is measured");
  else if (with_truth < frames)
    printNotice (std::to_string (frames - with_truth) + " of " +
                 std::to_string (frames) +
                 " frames have no truth: of them only the rate is measured");
}

} // namespace

int
main (int argc, char** argv)
{
  return runApp ("pcl_evaluate_detection", [&] { evaluateDetection (argc, argv); });
}
