// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "plane_clouds.h"

#include <pcl/common/point_tests.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace room_corner {

using plane_clouds::Cloud;
using plane_clouds::Result;
using plane_clouds::Scene;
using plane_clouds::segment;
using plane_clouds::Surface;
using synthetic::angleDegrees;
using Segmentation = plane_clouds::Ours;

inline Result
segment (const Cloud::ConstPtr& cloud, unsigned min_inliers = 1000)
{
  Segmentation segmentation;
  segmentation.setMinInliers (min_inliers);
  Result result;
  segment (segmentation, cloud, result);
  return result;
}

/** Every true plane is found once, and nothing else: normals within \a degrees,
 * distances within \a metres, and all but \a lost of the points of each surface with
 * its label. */
inline void
expectPlanes (const Scene& scene,
              const std::vector<Surface>& surfaces,
              const Result& result,
              float degrees,
              float metres,
              double lost)
{
  ASSERT_EQ (result.models.size(), surfaces.size());
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    std::size_t k = 0;
    while (k < result.models.size() &&
           (angleDegrees (result.normal (k), surfaces[s].normal) > degrees ||
            std::abs (result.models[k].values[3] - surfaces[s].d) > metres))
      ++k;
    ASSERT_LT (k, result.models.size()) << "surface " << s << " was not found";
    std::size_t points = 0, labelled = 0;
    for (std::size_t i = 0; i < scene.surface.size(); ++i)
      if (scene.surface[i] == static_cast<int> (s) &&
          pcl::isFinite ((*scene.cloud)[i])) {
        ++points;
        labelled += result.labels[i].label == k;
      }
    EXPECT_GE (static_cast<double> (labelled),
               (1. - lost) * static_cast<double> (points))
        << "surface " << s;
  }
}

} // namespace room_corner
