// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/input_options.h>
#include <pcl/apps/plane_comparison.h>
#include <pcl/apps/statistics.h>
#include <pcl/common/io.h>
#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/segmentation/plane_assignment.h>
#include <pcl/simulation/subsample.h>

#include <boost/format.hpp>
#include <nlohmann/json.hpp>

namespace pcl {
namespace rgbd_planes {

namespace {

/** PCL's integral-image normals need their smoothing area inside the image. */
constexpr std::uint32_t min_pixels = 40;

PlaneSet
truePlanes (const Frame& frame, std::uint32_t step)
{
  PlaneSet truth;
  truth.coefficients = frame.true_planes;
  for (const auto& point : subsample (*frame.truth, step))
    truth.labels.push_back (point.label == 0 ? unlabelled : point.label - 1);
  return truth;
}

} // namespace

PlaneComparison::PlaneComparison (const std::vector<std::uint32_t>& steps)
{
  for (const auto step : steps)
    for (auto& method : planeMethods()) {
      results_.push_back ({method.name, resolutionName (step), {}, {}});
      runs_.push_back ({step, std::move (method), 0, {}});
    }
}

void
PlaneComparison::add (const Frame& frame)
{
  pcl::PointCloud<pcl::PointXYZ> full;
  pcl::copyPointCloud (*frame.cloud, full);
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    Run& run = runs_[i];
    const auto cloud =
        pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> (subsample (full, run.step));
    if (cloud->width < min_pixels || cloud->height < min_pixels)
      throw AppError (frame.name + ": is too small as " + results_[i].resolution +
                      ", 40 x 40 pixels are needed; use --resolution vga or larger "
                      "frames");
    const auto min_points = static_cast<unsigned> (cloud->size() * 1000 / (640 * 480));
    // The first run pays for memory that later ones find in place.
    if (run.points != cloud->size())
      run.method.compute (cloud, min_points, run.found);
    run.points = cloud->size();
    results_[i].milliseconds.push_back (
        run.method.compute (cloud, min_points, run.found));
    if (frame.truth)
      results_[i].evaluation.add (
          viewPoints (*cloud), run.found, truePlanes (frame, run.step), min_points);
    else
      results_[i].evaluation.add (viewPoints (*cloud), run.found);
  }
}

std::string
PlaneComparison::table() const
{
  std::string text =
      "method        size        ms  truth  found  correct   over  under  missed  noise"
      "    F1   IoU  covered    off   angle  distance\n"
      "                                               80 %                             "
      "   0.5           %      %     deg        mm\n";
  for (const auto& result : results_) {
    const PlaneEvaluation& e = result.evaluation;
    text += (boost::format ("%-13s %-5s %8.2f ") % result.method % result.resolution %
             median (result.milliseconds))
                .str();
    if (e.hasTruth())
      text += (boost::format ("%6d %6d %8d %6d %6d %7d %6d %5.2f %5.2f") %
               e.planes_truth % e.planes_found % e.correct % e.over % e.under %
               e.missed % e.noise % e.f1() % e.meanIou())
                  .str();
    else
      text += (boost::format ("%6s %6d %8s %6s %6s %7s %6s %5s %5s") % '-' %
               e.planes_found % '-' % '-' % '-' % '-' % '-' % '-' % '-')
                  .str();
    text +=
        (boost::format (" %8.1f %6.2f") % e.coveragePercent() % e.offPercent()).str();
    if (e.hasTruth())
      text += (boost::format (" %7.2f %9.2f") % e.medianAngleDegrees() %
               e.medianDistanceMillimetres())
                  .str();
    else
      text += (boost::format (" %7s %9s") % '-' % '-').str();
    text += '\n';
  }
  return text;
}

std::string
PlaneComparison::json() const
{
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const auto& result : results_) {
    const PlaneEvaluation& e = result.evaluation;
    const auto withTruth = [&e] (const nlohmann::ordered_json& value) {
      return e.hasTruth() ? value : nlohmann::ordered_json();
    };
    rows.push_back (
        {{"method", result.method},
         {"resolution", result.resolution},
         {"ms_median", median (result.milliseconds)},
         {"planes_truth", withTruth (e.planes_truth)},
         {"planes_found", e.planes_found},
         {"correct_80", withTruth (e.correct)},
         {"over", withTruth (e.over)},
         {"under", withTruth (e.under)},
         {"missed", withTruth (e.missed)},
         {"noise", withTruth (e.noise)},
         {"f1_50", withTruth (e.f1())},
         {"mean_iou", withTruth (e.meanIou())},
         {"coverage_percent", e.coveragePercent()},
         {"off_percent", e.offPercent()},
         {"median_angle_error_deg", withTruth (e.medianAngleDegrees())},
         {"median_distance_error_mm", withTruth (e.medianDistanceMillimetres())}});
  }
  return nlohmann::ordered_json ({{"results", rows}}).dump (2) + '\n';
}

} // namespace rgbd_planes
} // namespace pcl
