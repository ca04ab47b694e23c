// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/filters/impl/obstacle_filter.hpp>
#include <pcl/impl/instantiate.hpp>

PCL_INSTANTIATE (ObstacleFilter, PCL_XYZ_POINT_TYPES)
