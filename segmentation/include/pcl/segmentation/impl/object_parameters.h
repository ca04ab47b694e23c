// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>

namespace pcl {
namespace rgbd_planes {

/** \brief What SupportedObjectExtraction looks for; lengths in metres, angles in radians. */
struct ObjectParameters {
  /** Largest angle between the normal of a supporting plane and the vertical. */
  float horizontal_tolerance = 0.26f;
  /** Heights of supporting planes in the base frame. */
  float min_plane_height = 0.f;
  float max_plane_height = 1.2f;
  /** How high above its plane an object may reach. */
  float max_object_height = 0.3f;
  /** Lower things are noise, and so is what rises by less than 3 standard deviations. */
  float min_object_height = 0.01f;
  /** How far outside of the hull of its plane a thing may lie. */
  float hull_tolerance = 0.03f;
  /** How much further up to three quarters of a thing may reach. */
  float max_overhang = 0.2f;
  /** Neighbouring points that are further apart than this many standard deviations of depth,
   * plus what the width of a pixel explains, belong to two objects. */
  float cluster_tolerance = 1.f;
  unsigned min_points = 50;
  /** Graspable objects have a smallest side in this range. */
  float min_graspable_side = 0.01f;
  float max_graspable_side = 0.1f;
  bool split_at_concave_edges = false;
  DepthNoise noise = DepthNoise::kinectV1();
};

} // namespace rgbd_planes
} // namespace pcl
