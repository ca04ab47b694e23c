// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_slot.h>
#include <pcl/apps/viewer_frame.h>
#include <pcl/apps/viewer_layers.h>
#include <pcl/apps/viewer_window.h>

#include <chrono>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

struct ViewerOptions {
  /** See SegmenterOptions::camera_to_base. */
  std::optional<Eigen::Affine3f> camera_to_base;
  /** Of the sensor. */
  DepthNoise depth_noise = DepthNoise::kinectV1();
  /** See ViewerFrame. */
  std::optional<CorrectedOption> corrected;
  ViewerLayers layers;
  /** Every step-th pixel of every step-th row is taken. */
  std::uint32_t step = 1;
  /** What plays is paused after so many frames. */
  std::size_t max_frames = std::numeric_limits<std::size_t>::max();
  /** Where views are saved. */
  std::filesystem::path output = ".";
  /** Files that views do not replace. */
  std::vector<std::filesystem::path> inputs;
};

/** \brief What the keys of the viewer do, one a line. */
std::string
viewerKeysHelp ();

/** \brief The window of pcl_plane_viewer, and what its keys do. */
class PlaneViewer {
public:
  explicit PlaneViewer (const ViewerOptions& options);

  /** \brief Stops the grabber. */
  ~PlaneViewer();

  /** \brief Finds the planes of a frame, and shows it. */
  void
  show (const Frame& frame);

  /** \brief Starts a grabber, whose frames update() shows, and which keys control. It must
   * outlive the viewer. */
  void
  play (pcl::Grabber& grabber);

  /** \brief Shows the newest frame, if there is one, which is waited for a little, and does what
   * the user wants. False once the window is closed. */
  bool
  update ();

  /** \brief What the text at the top of the window says. */
  const std::string&
  status () const
  {
    return status_;
  }

  ViewerWindow&
  window ()
  {
    return window_;
  }

private:
  /** \brief False for a key without a meaning. */
  bool
  takeKey (char key);

  void
  takePoint (const Eigen::Vector3f& point);

  void
  pauseOrGoOn ();

  /** \brief Shows one more frame, and pauses. */
  void
  stepOn ();

  void
  changeResolution ();

  void
  switchCorrection ();

  /** \brief The same frame, after the resolution or the correction changed. */
  void
  computeAgain ();

  void
  save ();

  void
  printNotices () const;

  /** \brief After frame_ or the layers changed. */
  void
  draw ();

  /** \brief After anything else changed. */
  void
  refresh ();

  std::string
  statusText () const;

  ViewerOptions options_;
  ViewerWindow window_;
  FrameSlot slot_;
  pcl::Grabber* grabber_ = nullptr;
  std::size_t frames_left_;
  /** As it came; nothing before the first one. */
  std::optional<Frame> original_;
  ViewerFrame frame_;
  bool is_view_chosen_ = false;
  bool help_is_shown_ = false;
  /** What was done last: a plane that was picked, or a file that was saved. */
  std::string message_;
  std::string status_;
  /** When the last frames were shown. */
  std::deque<std::chrono::steady_clock::time_point> times_;
};

} // namespace rgbd_planes
} // namespace pcl
