// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_source.h>
#include <pcl/io/grabber.h>

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

namespace pcl {
namespace rgbd_planes {

/** \brief Plays the frames of a source as a camera would give them: at the times they were
 * recorded, from a thread of its own, whether or not anybody keeps up with them. */
class FrameGrabber : public pcl::Grabber {
public:
  using FrameSignal = void (const Frame&);
  /** An error while a frame is read; the grabber then stops. */
  using ErrorSignal = void (const std::exception_ptr&);

  /** \param[in] rate frames per second where the source does not know its times
   * \param[in] loop start again at the end
   */
  FrameGrabber (const InputOptions& options, double rate, bool loop);

  ~FrameGrabber() noexcept override;

  const FrameSource&
  source () const
  {
    return source_;
  }

  /** \brief Goes on with the next frame; at the end, with the first one. */
  void
  start () override;

  /** \brief Returns when the last frame is delivered. */
  void
  stop () override;

  /** \brief Delivers the next frame now, on the calling thread; nothing at the end, but for
   * a loop, and nothing while running. */
  void
  trigger ();

  std::string
  getName () const override
  {
    return "FrameGrabber";
  }

  bool
  isRunning () const override
  {
    return running_;
  }

  float
  getFramesPerSecond () const override;

private:
  /** \brief When to show a frame; seconds from the first one. */
  double
  time (std::size_t frame) const;

  void
  play ();

  void
  deliverNext ();

  FrameSource source_;
  double rate_;
  bool loop_;
  std::size_t next_ = 0;
  boost::signals2::signal<FrameSignal>* frame_signal_;
  boost::signals2::signal<ErrorSignal>* error_signal_;
  std::atomic<bool> running_{false};
  std::mutex mutex_;
  std::condition_variable stopped_;
  std::thread thread_;
};

} // namespace rgbd_planes
} // namespace pcl
