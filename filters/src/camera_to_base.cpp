// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/filters/impl/camera_to_base.hpp>
#include <pcl/impl/instantiate.hpp>

PCL_INSTANTIATE (CameraToBase, PCL_XYZ_POINT_TYPES)
