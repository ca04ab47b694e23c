// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_source.h>

#include <Eigen/Geometry>
#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The files with the truth about a frame NAME.pcd, as pcl_simulate_rgbd writes them:
 * NAME_truth.json, of the scene, and NAME_truth.pcd, of the pixels. None where the first one is
 * not there. */
std::vector<std::filesystem::path>
truthFiles (const std::filesystem::path& frame);

/** \brief The first three rows of the matrix of a pose. */
nlohmann::ordered_json
poseJson (const Eigen::Affine3f& pose);

/** \brief What NAME_truth.json holds: {"camera_to_base", "planes", "objects"}, exactly. */
std::string
encodeSceneTruth (const SimulatedFrame& frame);

/** \brief Fills in what truthFiles() of \a file, from which the cloud of \a frame is, say. Throws
 * AppError where they are damaged, or of another frame. */
void
readTruth (const std::filesystem::path& file, Frame& frame);

} // namespace rgbd_planes
} // namespace pcl
