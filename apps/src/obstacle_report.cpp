// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/csv.h>
#include <pcl/apps/frame_truth.h>
#include <pcl/apps/obstacle_report.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <ostream>

namespace pcl {
namespace rgbd_planes {

namespace {

/** By PoseSource. */
constexpr const char* pose_names[] = {"given", "simulated", "estimated", "assumed"};

const char*
kindOf (const Obstacle& obstacle)
{
  return obstacle.kind == Obstacle::Kind::drop_off ? "drop_off" : "obstacle";
}

} // namespace

void
printObstacles (std::ostream& out, const FrameSummary& frame)
{
  out << boost::format ("%s: %d obstacles%s\n") % frame.name % frame.obstacles.size() %
             (frame.floor_found.value_or (false) ? ""
              : frame.measured_points == 0 ? ", no measured point: nothing is safe"
                                           : ", no floor found: nothing is safe; with "
                                             "the right --base-transform "
                                             "it is at z = 0");
  if (frame.obstacles.empty())
    return;
  out << "  obstacle   nearest m   direction deg   centroid in the base frame    "
         "points   kind\n";
  constexpr double degrees = 180. / M_PI;
  for (std::size_t id = 0; id < frame.obstacles.size(); ++id) {
    const auto& [obstacle, points, centroid] = frame.obstacles[id];
    out << boost::format ("%10d %11.3f %15.1f %12.3f %7.3f %7.3f %9d   %s\n") % id %
               obstacle.distance % (degrees * obstacle.direction) % centroid.x() %
               centroid.y() % centroid.z() % points % kindOf (obstacle);
  }
}

std::string
obstaclesCsv (const std::vector<FrameSummary>& frames)
{
  std::string csv =
      "frame,obstacle,kind,points,distance_m,direction_rad,nearest_x_m,nearest_y_m,"
      "nearest_z_m,centroid_x_m,centroid_y_m,centroid_z_m,min_height_m,max_height_m\n";
  for (const auto& frame : frames)
    for (std::size_t id = 0; id < frame.obstacles.size(); ++id) {
      const auto& [obstacle, points, centroid] = frame.obstacles[id];
      csv +=
          (boost::format ("%s,%d,%s,%d,%.6g,%.6g") % csvText (frame.name) % id %
           kindOf (obstacle) % points % obstacle.distance % obstacle.direction)
              .str() +
          csvFields (obstacle.nearest) + csvFields (centroid) +
          (boost::format (",%.6g,%.6g\n") % obstacle.min_height % obstacle.max_height)
              .str();
    }
  return csv;
}

std::string
scanCsv (const VirtualScan& scan)
{
  std::string csv = "direction_rad,range_m\n";
  for (std::size_t i = 0; i < scan.ranges.size(); ++i)
    csv += (boost::format ("%.6g,%.6g\n") %
            (scan.angle_min + static_cast<float> (i) * scan.angle_increment) %
            scan.ranges[i])
               .str();
  return csv;
}

nlohmann::ordered_json
obstaclesJson (const FrameSummary& frame)
{
  using Json = nlohmann::ordered_json;
  const auto toJson = [] (const Eigen::Vector3f& v) {
    return Json{v.x(), v.y(), v.z()};
  };
  Json camera_to_base, floor_found, scan, obstacles = Json::array();
  if (frame.floor_found) {
    floor_found = *frame.floor_found;
    scan = {{"angle_min_rad", frame.scan.angle_min},
            {"angle_increment_rad", frame.scan.angle_increment},
            {"ranges_m", frame.scan.ranges}}; // JSON has null for what is infinite
  }
  if (frame.camera_to_base)
    camera_to_base = poseJson (*frame.camera_to_base);
  for (const auto& [obstacle, points, centroid] : frame.obstacles)
    obstacles.push_back ({{"kind", kindOf (obstacle)},
                          {"points", points},
                          {"distance_m", obstacle.distance},
                          {"direction_rad", obstacle.direction},
                          {"nearest_m", toJson (obstacle.nearest)},
                          {"centroid_m", toJson (centroid)},
                          {"min_height_m", obstacle.min_height},
                          {"max_height_m", obstacle.max_height}});
  return {{"floor_found", floor_found},
          {"pose", pose_names[static_cast<int> (frame.pose)]},
          {"camera_to_base", camera_to_base},
          {"obstacles", obstacles},
          {"scan", scan}};
}

} // namespace rgbd_planes
} // namespace pcl
