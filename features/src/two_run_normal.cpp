// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/impl/two_run_normal.hpp>
#include <pcl/impl/instantiate.hpp>

PCL_INSTANTIATE_PRODUCT (TwoRunNormalEstimation,
                         (PCL_XYZ_POINT_TYPES)(PCL_NORMAL_POINT_TYPES))
