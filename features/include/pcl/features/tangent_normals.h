// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>
#include <pcl/features/tangent_integral_images.h>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

struct TangentNormalParameters {
  /** Size of the smoothing area in pixels; where it grows with range, its size at 1 m.
   * 0: 1/40 of the image width, at least 6, which is best for Kinect recordings at
   * full, half and quarter resolution. */
  float smoothing_width = 0.f;
  float smoothing_height = 0.f;
  /** Let the area grow with the square root of the range, up to 8 m: as depth gets
   * noisier, but not so much that it reaches across everything. */
  bool depth_dependent_smoothing = true;
  /** Neighbouring pixels whose ranges differ by more than 2 * factor * (range + 1 m)
   * lie on different surfaces: no tangent spans them. */
  float max_depth_change_factor = 0.02f;
  /** No normals where the smoothing area leaves the image, instead of cutting the area.
   */
  bool ignore_border = false;
  /** Let a point whose smoothing area spans an edge or a crease take the plane of a
   * neighbouring area on its own side. */
  bool edge_aware = true;
  /** The number of threads, 1 or more; the result does not depend on it. */
  unsigned int threads = 1;
  /** Tells the sides apart, for edge_aware. */
  DepthNoise noise;
  /** Where the sensor is, in the frame of the points; normals face it. */
  std::array<float, 3> viewpoint{{0.f, 0.f, 0.f}};
};

/** \brief Where normals go: normal i to the three floats at \a normal + i * stride, its
 * curvature to curvature[i * stride]. */
struct NormalOutput {
  float* normal = nullptr;
  float* curvature = nullptr;
  std::size_t stride = 0;
};

/** \brief Normals from tangents averaged with integral images (Holz et al. 2011,
 * section 3), and a choice between the areas around a point. */
class PCL_RGBD_PLANES_EXPORTS TangentNormals {
public:
  /** \brief Writes one normal for every point: of unit length, towards the viewpoint,
   * with the curvature of the surface inside the smoothing area; NaN where the point is
   * missing or no surface is around it.
   * \return the number of normals that are not NaN
   */
  std::size_t
  compute (const OrganizedPoints& points,
           const TangentNormalParameters& parameters,
           const NormalOutput& output);

private:
  struct HalfSize {
    int u;
    int v;
  };

  /** The plane that a smoothing area shows, through the point in its middle. */
  struct WindowPlane {
    std::array<float, 3> normal; // NaN: none
    float distance;              // normal * point
    float squared_bend;          // between the halves of the area, square radians
  };

  void
  prepareSizes (const OrganizedPoints& points);

  HalfSize
  halfSize (float range) const;

  WindowPlane
  fitWindow (const OrganizedPoints& points, int u, int v) const;

  const WindowPlane&
  bestWindow (const OrganizedPoints& points, int u, int v) const;

  TangentNormalParameters parameters_;
  /** Half-sizes of the smoothing area by range, in equal bins. */
  std::vector<HalfSize> half_sizes_;
  TangentIntegralImages integral_images_;
  std::vector<WindowPlane> windows_;
};

} // namespace rgbd_planes
} // namespace pcl
