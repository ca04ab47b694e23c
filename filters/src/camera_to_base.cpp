// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/impl/instantiate.hpp>
#include <pcl/filters/impl/camera_to_base.hpp>

PCL_INSTANTIATE (CameraToBase, PCL_RGBD_PLANES_XYZ_POINT_TYPES (pcl::Normal))
