// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Whether the name of \a file ends in \a extension, as .pcd, in small or large letters. */
bool
hasExtension (const std::filesystem::path& file, const std::string& extension);

/** \brief The files of a folder for which hasExtension() holds, in the natural order of their
 * names (2.png before 10.png), without hidden ones and without those that our applications write
 * beside a frame: NAME_truth.pcd and NAME_view.pcd. */
std::vector<std::filesystem::path>
listFrames (const std::filesystem::path& folder, const std::string& extension);

} // namespace rgbd_planes
} // namespace pcl
