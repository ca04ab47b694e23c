// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "scene.h"

#include <string>

namespace pcl {
namespace rgbd_planes {

/** \brief Lays out one of sceneNames(); std::invalid_argument for other names. */
Scene
makeScene (const std::string& name, unsigned seed);

} // namespace rgbd_planes
} // namespace pcl
