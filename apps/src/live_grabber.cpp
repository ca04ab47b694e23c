// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/apps/app_error.h>
#include <pcl/apps/live_grabber.h>
#include <pcl/exceptions.h>
#include <pcl/pcl_config.h>
#ifdef HAVE_OPENNI2
#include <pcl/io/openni2_grabber.h>
#endif

#include <filesystem>

namespace pcl {
namespace rgbd_planes {

namespace {

bool
isRecording (const std::string& device)
{
  return std::filesystem::path (device).extension() == ".oni";
}

} // namespace

std::optional<std::string>
liveDevice (const std::string& input)
{
  const std::string live = "live:";
  if (input.compare (0, live.size(), live) == 0)
    return input.substr (live.size());
  if (isRecording (input))
    return input;
  return std::nullopt;
}

std::unique_ptr<pcl::Grabber>
openLiveGrabber (const std::string& device)
{
#ifdef HAVE_OPENNI2
  const bool is_file = isRecording (device);
  if (is_file && !std::filesystem::exists (device))
    throw AppError ("live:" + device + ": no such file");
  try {
    return std::make_unique<pcl::io::OpenNI2Grabber> (device);
  }
  catch (const pcl::PCLException&) {
    throw AppError (
        "live:" + device +
        (is_file
             ? ": OpenNI 2 cannot play this file; record it again"
             : ": no such camera is connected, or it is in use or may not be opened "
               "by this user; connect one that OpenNI 2 knows, or give a recording"));
  }
#else
  throw AppError ("live:" + device +
                  ": PCL was built without OpenNI 2; record .pcd files and give their "
                  "folder");
#endif
}

} // namespace rgbd_planes
} // namespace pcl
