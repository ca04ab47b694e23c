// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/fit_camera.h>
#include <pcl/apps/input_notices.h>
#include <pcl/apps/statistics.h>
#include <pcl/features/impl/frame_noise.h>
#include <pcl/features/impl/organized_cloud_view.h>

#include <boost/format.hpp>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Whether most points lie where a pinhole camera sees them, but for what lenses distort. */
bool
isInCameraFrame (const pcl::PointCloud<pcl::PointXYZRGB>& cloud)
{
  constexpr float max_distortion = 0.1f; // in widths and heights of the image
  const Intrinsics camera = fitCamera (cloud);
  if (camera.fx < 0.f || camera.fy < 0.f)
    return false;
  std::size_t measured = 0, seen = 0;
  for (std::uint32_t v = 0; v < cloud.height; ++v)
    for (std::uint32_t u = 0; u < cloud.width; ++u) {
      const auto& p = cloud (u, v);
      if (!isMeasured (p.data))
        continue;
      ++measured;
      const float column = camera.fx * p.x / p.z + camera.cx;
      const float row = camera.fy * p.y / p.z + camera.cy;
      seen += p.z > 0.f &&
              std::fabs (column - static_cast<float> (u)) <
                  max_distortion * static_cast<float> (cloud.width) &&
              std::fabs (row - static_cast<float> (v)) <
                  max_distortion * static_cast<float> (cloud.height);
    }
  return 2 * seen >= measured;
}

} // namespace

void
InputNotices::add (const Frame& frame, const FrameSummary& summary)
{
  const auto& cloud = *frame.cloud;
  const std::size_t measured = summary.measured_points;
  const auto count = [&] (const auto& condition) {
    return static_cast<std::size_t> (
        std::count_if (cloud.begin(), cloud.end(), [&] (const auto& point) {
          return isMeasured (point.data) && condition (squaredRange (point.data));
        }));
  };
  ++frames_;
  measured_points_ += measured;
  points_out_of_range_ += count ([&] (float squared_range) {
    return squared_range > options_.depth_noise.maxSquaredRange();
  });
  unmeasured_frames_ += measured == 0;
  constexpr float nearest = 0.01f, farthest = 100.f; // of what depth cameras see
  const bool is_too_near = 2 * count ([] (float squared_range) {
                             return squared_range < nearest * nearest;
                           }) >
                           measured;
  const bool is_too_far = 2 * count ([] (float squared_range) {
                            return squared_range > farthest * farthest;
                          }) >
                          measured;
  if (is_too_near || is_too_far)
    ++frames_out_of_scale_;
  else {
    const DepthNoise& given = options_.depth_noise;
    const DepthNoise noise = noiseIn (viewPoints (cloud), {}, given);
    points_too_noisy_ += count ([&] (float squared_range) {
      return 10.f * noise.sigmaAtSquare (squared_range) > std::sqrt (squared_range) &&
             squared_range <= given.maxSquaredRange();
    });
    noisy_frames_ += noise.constant >= DepthNoise::max_ratio * given.constant &&
                     noise.quadratic >= DepthNoise::max_ratio * given.quadratic;
    frames_elsewhere_ += !isInCameraFrame (cloud);
  }
  if (summary.pose == PoseSource::estimated &&
      (options_.find_objects || options_.find_obstacles))
    addEstimatedPose (frame, summary);
}

void
InputNotices::addEstimatedPose (const Frame& frame, const FrameSummary& summary)
{
  const float height = summary.camera_to_base->translation().z();
  least_height_ = std::min (least_height_, height);
  largest_height_ = std::max (largest_height_, height);
  if (estimated_pose_.empty())
    estimated_pose_ =
        (boost::format ("pose of the camera: estimated, in %s from plane %d as the "
                        "floor, at a distance of %.2f m; --base-transform gives the "
                        "true one") %
         frame.name % summary.floor % height)
            .str();
}

void
InputNotices::addWarp (const pcl::PointCloud<pcl::Intensity>& warp)
{
  is_warp_empty_ = std::all_of (warp.begin(), warp.end(), [] (const auto& point) {
    return point.intensity == 0.f;
  });
}

std::vector<std::string>
InputNotices::lines() const
{
  constexpr double max_percent_left_out = 10.;
  constexpr float max_change = 0.2f; // of the height of a camera that drives
  std::vector<std::string> lines;
  const auto tellIf = [&lines] (bool is_so, const boost::format& line) {
    if (is_so)
      lines.push_back (line.str());
  };
  const auto percent = [this] (std::size_t points) {
    return percentOf (points, std::max<std::size_t> (measured_points_, 1));
  };
  const DepthNoise& noise = options_.depth_noise;
  tellIf (percent (points_out_of_range_) > max_percent_left_out &&
              std::isfinite (noise.max_range),
          boost::format ("--depth-noise: %.0f %% of the measured points are beyond the "
                         "%.1f m of this sensor and are left out; %g,%g,%g is the same "
                         "noise without a limit") %
              percent (points_out_of_range_) % noise.max_range % noise.constant %
              noise.quadratic % noise.normal_scatter);
  tellIf (
      percent (points_too_noisy_) > max_percent_left_out,
      boost::format ("--depth-noise: %.0f %% of the measured points have noise of "
                     "more than a tenth of their range, which tells nothing; figures "
                     "are in metres, 0.001,0.002 for 1 mm + 2 mm z^2") %
          percent (points_too_noisy_));
  tellIf (2 * noisy_frames_ > frames_,
          boost::format ("--depth-noise: %d of %d frames seem to have four times the "
                         "noise of this sensor, or more; pcl_measure_depth_noise "
                         "measures what they have") %
              noisy_frames_ % frames_);
  tellIf (unmeasured_frames_ > 0,
          boost::format ("no measured point in %d of %d frames: all depth is missing "
                         "there; check the camera or the recording") %
              unmeasured_frames_ % frames_);
  tellIf (frames_out_of_scale_ > 0,
          boost::format ("in %d of %d frames most points are more than 100 m or less "
                         "than 1 cm away: --depth-scale is units per metre, 1000 for "
                         "millimetres; .pcd files must be in metres") %
              frames_out_of_scale_ % frames_);
  tellIf (frames_elsewhere_ > 0,
          boost::format ("in %d of %d frames most points are not where a camera sees "
                         "them: x right, y down and z forward from the camera is "
                         "expected; give clouds in the frame of the camera, or its "
                         "--intrinsics if they are wrong") %
              frames_elsewhere_ % frames_);
  tellIf (is_warp_empty_,
          boost::format ("--corrected camera: no plane told the error of depth, and "
                         "nothing is corrected; give frames with walls or floor"));
  if (!estimated_pose_.empty())
    lines.push_back (estimated_pose_);
  tellIf (
      largest_height_ - least_height_ > max_change,
      boost::format ("pose of the camera: estimated at %.2f to %.2f m above what is "
                     "taken for the floor, which may be a table in some frames; "
                     "--base-transform gives the true one") %
          least_height_ % largest_height_);
  return lines;
}

} // namespace rgbd_planes
} // namespace pcl
