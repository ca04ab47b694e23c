// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/depth_noise.h>
#include <pcl/features/impl/organized_view.h>
#include <pcl/features/impl/tangent_row_pipeline.h>
#include <pcl/features/rgbd_planes_exports.h>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl {
namespace rgbd_planes {

/** \brief The settings of TangentNormals. */
struct TangentNormalParameters {
  /** Size of the smoothing area in pixels. 0: 3/160 of the longer side of the image, at
   * least 4, which is best for Kinect recordings at full, half and quarter resolution. */
  float smoothing_width = 0.f;
  float smoothing_height = 0.f;
  /** Let the area grow with the square root of the range, from its size at 1 m to 2.7 times
   * that at 8 m: as depth gets noisier, but not so much that it reaches across everything.
   */
  bool depth_dependent_smoothing = false;
  /** Compute several sizes of the area, from the given one to 2.7 times that, and choose
   * the most likely normal for each point: one of an area that shows one surface, and a
   * large one if that makes no difference. Instead of depth-dependent smoothing. */
  bool scale_selection = false;
  /** Neighbouring pixels whose ranges differ by more than 2 * factor * (range + 1 m)
   * lie on different surfaces: no tangent spans them. Nor if they differ by more than the
   * noise and the slant of a surface explain. */
  float max_depth_change_factor = 0.02f;
  DepthNoise noise = DepthNoise::kinectV1();
  /** No normals where the smoothing area leaves the image, instead of cutting the area.
   */
  bool ignore_border = false;
  /** Average the planes around each point on which it lies. */
  bool edge_aware = true;
  /** The number of threads, 1 or more; the result does not depend on it. */
  unsigned int threads = 1;
  /** Where the sensor is, in the frame of the points; normals face it. */
  std::array<float, 3> sensor_origin{{0.f, 0.f, 0.f}};
};

/** \brief Where normals go: normal i to the three floats at \a normal + i * stride, its
 * curvature to curvature[i * stride]. */
struct NormalOutput {
  float* normal = nullptr;
  float* curvature = nullptr;
  std::size_t stride = 0;
  /** Whether normals are eight floats each, as pcl::Normal: three of the normal, one that may
   * be set to 0, the curvature, and three that may be set to 0. */
  bool padded = false;
};

/** \brief Normals from tangents averaged with integral images (Holz et al. 2011,
 * section 3), and means of the planes around each point on which it lies: the steps are
 * those of IntegralImageTangentNormalEstimation. */
class PCL_RGBD_PLANES_EXPORTS TangentNormals {
public:
  /** \brief Writes one normal for every point: of unit length, towards the sensor,
   * with the curvature of the surface inside the smoothing area; NaN where the point is
   * missing or no surface is around it.
   * \return the number of normals that are not NaN
   */
  std::size_t
  compute (const OrganizedPoints& points,
           const TangentNormalParameters& parameters,
           const NormalOutput& output);

private:
  /** One for each thread. */
  std::vector<TangentRowPipeline> pipelines_;
};

} // namespace rgbd_planes
} // namespace pcl
