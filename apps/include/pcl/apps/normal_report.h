// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/normal_comparison.h>

#include <string>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The table for people. */
std::string
normalTable (const std::vector<NormalResult>& results);

/** \brief {"results": [{"method", "resolution", "ms_median", "mean_deg", "median_deg",
 * "over_25_percent", "coverage_percent", "reference", "interior", "edges",
 * "tangent_there", "tangent_there_edges"}, ...]}; the last four hold four figures as in
 * NormalResult, null where they need true normals and there are none. */
std::string
normalTableJson (const std::vector<NormalResult>& results);

} // namespace rgbd_planes
} // namespace pcl
