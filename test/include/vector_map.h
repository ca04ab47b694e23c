// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/pcl_config.h>

#include <Eigen/Core>

/** What pcl::Feature of PCL 1.15 asks of points, for those without PCL_ADD_POINT4D. */
#if PCL_VERSION_COMPARE(>, 1, 14, 0)
#define ADD_VECTOR_MAP                                                                 \
  Eigen::Map<const Eigen::Vector3f> getVector3fMap() const                             \
  {                                                                                    \
    return Eigen::Map<const Eigen::Vector3f> (&x);                                     \
  }
#else
#define ADD_VECTOR_MAP
#endif
