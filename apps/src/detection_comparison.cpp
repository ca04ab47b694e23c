// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/detection_comparison.h>
#include <pcl/apps/input_options.h>
#include <pcl/apps/statistics.h>
#include <pcl/common/io.h>
#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/simulation/subsample.h>

#include <boost/format.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Every step-th of the numbers of an image in each direction, as subsample(). */
std::vector<std::uint32_t>
subsampleNumbers (const std::vector<std::uint32_t>& numbers,
                  std::uint32_t width,
                  std::uint32_t step)
{
  std::vector<std::uint32_t> result;
  const std::size_t height = numbers.size() / width;
  for (std::size_t v = 0; v < height; v += step)
    for (std::size_t u = 0; u < width; u += step)
      result.push_back (numbers[v * width + u]);
  return result;
}

std::string
number (double value, const char* format)
{
  return std::isnan (value) ? "-" : (boost::format (format) % value).str();
}

nlohmann::ordered_json
orNull (double value)
{
  return std::isnan (value) ? nlohmann::ordered_json() : nlohmann::ordered_json (value);
}

} // namespace

DetectionComparison::DetectionComparison (const std::vector<std::uint32_t>& steps)
: runs_ (steps.size())
{
  for (std::size_t i = 0; i < steps.size(); ++i) {
    runs_[i].step = steps[i];
    runs_[i].normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
    runs_[i].labels = pcl::make_shared<pcl::PointCloud<pcl::Label>>();
    results_.push_back ({resolutionName (steps[i]), {}, {}});
  }
}

double
DetectionComparison::detect (const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud,
                             const Frame& frame,
                             Run& run)
{
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers, label_indices;
  decltype (run.segmentation)::Centroids centroids;
  decltype (run.segmentation)::Covariances covariances;
  const auto start = std::chrono::steady_clock::now();
  run.estimation.setInputCloud (cloud);
  run.estimation.compute (*run.normals);
  run.segmentation.setInputCloud (cloud);
  run.segmentation.setInputNormals (run.normals);
  run.segmentation.setMinInliers (
      static_cast<unsigned> (cloud->size() * 1000 / (640 * 480)));
  run.segmentation.segment (
      models, inliers, centroids, covariances, *run.labels, label_indices);
  if (frame.camera_to_base) {
    run.detection.setCameraToBase (*frame.camera_to_base);
    run.detection.setInputCloud (cloud);
    run.detection.setInputNormals (run.normals);
    run.detection.setInputPlanes (models, run.labels);
    run.detection.detect (run.obstacles);
  }
  const std::chrono::duration<double, std::milli> elapsed =
      std::chrono::steady_clock::now() - start;
  return elapsed.count();
}

void
DetectionComparison::add (const Frame& frame)
{
  pcl::PointCloud<pcl::PointXYZ> full;
  pcl::copyPointCloud (*frame.cloud, full);
  std::vector<std::uint32_t> obstacles;
  if (frame.truth)
    obstacles = numberObstacles (*frame.truth);
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    Run& run = runs_[i];
    const auto cloud =
        pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> (subsample (full, run.step));
    // The first run pays for memory that later ones find in place.
    if (run.points != cloud->size())
      detect (cloud, frame, run);
    run.points = cloud->size();
    results_[i].milliseconds.push_back (detect (cloud, frame, run));
    if (frame.truth && frame.camera_to_base) {
      const auto truth = subsample (*frame.truth, run.step);
      const auto numbers = subsampleNumbers (obstacles, full.width, run.step);
      results_[i].obstacles.add (
          {viewPoints (*cloud), truth, numbers, *frame.camera_to_base},
          run.detection.getClasses());
    }
  }
}

std::string
DetectionComparison::table() const
{
  std::string text = "size   obstacles  found      %  floor points  false %      Hz\n";
  for (const auto& result : results_) {
    const ObstacleEvaluation& o = result.obstacles;
    text += (boost::format ("%-5s %10d %6d %6s %13d %8s %7.1f\n") % result.resolution %
             o.obstacles % o.found_obstacles % number (o.obstaclesPercent(), "%.1f") %
             o.floor_points % number (o.falsePointsPercent(), "%.3f") %
             (1000. / median (result.milliseconds)))
                .str();
  }
  return text;
}

std::string
DetectionComparison::json() const
{
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const auto& result : results_)
    rows.push_back (
        {{"resolution", result.resolution},
         {"obstacles_percent", orNull (result.obstacles.obstaclesPercent())},
         {"false_obstacle_points_percent",
          orNull (result.obstacles.falsePointsPercent())},
         {"rate_hz", 1000. / median (result.milliseconds)}});
  return nlohmann::ordered_json ({{"results", rows}}).dump (2) + '\n';
}

} // namespace rgbd_planes
} // namespace pcl
