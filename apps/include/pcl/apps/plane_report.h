// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_segmenter.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief Prints the planes of a frame, one a line. */
void
printPlanes (std::ostream& out, const FrameSummary& frame);

/** \brief The coefficients, number of points, rms distance and class of a plane, in a line. */
std::string
planeText (const PlaneSummary& plane);

/** \brief The time of each stage that ran, one a line, milliseconds. */
std::string
stageTimesText (const StageTimes& times);

/** \brief Prints minimum, median and maximum over the frames of the time of each stage.
 */
void
printStageTimes (std::ostream& out, const std::vector<FrameSummary>& frames);

/** \brief planes.csv: a header and a line for each plane of each frame. Distances in
 * metres. */
std::string
planesCsv (const std::vector<FrameSummary>& frames);

/** \brief Prints the objects of a frame, one a line. */
void
printObjects (std::ostream& out, const FrameSummary& frame);

/** \brief objects.csv: a header and a line for each object of each frame; metres, in the camera
 * frame. The box is given by its centre, its sides and the directions of the first and of the
 * last side, which points up. */
std::string
objectsCsv (const std::vector<FrameSummary>& frames);

/** \brief result.json: the input with what was set, the stage times, and the planes,
 * objects, obstacles and virtual scan of each frame. Units are in the names. */
std::string
resultJson (const InputOptions& options, const std::vector<FrameSummary>& frames);

} // namespace rgbd_planes
} // namespace pcl
