// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/impl/instantiate.hpp>

// The point types that the library is compiled for: all of PCL's, or the common ones for a
// faster build.
#ifdef PCL_RGBD_PLANES_ONLY_CORE_POINT_TYPES
#define PCL_RGBD_PLANES_XYZ_POINT_TYPES                                                \
  (pcl::PointXYZ) (pcl::PointXYZI) (pcl::PointXYZRGB) (pcl::PointXYZRGBA) (            \
      pcl::PointNormal) (pcl::PointXYZRGBNormal)
#define PCL_RGBD_PLANES_NORMAL_POINT_TYPES                                             \
  (pcl::Normal) (pcl::PointNormal) (pcl::PointXYZRGBNormal)
#else
#define PCL_RGBD_PLANES_XYZ_POINT_TYPES PCL_XYZ_POINT_TYPES
#define PCL_RGBD_PLANES_NORMAL_POINT_TYPES PCL_NORMAL_POINT_TYPES
#endif
