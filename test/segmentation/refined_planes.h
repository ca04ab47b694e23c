// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "plane_clouds.h"

#include <vector>

namespace refined_planes {

using plane_clouds::Ours;
using plane_clouds::Scene;
using plane_clouds::Surface;
using plane_clouds::trueNormals;

/** What segmentAndRefine gives. */
struct Refined {
  Ours::Regions regions;
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers, label_indices, boundaries;
  Ours::PointCloudLPtr labels;
};

inline void
refine (Ours& segmentation, Refined& refined)
{
  segmentation.segmentAndRefine (refined.regions,
                                 refined.models,
                                 refined.inliers,
                                 refined.labels,
                                 refined.label_indices,
                                 refined.boundaries);
}

/** Planes of \a surfaces, with true normals. */
inline Refined
refine (const Scene& scene,
        const std::vector<Surface>& surfaces,
        Ours segmentation = {})
{
  segmentation.setInputCloud (scene.cloud);
  segmentation.setInputNormals (trueNormals (scene, surfaces));
  Refined refined;
  refine (segmentation, refined);
  return refined;
}

} // namespace refined_planes
