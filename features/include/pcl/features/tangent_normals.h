// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace rgbd_planes {

struct TangentNormalParameters {
  /** Size of the smoothing area in pixels; where it grows with range, its size at 1 m.
   * 0: 1/40 of the image width, at least 6, which is best for Kinect recordings at
   * full, half and quarter resolution. */
  float smoothing_width = 0.f;
  float smoothing_height = 0.f;
  /** Let the area grow with range^(2/3) up to 8 m, which keeps the angular noise of a
   * structured-light sensor constant. */
  bool depth_dependent_smoothing = true;
  /** Neighbouring pixels whose ranges differ by more than 2 * factor * (range + 1 m)
   * lie on different surfaces: no tangent spans them. */
  float max_depth_change_factor = 0.02f;
  /** No normals where the smoothing area leaves the image, instead of cutting the area.
   */
  bool ignore_border = false;
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
 * section 3).
 *
 * Each pixel has two tangents, from its left to its right neighbour and from its upper
 * to its lower one. They are divided by the range of the pixel, which makes the result
 * independent of the unit, and summed as fixed-point numbers: integral images of
 * integers are exact, for sums wrap around and differences of them do not. Only the
 * rows that the current windows need are kept.
 */
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
  /** Sums of tangents: x, y, z and number of the horizontal ones, then the vertical
   * ones.
   */
  using Sums = std::array<std::uint32_t, 8>;

  struct RangedPoint {
    std::array<float, 3> p;
    float range; // 0: missing
  };

  struct HalfSize {
    int u;
    int v;
  };

  void
  prepareWindows (const OrganizedPoints& points);

  void
  loadRow (const OrganizedPoints& points, int v, std::vector<RangedPoint>& row) const;

  bool
  tangent (const RangedPoint& before,
           const RangedPoint& at,
           const RangedPoint& after,
           std::uint32_t* sums) const;

  void
  appendIntegralRow (int v, int width, int height);

  HalfSize
  halfSize (float range) const;

  Sums*
  integralRow (int v);

  bool
  normalAt (
      const OrganizedPoints& points, int u, int v, float* normal, float& curvature);

  TangentNormalParameters parameters_;
  /** Half-sizes of the smoothing area by range, in bins of bin_size_m. */
  std::vector<HalfSize> half_sizes_;
  HalfSize max_half_size_{0, 0};
  float fixed_point_scale_ = 0.f;
  /** Integral rows v - max_half_size.v ... v + max_half_size.v + 1, in a ring. */
  std::vector<Sums> ring_;
  std::size_t ring_rows_ = 0;
  std::size_t ring_width_ = 0;
  std::array<std::vector<RangedPoint>, 3> rows_;
};

} // namespace rgbd_planes
} // namespace pcl
