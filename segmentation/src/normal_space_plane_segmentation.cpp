// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/impl/instantiate.hpp>
#include <pcl/segmentation/impl/normal_space_plane_segmentation.hpp>

PCL_INSTANTIATE_PRODUCT (
    NormalSpacePlaneSegmentation,
    (PCL_RGBD_PLANES_XYZ_POINT_TYPES)(PCL_RGBD_PLANES_NORMAL_POINT_TYPES)((pcl::Label)))
