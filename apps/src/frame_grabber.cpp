// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/frame_grabber.h>

#include <chrono>

namespace pcl {
namespace rgbd_planes {

FrameGrabber::FrameGrabber (const InputOptions& options, double rate, bool loop)
: source_ (options)
, rate_ (rate)
, loop_ (loop)
, frame_signal_ (createSignal<FrameSignal>())
, error_signal_ (createSignal<ErrorSignal>())
{}

FrameGrabber::~FrameGrabber() noexcept { stop(); }

void
FrameGrabber::start()
{
  if (running_)
    return;
  stop();
  if (next_ == source_.size())
    next_ = 0;
  running_ = true;
  thread_ = std::thread ([this] { play(); });
}

void
FrameGrabber::stop()
{
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    running_ = false;
  }
  stopped_.notify_all();
  if (thread_.joinable())
    thread_.join();
}

void
FrameGrabber::trigger()
{
  if (running_)
    return;
  if (loop_ && next_ == source_.size())
    next_ = 0;
  if (next_ < source_.size())
    deliverNext();
}

float
FrameGrabber::getFramesPerSecond() const
{
  const std::size_t last = source_.size() - 1;
  const double duration = time (last);
  return static_cast<float> (duration > 0. ? static_cast<double> (last) / duration
                                           : rate_);
}

double
FrameGrabber::time (std::size_t frame) const
{
  const auto recorded = source_.time (frame);
  return recorded ? *recorded - *source_.time (0) : static_cast<double> (frame) / rate_;
}

void
FrameGrabber::play()
{
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;
  double from = time (next_);
  for (auto begin = Clock::now(); running_;) {
    const auto due = begin + std::chrono::duration_cast<Clock::duration> (
                                 Seconds (time (next_) - from));
    {
      std::unique_lock<std::mutex> lock (mutex_);
      if (stopped_.wait_until (lock, due, [this] { return !running_; }))
        return;
    }
    deliverNext();
    if (next_ < source_.size())
      continue;
    if (!loop_)
      running_ = false;
    else {
      next_ = 0;
      from = 0.;
      begin = due + std::chrono::duration_cast<Clock::duration> (
                        Seconds (1. / getFramesPerSecond()));
    }
  }
}

void
FrameGrabber::deliverNext()
{
  try {
    const Frame frame = source_.read (next_);
    ++next_;
    (*frame_signal_) (frame);
  }
  catch (...) {
    running_ = false;
    (*error_signal_) (std::current_exception());
  }
}

} // namespace rgbd_planes
} // namespace pcl
