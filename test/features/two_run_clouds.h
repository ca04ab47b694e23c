// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "synthetic_clouds.h"

#include <pcl/common/point_tests.h>
#include <pcl/features/two_run_normal.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace two_run {

using synthetic::Cloud;
using Normals = pcl::PointCloud<pcl::Normal>;
using Estimation = pcl::TwoRunNormalEstimation<pcl::PointXYZ, pcl::Normal>;

/** Two walls that meet at a right angle 1 m away. */
inline std::vector<synthetic::Surface>
twoWalls ()
{
  return {synthetic::tiltedPlane (1.f, 5.f, 45.f),
          synthetic::tiltedPlane (1.f, 5.f, -45.f)};
}

/** The walls with noise and with holes: NaN, Inf and (0, 0, 0). */
inline Cloud::Ptr
makeHoles ()
{
  const Cloud::Ptr cloud =
      synthetic::render (twoWalls(), 160, 120, [] (float) { return 0.001f; }).cloud;
  for (std::size_t i = 0; i < cloud->size(); i += 7)
    (*cloud)[i].getVector3fMap().setConstant (synthetic::nan);
  for (std::size_t i = 3; i < cloud->size(); i += 11)
    (*cloud)[i].getVector3fMap().setZero();
  (*cloud)[5].x = std::numeric_limits<float>::infinity();
  return cloud;
}

inline bool
isHole (const pcl::PointXYZ& p)
{
  return !pcl::isFinite (p) || p.getVector3fMap().isZero (0.f);
}

inline Normals
compute (const Cloud::ConstPtr& cloud)
{
  Estimation estimation;
  estimation.setInputCloud (cloud);
  Normals normals;
  estimation.compute (normals);
  return normals;
}

inline bool
sameBits (const Normals& a, const Normals& b)
{
  return a.size() == b.size() && !a.empty() &&
         std::memcmp (&a[0], &b[0], a.size() * sizeof (pcl::Normal)) == 0;
}

} // namespace two_run
