// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/input_options.h>
#include <pcl/apps/interruption.h>
#include <pcl/apps/object_comparison.h>
#include <pcl/apps/statistics.h>
#include <pcl/common/io.h>
#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/simulation/subsample.h>

#include <boost/format.hpp>
#include <nlohmann/json.hpp>

#include <cmath>

namespace pcl {
namespace rgbd_planes {

ObjectTruth
objectTruth (const Frame& frame)
{
  ObjectTruth truth;
  if (frame.truth) {
    for (const auto& point : *frame.truth)
      truth.ids.push_back (point.object);
    truth.objects = frame.true_objects;
  }
  else if (frame.labels.kind == PointLabels::Kind::objects) {
    // The labels of mOSD are 10 times the object and its part, those below 20 the table.
    for (const auto& point : frame.labels.points) {
      const std::uint32_t object = point.label / 10;
      truth.ids.push_back (object >= 2 ? object : 0);
    }
  }
  else {
    return truth;
  }
  const OrganizedPoints points = viewPoints (*frame.cloud);
  lookAtFullSize (points, frame.truth ? viewPoints (*frame.truth) : points, truth);
  return truth;
}

void
scoreObjects (const Frame& frame,
              const ObjectTruth& truth,
              std::uint32_t step,
              const std::vector<FoundObject>& found,
              ObjectEvaluation& evaluation)
{
  if (truth.ids.empty())
    return;
  ObjectTruth sampled = truth;
  sampled.ids = subsample (truth.ids, frame.cloud->width, step);
  const auto cloud = subsample (*frame.cloud, step);
  if (!frame.truth)
    return evaluation.add (viewPoints (cloud), viewPoints (cloud), sampled, found);
  const auto positions = subsample (*frame.truth, step);
  evaluation.add (viewPoints (cloud), viewPoints (positions), sampled, found);
}

nlohmann::ordered_json
objectFigures (const ObjectEvaluation& e)
{
  const ObjectCounts all = e.all();
  const bool known = !std::isnan (e.falsePointsPercent());
  const auto count = [&] (std::size_t number) {
    return known ? nlohmann::ordered_json (number) : nlohmann::ordered_json();
  };
  return {
      {"objects_percent", percentOf (all.found_50, all.objects)},
      {"false_objects", count (e.false_objects)},
      {"false_object_points_percent", e.falsePointsPercent()},
      {"full_size_objects", count (e.full_size_objects)},
      {"full_size_objects_percent", percentOf (e.full_size_found, e.full_size_objects)},
      {"objects_in_pieces", count (all.in_pieces)},
      {"objects_80_percent", percentOf (all.found_80, all.objects)},
      {"objects_apart", count (e.apart.objects)},
      {"apart_50_percent", percentOf (e.apart.found_50, e.apart.objects)},
      {"apart_80_percent", percentOf (e.apart.found_80, e.apart.objects)},
      {"objects_touching", count (e.touching.objects)},
      {"touching_50_percent", percentOf (e.touching.found_50, e.touching.objects)},
      {"touching_80_percent", percentOf (e.touching.found_80, e.touching.objects)},
      {"sized", count (e.sized)},
      {"graspable_right_percent", percentOf (e.graspable_right, e.sized)},
      {"boxes", count (e.boxes)},
      {"boxes_right_percent", percentOf (e.boxes_right, e.boxes)},
      {"boxes_seen", count (e.boxes_seen)},
      {"boxes_seen_right_percent", percentOf (e.boxes_seen_right, e.boxes_seen)}};
}

ObjectComparison::ObjectComparison (const std::vector<std::uint32_t>& steps,
                                    const DepthNoise& noise)
{
  for (const auto step : steps) {
    auto methods = objectMethods (noise);
    methods.push_back (lccpMethod());
    for (auto& method : methods) {
      results_.push_back ({method.name, resolutionName (step), {}, {}});
      runs_.push_back ({step, std::move (method), 0, {}});
    }
  }
}

void
ObjectComparison::add (const Frame& frame)
{
  const ObjectTruth truth = objectTruth (frame);
  if (truth.ids.empty())
    return;
  pcl::PointCloud<pcl::PointXYZ> full;
  pcl::copyPointCloud (*frame.cloud, full);
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    stopIfInterrupted();
    Run& run = runs_[i];
    ObjectInput input;
    input.cloud =
        pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> (subsample (full, run.step));
    input.camera_to_base = frame.camera_to_base;
    // The first run pays for memory that later ones find in place.
    if (run.points != input.cloud->size())
      run.method.compute (input, run.found);
    run.points = input.cloud->size();
    results_[i].milliseconds.push_back (run.method.compute (input, run.found));
    scoreObjects (frame, truth, run.step, run.found, results_[i].evaluation);
  }
}

std::string
ObjectComparison::table() const
{
  std::string text = "objects          size        ms   apart  at 0.5  at 0.8  "
                     "touching  at 0.5  at 0.8  "
                     "all at 0.5  at 0.8  in pieces  false  graspable  boxes\n"
                     "                                              %       %          "
                     "       %       %  "
                     "         %       %                    right %  right %\n";
  for (const auto& result : results_) {
    const ObjectEvaluation& e = result.evaluation;
    const auto counts = [] (const ObjectCounts& c) {
      return std::make_pair (numberText (percentOf (c.found_50, c.objects), 1),
                             numberText (percentOf (c.found_80, c.objects), 1));
    };
    const auto apart = counts (e.apart), touching = counts (e.touching),
               all = counts (e.all());
    text +=
        (boost::format (
             "%-15s %-5s %9s %7d %7s %7s %9d %7s %7s %11s %7s %10d %6d %10s %6s\n") %
         result.method % result.resolution %
         numberText (median (result.milliseconds), 1) % e.apart.objects % apart.first %
         apart.second % e.touching.objects % touching.first % touching.second %
         all.first % all.second % e.all().in_pieces % e.false_objects %
         numberText (percentOf (e.graspable_right, e.sized), 1) %
         numberText (percentOf (e.boxes_right, e.boxes), 1))
            .str();
  }
  return text;
}

nlohmann::ordered_json
ObjectComparison::rows() const
{
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const auto& result : results_) {
    nlohmann::ordered_json row = {{"method", result.method},
                                  {"resolution", result.resolution},
                                  {"ms_median", median (result.milliseconds)}};
    row.update (objectFigures (result.evaluation));
    rows.push_back (std::move (row));
  }
  return rows;
}

} // namespace rgbd_planes
} // namespace pcl
