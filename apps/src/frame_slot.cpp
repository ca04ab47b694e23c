// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/frame_grabber.h>
#include <pcl/apps/frame_slot.h>
#include <pcl/features/impl/organized_view.h>

#include <limits>
#include <utility>

namespace pcl {
namespace rgbd_planes {

namespace {

template <typename PointT>
using CloudSignal = void (const typename pcl::PointCloud<PointT>::ConstPtr&);

void
copyColour (const pcl::PointXYZRGB& from, pcl::PointXYZRGB& to)
{
  to.rgba = from.rgba;
}

void
copyColour (const pcl::PointXYZ&, pcl::PointXYZRGB&)
{}

/** A frame as FrameSource gives them: missing points are NaN, colour may be black. */
template <typename PointT>
Frame
toFrame (const pcl::PointCloud<PointT>& cloud)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  Frame frame;
  frame.cloud =
      pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>> (cloud.width, cloud.height);
  frame.cloud->is_dense = false;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    auto& point = (*frame.cloud)[i];
    copyColour (cloud[i], point);
    point.getVector3fMap().setConstant (nan);
    if (isMeasured (cloud[i].data))
      point.getVector3fMap() = cloud[i].getVector3fMap();
  }
  return frame;
}

template <typename PointT>
bool
connectClouds (pcl::Grabber& grabber, FrameSlot& slot)
{
  if (!grabber.providesCallback<CloudSignal<PointT>>())
    return false;
  const std::function<CloudSignal<PointT>> put = [&slot] (const auto& cloud) {
    slot.put (toFrame (*cloud));
  };
  grabber.registerCallback (put);
  return true;
}

} // namespace

void
FrameSlot::connect (pcl::Grabber& grabber)
{
  if (grabber.providesCallback<FrameGrabber::FrameSignal>()) {
    grabber.registerCallback (std::function<FrameGrabber::FrameSignal> (
        [this] (const Frame& frame) { put (frame); }));
    grabber.registerCallback (std::function<FrameGrabber::ErrorSignal> (
        [this] (const std::exception_ptr& error) { fail (error); }));
    return;
  }
  if (!connectClouds<pcl::PointXYZRGB> (grabber, *this) &&
      !connectClouds<pcl::PointXYZ> (grabber, *this))
    throw AppError (grabber.getName() +
                    " gives no clouds of points; is it a depth camera?");
}

void
FrameSlot::put (Frame frame)
{
  const std::lock_guard<std::mutex> lock (mutex_);
  if (newest_)
    ++dropped_;
  ++received_;
  if (frame.name.empty())
    frame.name = std::to_string (received_);
  newest_ = std::move (frame);
  changed_.notify_one();
}

void
FrameSlot::fail (std::exception_ptr error)
{
  const std::lock_guard<std::mutex> lock (mutex_);
  error_ = std::move (error);
  changed_.notify_one();
}

std::optional<Frame>
FrameSlot::take (std::chrono::milliseconds patience)
{
  std::unique_lock<std::mutex> lock (mutex_);
  changed_.wait_for (lock, patience, [this] { return newest_ || error_; });
  if (newest_)
    return std::exchange (newest_, std::nullopt);
  if (error_)
    std::rethrow_exception (std::exchange (error_, nullptr));
  return std::nullopt;
}

std::size_t
FrameSlot::dropped() const
{
  const std::lock_guard<std::mutex> lock (mutex_);
  return dropped_;
}

} // namespace rgbd_planes
} // namespace pcl
