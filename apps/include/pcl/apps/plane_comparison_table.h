// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/plane_comparison.h>

#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The table for people; a second one follows where there are figures of labelled
 * objects, curved surfaces or right angles, a third one where the correction was evaluated. */
std::string
planeComparisonTable (const std::vector<PlaneResult>& results);

/** \brief {"results": [{"method", "resolution", "ms_median", "ms_worst", "planes_truth",
 * ...}]}; figures that the frames do not tell are null. */
std::string
planeComparisonJson (const std::vector<PlaneResult>& results);

} // namespace rgbd_planes
} // namespace pcl
