// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/input_options.h>
#include <pcl/apps/interruption.h>
#include <pcl/apps/measured_cloud.h>
#include <pcl/apps/pictures.h>
#include <pcl/apps/plane_comparison.h>
#include <pcl/apps/plane_truth.h>
#include <pcl/features/impl/organized_cloud_view.h>
#include <pcl/simulation/subsample.h>

#include <algorithm>
#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

/** The first run pays for memory that later ones find in place, and any may be interrupted.
 */
constexpr int runs_per_frame = 3;

} // namespace

PlaneComparison::PlaneComparison (const std::vector<std::uint32_t>& steps,
                                  const std::optional<RightAngles::Pairs>& right_angles,
                                  const PlaneMethodOptions& options)
: right_angles_ (right_angles)
{
  for (const auto step : steps)
    for (auto& method : planeMethods (options)) {
      results_.push_back ({method.name, resolutionName (step), {}, {}, {}, {}, {}, {}});
      runs_.push_back ({step, std::move (method), {}});
    }
}

std::vector<std::function<void (const Frame&)>>
PlaneComparison::calibration()
{
  std::vector<std::function<void (const Frame&)>> steps;
  for (const Run& run : runs_)
    for (const auto& calibrate : run.method.calibration)
      steps.push_back ([step = run.step, calibrate] (const Frame& frame) {
        const auto cloud = measuredCloud (frame, step, min_pcl_pixels);
        calibrate (cloud, minPlanePoints (frame, cloud->size()));
      });
  return steps;
}

void
PlaneComparison::add (const Frame& frame)
{
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    stopIfInterrupted();
    Run& run = runs_[i];
    const auto cloud = measuredCloud (frame, run.step, min_pcl_pixels);
    const unsigned min_points = minPlanePoints (frame, cloud->size());
    double fastest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < runs_per_frame; ++k)
      fastest = std::min (fastest, run.method.compute (cloud, min_points, run.found));
    results_[i].milliseconds.push_back (fastest);
    score (frame, cloud, run, results_[i]);
  }
}

void
PlaneComparison::writePictures (const Frame& frame,
                                const std::filesystem::path& folder,
                                OutputFiles& files) const
{
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const auto cloud = subsample (*frame.cloud, runs_[i].step);
    pcl::PointCloud<pcl::Label> labels (cloud.width, cloud.height);
    for (std::size_t k = 0; k < labels.size(); ++k)
      labels[k].label = runs_[i].found.labels[k];
    files.write (folder / (frame.name + '_' + results_[i].method + '_' +
                           results_[i].resolution + ".png"),
                 encodePng (planesPicture (cloud, labels)));
  }
}

void
PlaneComparison::score (const Frame& frame,
                        const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud,
                        const Run& run,
                        PlaneResult& result) const
{
  const OrganizedPoints points = viewPoints (*run.found.cloud);
  const unsigned min_points = minPlanePoints (frame, cloud->size());
  const auto truth = truePlanes (frame, run.step);
  if (truth)
    result.evaluation.add (points, run.found, *truth, min_points);
  else
    result.evaluation.add (points, run.found);
  if (frame.truth) {
    const auto pixels = subsample (*frame.truth, run.step);
    const Eigen::Vector3f up = frame.camera_to_base->linear().row (2);
    result.curved.add (points, run.found, pixels);
    result.correction.add (cloud, run.found, *truth, pixels, up, min_points);
  }
  if (frame.labels.kind == PointLabels::Kind::objects)
    result.object_labels.add (
        points, run.found, subsample (frame.labels.points, run.step));
  if (right_angles_)
    result.right_angles.add (points, run.found, *right_angles_);
}

} // namespace rgbd_planes
} // namespace pcl
