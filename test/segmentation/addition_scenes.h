// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "plane_clouds.h"

#include <set>
#include <vector>

// For scenes on which it is known what comes of leaving out one addition.

namespace addition_scenes {

using pcl::rgbd_planes::PlaneAdditions;
using pcl::rgbd_planes::PlaneExtraction;
using pcl::rgbd_planes::unlabelled;
using plane_clouds::extract;
using plane_clouds::render;
using plane_clouds::Scene;
using plane_clouds::Surface;
using plane_clouds::trueNormals;

inline PlaneExtraction
extract (const std::vector<Surface>& surfaces, const PlaneAdditions& additions)
{
  const Scene scene = render (surfaces);
  return extract (*scene.cloud, *trueNormals (scene, surfaces), additions);
}

/** The surface through (0, 0, depth) that faces the camera, from column u0 to u1. */
inline Surface
strip (float depth, int u0, int u1)
{
  return {{0.f, 0.f, -1.f}, depth, [=] (int u, int) { return u >= u0 && u < u1; }};
}

/** The labels in columns u0 to u1. */
inline std::set<std::uint32_t>
labelsIn (const PlaneExtraction& extraction, int u0, int u1)
{
  std::set<std::uint32_t> labels;
  for (std::size_t i = 0; i < extraction.labels().size(); ++i)
    if (i % 640 >= static_cast<std::size_t> (u0) &&
        i % 640 < static_cast<std::size_t> (u1))
      labels.insert (extraction.labels()[i]);
  return labels;
}

using Labels = std::set<std::uint32_t>;

} // namespace addition_scenes
