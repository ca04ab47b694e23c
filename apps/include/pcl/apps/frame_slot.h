// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_source.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <optional>

namespace pcl {

class Grabber;

namespace rgbd_planes {

/** \brief The newest frame of a grabber, which is never kept waiting: a frame that nobody took
 * is dropped for the next one. */
class FrameSlot {
public:
  /** \brief Takes all frames of \a grabber from now on: those of FrameGrabber, or clouds of
   * PointXYZRGB or PointXYZ. AppError where it gives none of these. The grabber must be stopped
   * before the slot goes. */
  void
  connect (pcl::Grabber& grabber);

  void
  put (Frame frame);

  /** \brief An error of the grabber, which the next take() throws. */
  void
  fail (std::exception_ptr error);

  /** \brief The newest frame, which is waited for; nothing where none came since the last
   * call. */
  std::optional<Frame>
  take (std::chrono::milliseconds patience = std::chrono::milliseconds (0));

  /** \brief How many frames were replaced before anybody took them. */
  std::size_t
  dropped () const;

private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Frame> newest_;
  std::exception_ptr error_;
  std::size_t received_ = 0;
  std::size_t dropped_ = 0;
};

} // namespace rgbd_planes
} // namespace pcl
