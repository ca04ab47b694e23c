// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/io/grabber.h>

#include <memory>
#include <optional>
#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief The device of an input "live:DEVICE" or "FILE.oni"; nothing for other inputs. */
std::optional<std::string>
liveDevice (const std::string& input);

/** \brief A camera that OpenNI 2 knows: Primesense, Asus Xtion, Kinect v1.
 * \param[in] device empty for any, \c #2 for the second one, its URI, or an .oni file that is
 * played. AppError where it cannot be opened, or where PCL was built without OpenNI 2.
 */
std::unique_ptr<pcl::Grabber>
openLiveGrabber (const std::string& device);

} // namespace rgbd_planes
} // namespace pcl
