// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/plane_comparison_table.h>
#include <pcl/apps/statistics.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace pcl {
namespace rgbd_planes {

namespace {

double
worst (const std::vector<double>& milliseconds)
{
  return *std::max_element (milliseconds.begin(), milliseconds.end());
}

/** Columns of numbers, right-aligned; '-' for NaN. */
class Row {
public:
  explicit Row (const PlaneResult& result)
  {
    text_ << std::left << std::setw (15) << result.method << ' ' << std::setw (5)
          << result.resolution << std::right;
  }

  Row&
  number (double value, int width, int digits = 0)
  {
    text_ << std::setw (width) << numberText (value, digits);
    return *this;
  }

  std::string
  line () const
  {
    return text_.str() + '\n';
  }

private:
  std::ostringstream text_;
};

std::string
mainRow (const PlaneResult& result)
{
  const PlaneEvaluation& e = result.evaluation;
  const auto withTruth = [&e] (auto value) {
    return e.hasTruth() ? static_cast<double> (value) : std::nan ("");
  };
  return Row (result)
      .number (median (result.milliseconds), 9, 2)
      .number (worst (result.milliseconds), 8, 2)
      .number (withTruth (e.planes_truth), 7)
      .number (static_cast<double> (e.planes_found), 7)
      .number (withTruth (e.correct), 9)
      .number (withTruth (e.over), 7)
      .number (withTruth (e.under), 7)
      .number (withTruth (e.missed), 8)
      .number (withTruth (e.noise), 7)
      .number (withTruth (e.f1()), 6, 2)
      .number (withTruth (e.meanIou()), 6, 2)
      .number (e.coveragePercent(), 9, 1)
      .number (e.offPercent(), 7, 2)
      .number (e.medianAngleDegrees(), 8, 2)
      .number (e.medianDistanceMillimetres(), 10, 2)
      .line();
}

bool
hasSceneFigures (const PlaneResult& result)
{
  return !std::isnan (result.object_labels.tableIou()) ||
         !std::isnan (result.object_labels.purityPercent()) ||
         !std::isnan (result.curved.labelledPercent()) ||
         !std::isnan (result.right_angles.medianDegrees());
}

std::string
sceneRow (const PlaneResult& result)
{
  const RightAngles& right = result.right_angles;
  return Row (result)
      .number (result.object_labels.tableIou(), 11, 3)
      .number (result.object_labels.worstTableIou(), 7, 3)
      .number (result.object_labels.purityPercent(), 8, 2)
      .number (result.curved.labelledPercent(), 17, 2)
      .number (result.curved.shatteredPercent(), 11, 2)
      .number (right.medianDegrees(), 14, 2)
      .number (right.pairsWithinPercent(), 16, 1)
      .number (right.framesWithinPercent(), 9, 1)
      .number (static_cast<double> (right.frames()), 10)
      .line();
}

bool
hasCorrection (const PlaneResult& result)
{
  return result.correction.before.points > 0 || !result.correction.walls.errors.empty();
}

std::string
correctionRow (const PlaneResult& result)
{
  const PlaneCorrection& c = result.correction;
  return Row (result)
      .number (static_cast<double> (c.before.points), 11)
      .number (c.before.rmsMillimetres(), 11, 1)
      .number (c.along_ray.rmsMillimetres(), 11, 1)
      .number (c.along_normal.rmsMillimetres(), 13, 1)
      .number (c.fits_along_ray.rmsMillimetres(), 6, 1)
      .number (static_cast<double> (c.walls.errors.size()), 12)
      .number (c.walls.medianDegrees(), 9, 2)
      .number (c.walls.withinPercent(), 10, 1)
      .number (c.fits_walls.medianDegrees(), 7, 2)
      .number (c.fits_walls.withinPercent(), 10, 1)
      .line();
}

nlohmann::ordered_json
jsonRow (const PlaneResult& result)
{
  const PlaneEvaluation& e = result.evaluation;
  const RightAngles& right = result.right_angles;
  const PlaneCorrection& c = result.correction;
  const auto withTruth = [&e] (const nlohmann::ordered_json& value) {
    return e.hasTruth() ? value : nlohmann::ordered_json();
  };
  return {{"method", result.method},
          {"resolution", result.resolution},
          {"ms_median", median (result.milliseconds)},
          {"ms_worst", worst (result.milliseconds)},
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
          {"median_distance_error_mm", withTruth (e.medianDistanceMillimetres())},
          {"table_iou", result.object_labels.tableIou()},
          {"table_iou_worst", result.object_labels.worstTableIou()},
          {"purity_percent", result.object_labels.purityPercent()},
          {"curved_labelled_percent", result.curved.labelledPercent()},
          {"curved_shattered_percent", result.curved.shatteredPercent()},
          {"right_angle_median_deg", right.medianDegrees()},
          {"right_angle_pairs_percent", right.pairsWithinPercent()},
          {"right_angle_frames_percent", right.framesWithinPercent()},
          {"right_angle_frames", right.frames()},
          {"far_points", c.before.points},
          {"far_rms_before_mm", c.before.rmsMillimetres()},
          {"far_rms_along_ray_mm", c.along_ray.rmsMillimetres()},
          {"far_rms_along_normal_mm", c.along_normal.rmsMillimetres()},
          {"far_rms_fit_mm", c.fits_along_ray.rmsMillimetres()},
          {"wall_pairs", c.walls.errors.size()},
          {"wall_angle_median_deg", c.walls.medianDegrees()},
          {"wall_angle_percent", c.walls.withinPercent()},
          {"wall_angle_fit_median_deg", c.fits_walls.medianDegrees()},
          {"wall_angle_fit_percent", c.fits_walls.withinPercent()}};
}

const char main_header[] = "method          size        ms   worst  truth  found  "
                           "correct   over  under  missed"
                           "  noise    F1   IoU  covered    off   angle  distance\n"
                           "                                                         "
                           "80 %                      "
                           "          0.5           %      %     deg        mm\n";

const char scene_header[] =
    "\n"
    "method          size   table IoU  worst  purity  curved labelled  shattered"
    "  right angles  pairs in 2 deg   frames  of frames\n"
    "                                              %                %          %"
    "        off by               %        %\n";

const char correction_header[] =
    "\n"
    "method          size  far points  rms before  along ray  along normal"
    "   fit  wall pairs  off by   in 1 deg    fit  in 1 deg\n"
    "                                         mm         mm            mm"
    "    mm                 deg         %    deg         %\n";

std::string
table (std::string header,
       std::string (*row) (const PlaneResult&),
       const std::vector<PlaneResult>& results)
{
  for (const auto& result : results)
    header += row (result);
  return header;
}

} // namespace

std::string
planeComparisonTable (const std::vector<PlaneResult>& results)
{
  std::string text = table (main_header, mainRow, results);
  if (std::any_of (results.begin(), results.end(), hasSceneFigures))
    text += table (scene_header, sceneRow, results);
  if (std::any_of (results.begin(), results.end(), hasCorrection))
    text += table (correction_header, correctionRow, results);
  return text;
}

std::string
planeComparisonJson (const std::vector<PlaneResult>& results)
{
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const auto& result : results)
    rows.push_back (jsonRow (result));
  return nlohmann::ordered_json ({{"results", rows}}).dump (2) + '\n';
}

} // namespace rgbd_planes
} // namespace pcl
