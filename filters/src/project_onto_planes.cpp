// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/filters/impl/project_onto_planes.hpp>
#include <pcl/impl/instantiate.hpp>

PCL_INSTANTIATE (ProjectOntoPlanes, PCL_XYZ_POINT_TYPES)
