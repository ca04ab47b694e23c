// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "synthetic_clouds.h"

#include <pcl/common/point_tests.h>

#include <algorithm>
#include <cstring>
#include <limits>

/** Clouds to estimate normals of, and ways to compare normals. */
namespace normal_clouds {

using synthetic::Cloud;
using Normals = pcl::PointCloud<pcl::Normal>;

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

inline bool
sameBits (const pcl::Normal& a, const pcl::Normal& b)
{
  return std::memcmp (a.data_n, b.data_n, 3 * sizeof (float)) == 0 &&
         std::memcmp (&a.curvature, &b.curvature, sizeof (float)) == 0;
}

inline bool
sameBits (const Normals& a, const Normals& b)
{
  return a.size() == b.size() && !a.empty() &&
         std::equal (a.begin(),
                     a.end(),
                     b.begin(),
                     [] (const pcl::Normal& left, const pcl::Normal& right) {
                       return sameBits (left, right);
                     });
}

template <typename Estimation>
Normals
estimate (Estimation& estimation, const Cloud::ConstPtr& cloud)
{
  Normals normals;
  estimation.setInputCloud (cloud);
  estimation.compute (normals);
  return normals;
}

/** With the settings that the class has by default. */
template <typename Estimation>
Normals
estimate (const Cloud::ConstPtr& cloud)
{
  Estimation estimation;
  return estimate (estimation, cloud);
}

} // namespace normal_clouds
