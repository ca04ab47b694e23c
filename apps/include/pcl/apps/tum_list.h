// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <filesystem>
#include <utility>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The depth.txt of a TUM RGB-D recording. */
struct TumList {
  /** When each depth image was taken, seconds, and its file; at least one. */
  std::vector<std::pair<double, std::filesystem::path>> images;
  /** Whether the recording is one of the third camera. */
  bool freiburg3 = false;
};

/** \brief Reads a depth.txt, whose images are beside or below it. AppError where it is not
 * as it should be. */
TumList
readTumList (const std::filesystem::path& list);

/** \brief The files of a TUM RGB-D folder that are not about depth, as far as they are known. */
std::vector<std::filesystem::path>
otherTumFiles (const std::filesystem::path& folder);

} // namespace rgbd_planes
} // namespace pcl
