// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/frame_segmenter.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

class Stopwatch {
public:
  double
  milliseconds () const
  {
    return std::chrono::duration<double, std::milli> (Clock::now() - start_).count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

unsigned
defaultMinInliers (std::size_t pixels)
{
  constexpr std::size_t vga = 640 * 480;
  return static_cast<unsigned> (
      std::max<std::size_t> ((1000 * pixels + vga / 2) / vga, 3));
}

PlaneSummary
summarize (const pcl::PointCloud<pcl::PointXYZRGB>& cloud,
           const pcl::ModelCoefficients& model,
           const pcl::Indices& inliers)
{
  PlaneSummary plane;
  std::copy_n (model.values.begin(), 4, plane.coefficients.begin());
  plane.points = inliers.size();
  const auto& [a, b, c, d] = plane.coefficients;
  double squares = 0.;
  for (const auto index : inliers) {
    const auto& p = cloud[static_cast<std::size_t> (index)];
    const double distance = a * p.x + b * p.y + c * p.z + d;
    squares += distance * distance;
  }
  plane.rms = std::sqrt (squares / static_cast<double> (inliers.size()));
  return plane;
}

} // namespace

FrameSegmenter::FrameSegmenter (std::optional<unsigned> min_inliers)
: min_inliers_ (min_inliers)
, normals_ (new pcl::PointCloud<pcl::Normal>)
{
  estimation_.setViewPoint (0.f, 0.f, 0.f);
}

FrameSummary
FrameSegmenter::segment (const Frame& frame)
{
  const auto& cloud = *frame.cloud;
  FrameSummary summary;
  summary.name = frame.name;
  summary.width = cloud.width;
  summary.height = cloud.height;
  summary.measured_points = static_cast<std::size_t> (std::count_if (
      cloud.begin(), cloud.end(), [] (const auto& p) { return std::isfinite (p.z); }));
  summary.min_inliers = min_inliers_.value_or (defaultMinInliers (cloud.size()));

  const Stopwatch total;
  estimation_.setInputCloud (frame.cloud);
  estimation_.compute (*normals_);
  summary.times.normals = total.milliseconds();
  segmentation_.setInputCloud (frame.cloud);
  segmentation_.setInputNormals (normals_);
  segmentation_.setMinInliers (summary.min_inliers);
  segmentation_.segment (coefficients_, inliers_);
  summary.times.total = total.milliseconds();
  const PlaneStageTimes& seconds = segmentation_.getStageTimes();
  summary.times.normal_space = 1e3 * seconds.normal_space;
  summary.times.distance_space = 1e3 * seconds.distance_space;
  summary.times.refinement = 1e3 * seconds.refinement;

  pcl::Label none;
  none.label = unlabelled;
  labels_ = pcl::PointCloud<pcl::Label> (cloud.width, cloud.height, none);
  for (std::size_t id = 0; id < inliers_.size(); ++id) {
    for (const auto index : inliers_[id].indices)
      labels_[static_cast<std::size_t> (index)].label = static_cast<std::uint32_t> (id);
    summary.planes.push_back (
        summarize (cloud, coefficients_[id], inliers_[id].indices));
    summary.labelled_points += inliers_[id].indices.size();
  }
  return summary;
}

} // namespace rgbd_planes
} // namespace pcl
