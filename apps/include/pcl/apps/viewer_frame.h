// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/depth_correction.h>
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
  /** \param[in] camera_to_base see SegmenterOptions::camera_to_base
   * \param[in] corrected how points are corrected, of a frame or with a file; nothing leaves
   * them as measured
   * \param[in] depth_noise of points that are not corrected
   */
  explicit ViewerFrame (const std::optional<Eigen::Affine3f>& camera_to_base,
                        const std::optional<CorrectedOption>& corrected = std::nullopt,
                        const DepthNoise& depth_noise = DepthNoise::kinectV1());

  /** \brief Finds the planes, objects and obstacles of the next frame, and which of the planes
   * are those of the frames before.
   * \param[in] step every step-th pixel of every step-th row is taken; AppError where that leaves
   * less than 2 x 2 of them, or a frame of another size than its correction
   */
  void
  compute (const Frame& frame, std::uint32_t step);

  /** \brief Whether the next frames are corrected, which needs a correction, or left as they
   * are measured. */
  void
  setCorrected (bool corrected);

  bool
  isCorrected () const
  {
    return options_.corrected_points;
  }

  /** \brief The last frame, with the pixels that were taken. */
  const Frame&
  frame () const
  {
    return frame_;
  }

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
  SegmenterOptions options_;
  FrameSegmenter segmenter_;
  std::optional<DepthCorrection> correction_;
  pcl::PlaneTracker tracker_;
  Frame frame_;
  FrameSummary summary_;
  std::vector<std::uint32_t> ids_;
};

} // namespace rgbd_planes
} // namespace pcl
