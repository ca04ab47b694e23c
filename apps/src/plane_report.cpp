// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/csv.h>
#include <pcl/apps/obstacle_report.h>
#include <pcl/apps/plane_report.h>
#include <pcl/apps/statistics.h>

#include <boost/format.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>

namespace pcl {
namespace rgbd_planes {

namespace {

using Json = nlohmann::ordered_json;

struct Stage {
  const char* key;
  const char* title;
  double StageTimes::*time;
};

constexpr Stage stages[] = {
    {"normals", "normals", &StageTimes::normals},
    {"normal_space_clustering", "normal-space clustering", &StageTimes::normal_space},
    {"distance_space_clustering",
     "distance-space clustering",
     &StageTimes::distance_space},
    {"refinement", "refinement", &StageTimes::refinement},
    {"objects", "objects", &StageTimes::objects},
    {"obstacles", "obstacles", &StageTimes::obstacles},
    {"total", "total", &StageTimes::total}};

struct TimeRange {
  double min, median, max;
};

TimeRange
timeRange (const std::vector<FrameSummary>& frames, const Stage& stage)
{
  std::vector<double> times;
  for (const auto& frame : frames)
    times.push_back (frame.times.*stage.time);
  const auto [min, max] = std::minmax_element (times.begin(), times.end());
  return {*min, median (times), *max};
}

Json
toJson (const Eigen::Vector3f& vector)
{
  return {vector.x(), vector.y(), vector.z()};
}

Json
toJson (const ObjectSummary& summary)
{
  const auto& [object, points] = summary;
  return {{"plane", object.support},
          {"points", points},
          {"graspable", object.graspable},
          {"truncated", object.truncated},
          {"centroid_m", toJson (object.centroid)},
          {"box_center_m", toJson (object.box_center)},
          {"box_size_m", toJson (object.box_size)},
          {"box_axes",
           {toJson (object.box_axes.col (0)),
            toJson (object.box_axes.col (1)),
            toJson (object.box_axes.col (2))}}};
}

Json
toJson (const FrameSummary& frame)
{
  Json times, planes = Json::array();
  for (const Stage& stage : stages)
    times[stage.key] = frame.times.*stage.time;
  for (std::size_t id = 0; id < frame.planes.size(); ++id) {
    const PlaneSummary& plane = frame.planes[id];
    const auto& [a, b, c, d] = plane.coefficients;
    planes.push_back ({{"id", id},
                       {"normal", {a, b, c}},
                       {"distance_m", d},
                       {"points", plane.points},
                       {"rms_m", plane.rms},
                       {"class", plane.plane_class}});
  }
  Json objects = Json::array();
  for (const auto& object : frame.objects)
    objects.push_back (toJson (object));
  Json json{{"frame", frame.name},
            {"width", frame.width},
            {"height", frame.height},
            {"measured_points", frame.measured_points},
            {"labelled_points", frame.labelled_points},
            {"min_inliers", frame.min_inliers},
            {"stage_times_ms", times},
            {"planes", planes},
            {"rejections",
             {{"too_few_points", frame.rejections.too_few_points},
              {"curved", frame.rejections.curved},
              {"claimed_by_larger", frame.rejections.claimed_by_larger}}},
            {"objects", objects}};
  json.update (obstaclesJson (frame));
  return json;
}

Json
toJson (const InputOptions& options)
{
  Json settings{{"resolution_step", options.step}};
  if (options.intrinsics) {
    const auto& [fx, fy, cx, cy] = *options.intrinsics;
    settings["intrinsics"] = {fx, fy, cx, cy};
  }
  if (options.units_per_metre)
    settings["depth_units_per_m"] = *options.units_per_metre;
  return settings;
}

} // namespace

void
printPlanes (std::ostream& out, const FrameSummary& frame)
{
  out << boost::format (
             "%s: %d x %d, %d points measured, %.1f %% of them on %d planes\n") %
             frame.name % frame.width % frame.height % frame.measured_points %
             percentOf (frame.labelled_points,
                        std::max<std::size_t> (frame.measured_points, 1)) %
             frame.planes.size();
  if (frame.planes.empty())
    return;
  out << "  plane   normal x       y       z   distance m    points   rms mm   class\n";
  for (std::size_t id = 0; id < frame.planes.size(); ++id) {
    const PlaneSummary& plane = frame.planes[id];
    const auto& [a, b, c, d] = plane.coefficients;
    out << boost::format ("%7d   %8.4f %7.4f %7.4f   %10.4f %9d %8.2f   %s\n") % id %
               a % b % c % d % plane.points % (1e3 * plane.rms) % plane.plane_class;
  }
}

void
printObjects (std::ostream& out, const FrameSummary& frame)
{
  out << boost::format ("%s: %d objects\n") % frame.name % frame.objects.size();
  if (frame.objects.empty())
    return;
  out << "  object   on plane   centroid in camera frame   sides cm           height   "
         "points   graspable\n";
  for (std::size_t id = 0; id < frame.objects.size(); ++id) {
    const auto& [object, points] = frame.objects[id];
    const Eigen::Vector3f &at = object.centroid, cm = 100.f * object.box_size;
    out << boost::format (
               "%8d %10d %8.3f %7.3f %7.3f %8.1f x %5.1f x %5.1f %8d   %s\n") %
               id % object.support % at.x() % at.y() % at.z() % cm.x() % cm.y() %
               cm.z() % points %
               (object.truncated   ? "no, truncated"
                : object.graspable ? "yes"
                                   : "no");
  }
}

std::string
objectsCsv (const std::vector<FrameSummary>& frames)
{
  std::string csv =
      "frame,object,plane,points,graspable,centroid_x_m,centroid_y_m,centroid_z_m,"
      "box_x_m,box_y_m,box_z_m,size_1_m,size_2_m,height_m,axis_1_x,axis_1_y,axis_1_z,"
      "up_x,up_y,up_z,truncated\n";
  for (const auto& frame : frames)
    for (std::size_t id = 0; id < frame.objects.size(); ++id) {
      const auto& [object, points] = frame.objects[id];
      csv += csvText (frame.name) + ',' + std::to_string (id) + ',' +
             std::to_string (object.support) + ',' + std::to_string (points) +
             (object.graspable ? ",1" : ",0");
      const Eigen::Vector3f vectors[] = {object.centroid,
                                         object.box_center,
                                         object.box_size,
                                         object.box_axes.col (0),
                                         object.box_axes.col (2)};
      for (const auto& vector : vectors)
        csv += csvFields (vector);
      csv += object.truncated ? ",1\n" : ",0\n";
    }
  return csv;
}

std::string
planeText (const PlaneSummary& plane)
{
  const auto& [a, b, c, d] = plane.coefficients;
  return (boost::format (
              "%.4f x %+.4f y %+.4f z %+.4f = 0, %d points, rms %.1f mm, %s") %
          a % b % c % d % plane.points % (1e3 * plane.rms) % plane.plane_class)
      .str();
}

std::string
stageTimesText (const StageTimes& times)
{
  std::string text;
  for (const Stage& stage : stages)
    if (times.*stage.time > 0.)
      text += (boost::format ("%-26s %6.1f ms\n") % stage.title % (times.*stage.time))
                  .str();
  return text;
}

void
printStageTimes (std::ostream& out, const std::vector<FrameSummary>& frames)
{
  out << boost::format ("%-26s %8s %8s %8s   (over %d frames)\n") % "time in ms" %
             "min" % "median" % "max" % frames.size();
  for (const Stage& stage : stages) {
    const TimeRange range = timeRange (frames, stage);
    out << boost::format ("%-26s %8.2f %8.2f %8.2f\n") % stage.title % range.min %
               range.median % range.max;
  }
}

std::string
planesCsv (const std::vector<FrameSummary>& frames)
{
  std::string csv = "frame,plane,a,b,c,d,points,rms_m,class\n";
  for (const auto& frame : frames)
    for (std::size_t id = 0; id < frame.planes.size(); ++id) {
      const PlaneSummary& plane = frame.planes[id];
      const auto& [a, b, c, d] = plane.coefficients;
      csv += (boost::format ("%s,%d,%.9g,%.9g,%.9g,%.9g,%d,%.9g,%s\n") %
              csvText (frame.name) % id % a % b % c % d % plane.points % plane.rms %
              plane.plane_class)
                 .str();
    }
  return csv;
}

std::string
resultJson (const InputOptions& options, const std::vector<FrameSummary>& frames)
{
  Json times, results = Json::array();
  for (const Stage& stage : stages) {
    const TimeRange range = timeRange (frames, stage);
    times[stage.key] = {
        {"min", range.min}, {"median", range.median}, {"max", range.max}};
  }
  for (const auto& frame : frames)
    results.push_back (toJson (frame));
  const Json json{{"input", options.input},
                  {"settings", toJson (options)},
                  {"stage_times_ms", times},
                  {"frames", results}};
  // File names need not be UTF-8.
  return json.dump (2, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace rgbd_planes
} // namespace pcl
