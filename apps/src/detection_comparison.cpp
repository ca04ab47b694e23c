// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/detection_comparison.h>
#include <pcl/apps/input_options.h>
#include <pcl/apps/interruption.h>
#include <pcl/apps/measured_cloud.h>
#include <pcl/apps/object_comparison.h>
#include <pcl/apps/statistics.h>
#include <pcl/apps/stopwatch.h>
#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/simulation/subsample.h>

#include <boost/format.hpp>
#include <nlohmann/json.hpp>

namespace pcl {
namespace rgbd_planes {

DetectionComparison::DetectionComparison (const std::vector<std::uint32_t>& steps,
                                          const DepthNoise& noise)
: runs_ (steps.size())
{
  for (std::size_t i = 0; i < steps.size(); ++i) {
    runs_[i].step = steps[i];
    runs_[i].pipeline = DetectionPipeline<pcl::PointXYZ> (noise);
    results_.push_back (
        {resolutionName (steps[i]), {}, {}, ObstacleEvaluation (noise)});
  }
}

void
DetectionComparison::add (const Frame& frame)
{
  std::vector<std::uint32_t> obstacles;
  if (frame.truth)
    obstacles = numberObstacles (*frame.truth);
  const ObjectTruth objects = objectTruth (frame);
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    stopIfInterrupted();
    Run& run = runs_[i];
    const auto cloud = measuredCloud (frame, run.step, 2);
    // The first run pays for memory that later ones find in place.
    if (run.points != cloud->size())
      run.pipeline.detect (cloud, frame.camera_to_base);
    run.points = cloud->size();
    const Stopwatch watch;
    run.pipeline.detect (cloud, frame.camera_to_base);
    results_[i].milliseconds.push_back (watch.milliseconds());
    scoreObjects (frame,
                  objects,
                  run.step,
                  foundObjects (run.pipeline.objects),
                  results_[i].objects);
    if (frame.truth && frame.camera_to_base) {
      const auto truth = subsample (*frame.truth, run.step);
      const auto numbers = subsample (obstacles, frame.cloud->width, run.step);
      results_[i].obstacles.add (
          {viewPoints (*cloud), truth, numbers, *frame.camera_to_base},
          run.pipeline.detection.getClasses());
    }
  }
}

std::string
DetectionComparison::table() const
{
  std::string text = "size   objects      %  apart %  in pieces  false  points %  "
                     "obstacles      %  false floor %"
                     "      Hz\n";
  for (const auto& result : results_) {
    const ObstacleEvaluation& o = result.obstacles;
    const auto figures = objectFigures (result.objects);
    const auto figure = [&] (const char* key, int digits) {
      const auto& value = figures.at (key);
      return value.is_null() ? "-" : numberText (value.get<double>(), digits);
    };
    text +=
        (boost::format ("%-5s %8d %6s %8s %10s %6s %9s %10d %6s %14s %7.1f\n") %
         result.resolution % result.objects.all().objects %
         figure ("objects_percent", 1) % figure ("apart_50_percent", 1) %
         figure ("objects_in_pieces", 0) % figure ("false_objects", 0) %
         figure ("false_object_points_percent", 3) % o.obstacles %
         numberText (o.obstaclesPercent(), 1) % numberText (o.falsePointsPercent(), 3) %
         (1000. / median (result.milliseconds)))
            .str();
  }
  return text;
}

nlohmann::ordered_json
DetectionComparison::rows() const
{
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const auto& result : results_) {
    const ObstacleEvaluation& o = result.obstacles;
    nlohmann::ordered_json row = {{"resolution", result.resolution}};
    row.update (objectFigures (result.objects));
    row["obstacles"] = o.obstacles;
    row["obstacles_percent"] = o.obstaclesPercent();
    row["floor_points"] = o.floor_points;
    row["false_obstacle_points_percent"] = o.falsePointsPercent();
    row["false_of_all_floor_points_percent"] =
        percentOf (o.all_false_points, o.all_floor_points);
    row["rate_hz"] = 1000. / median (result.milliseconds);
    rows.push_back (std::move (row));
  }
  return rows;
}

} // namespace rgbd_planes
} // namespace pcl
