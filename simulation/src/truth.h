// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "renderer.h"

namespace pcl {
namespace rgbd_planes {

/** \brief Fills SimulatedFrame::truth and SimulatedFrame::planes. */
void
fillTruth (const Scene& scene,
           const Camera& camera,
           const std::vector<RenderedPixel>& image,
           SimulatedFrame& frame);

} // namespace rgbd_planes
} // namespace pcl
