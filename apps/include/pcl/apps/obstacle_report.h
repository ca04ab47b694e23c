// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_segmenter.h>

#include <nlohmann/json_fwd.hpp>

#include <iosfwd>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Prints the obstacles of a frame, one a line. */
void
printObstacles (std::ostream& out, const FrameSummary& frame);

/** \brief obstacles.csv: a header and a line for each obstacle of each frame, by increasing
 * distance; metres and radians, in the base frame. */
std::string
obstaclesCsv (const std::vector<FrameSummary>& frames);

/** \brief FRAME_scan.csv: a header and a line for each direction of the virtual scan;
 * radians from the x axis of the base frame, counterclockwise, and metres, "inf" where no
 * obstacle is seen. */
std::string
scanCsv (const VirtualScan& scan);

/** \brief {"pose", "floor_found", "camera_to_base", "obstacles", "scan"}; null is unknown, and in
 * the ranges of the scan infinite. */
nlohmann::ordered_json
obstaclesJson (const FrameSummary& frame);

} // namespace rgbd_planes
} // namespace pcl
