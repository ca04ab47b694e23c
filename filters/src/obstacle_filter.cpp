// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/impl/instantiate.hpp>
#include <pcl/filters/impl/obstacle_filter.hpp>

PCL_INSTANTIATE (ObstacleFilter, PCL_RGBD_PLANES_XYZ_POINT_TYPES)
