// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

namespace pcl {
namespace rgbd_planes {

/** \brief The grids that collect normals (Holz et al. 2011, section 4.1): cubes in the space of
 * their components, or cells of about the same size on the unit sphere, between circles of
 * latitude theta and meridians phi. */
enum class NormalSpaceGrid { voxels, spherical };

} // namespace rgbd_planes
} // namespace pcl
