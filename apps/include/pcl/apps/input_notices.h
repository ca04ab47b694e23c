// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_segmenter.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Collects what makes the results of a run doubtful though nothing is wrong with its
 * command line: frames without depth, or in another unit than metres, a range or noise of the
 * sensor that leaves out many points, clouds that are not in the frame of the camera, a pose
 * that is a guess. */
class InputNotices {
public:
  explicit InputNotices (const SegmenterOptions& options) : options_ (options) {}

  void
  add (const Frame& frame, const FrameSummary& summary);

  /** \brief What planes of all frames told of the error of depth. */
  void
  addWarp (const pcl::PointCloud<pcl::Intensity>& warp);

  /** \brief A line for each thing to know, for all frames. */
  std::vector<std::string>
  lines () const;

private:
  void
  addEstimatedPose (const Frame& frame, const FrameSummary& summary);

  SegmenterOptions options_;
  std::size_t frames_ = 0;
  std::size_t measured_points_ = 0;
  std::size_t points_out_of_range_ = 0;
  std::size_t points_too_noisy_ = 0;
  std::size_t noisy_frames_ = 0;
  std::size_t unmeasured_frames_ = 0;
  std::size_t frames_out_of_scale_ = 0;
  std::size_t frames_elsewhere_ = 0;
  bool is_warp_empty_ = false;
  /** About the first frame with an estimated pose. */
  std::string estimated_pose_;
  /** Of the camera above the floor, of all such frames, in metres. */
  float least_height_ = std::numeric_limits<float>::infinity(), largest_height_ = 0.f;
};

} // namespace rgbd_planes
} // namespace pcl
