// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/apps/frame_source.h>
#include <pcl/apps/plane_evaluation.h>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace pcl {
namespace rgbd_planes {

/** \brief The true planes of every step-th pixel: those of a simulated frame, or those of
 * recordings with PointLabels::Kind::planes, fitted to all measured points with their
 * label. Nothing for other frames. */
std::optional<PlaneSet>
truePlanes (const Frame& frame, std::uint32_t step);

/** \brief How many of \a points points a plane needs to count: minPlanePoints (points), but
 * 300 of 500 x 500 where the planes are labelled, for SynPEB has many small ones. */
unsigned
minPlanePoints (const Frame& frame, std::size_t points);

} // namespace rgbd_planes
} // namespace pcl
