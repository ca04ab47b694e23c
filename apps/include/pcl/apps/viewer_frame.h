// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_segmenter.h>
#include <pcl/segmentation/plane_tracker.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Everything that pcl_plane_viewer shows of a frame. */
class ViewerFrame {
public:
  /** \param[in] camera_to_base see SegmenterOptions::camera_to_base */
  explicit ViewerFrame (const std::optional<Eigen::Affine3f>& camera_to_base);

  /** \brief Finds the planes, objects and obstacles of the next frame, and which of the planes
   * are those of the frames before.
   * \param[in] step every step-th pixel of every step-th row is taken; AppError where that leaves
   * less than 2 x 2 of them
   */
  void
  compute (const Frame& frame, std::uint32_t step);

  /** \brief The pixels that were taken; none before the first frame. */
  const pcl::PointCloud<pcl::PointXYZRGB>&
  cloud () const
  {
    return *frame_.cloud;
  }

  const FrameSegmenter&
  segmenter () const
  {
    return segmenter_;
  }

  const FrameSummary&
  summary () const
  {
    return summary_;
  }

  /** \brief The identity of each plane, see PlaneTracker. */
  const std::vector<std::uint32_t>&
  ids () const
  {
    return ids_;
  }

  /** \brief The plane of the point that is nearest to a place in the camera frame, in words. */
  std::string
  describePlane (const Eigen::Vector3f& place) const;

private:
  FrameSegmenter segmenter_;
  pcl::PlaneTracker tracker_;
  Frame frame_;
  FrameSummary summary_;
  std::vector<std::uint32_t> ids_;
};

} // namespace rgbd_planes
} // namespace pcl
