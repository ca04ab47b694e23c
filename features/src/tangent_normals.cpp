// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/tangent_normals.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

using Sums = TangentIntegralImages::Sums;
using Vector = std::array<float, 3>;

constexpr float bins_per_metre = 64.f;
constexpr int max_growth_metres = 8;
/** An area whose halves bend by less, in radians, is taken for one surface. */
constexpr float clean_bend = 0.2f;
/** Neighbouring areas lie this many half-sizes away. */
constexpr float window_shift = 0.7f;
/** A point lies on the plane of another area up to this many deviations of depth. */
constexpr float max_sigmas = 2.f;
/** Another area must be better than the point's own by this factor. */
constexpr float better = 0.9f;

float
dot (const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector
cross (const Vector& a, const Vector& b)
{
  return {{a[1] * b[2] - a[2] * b[1],
           a[2] * b[0] - a[0] * b[2],
           a[0] * b[1] - a[1] * b[0]}};
}

/** The sum of the horizontal (\a first = 0) or vertical (4) tangents. */
Vector
tangentSum (const Sums& sums, std::size_t first)
{
  Vector sum;
  for (std::size_t i = 0; i < 3; ++i)
    sum[i] = static_cast<float> (static_cast<std::int32_t> (sums[first + i]));
  return sum;
}

/** By how much the surface bends between the halves of a window, in radians: the change
 * of their mean tangents along the normal. All tangents together have no part along the
 * normal, so that the two halves have opposite ones, and one of them tells. */
float
bend (
    const Sums& all, const Sums& half, std::size_t first, float length, const Vector& n)
{
  const std::uint32_t number = half[first + 3];
  const std::uint32_t other_number = all[first + 3] - number;
  if (number == 0 || other_number == 0)
    return 0.f;
  const float mean_length = length / static_cast<float> (all[first + 3]);
  return dot (tangentSum (half, first), n) *
         (1.f / static_cast<float> (number) + 1.f / static_cast<float> (other_number)) /
         mean_length;
}

Sums
window (const Sums* top, const Sums* bottom, int left, int right)
{
  Sums sums;
  for (std::size_t i = 0; i < sums.size(); ++i)
    sums[i] = bottom[right][i] - bottom[left][i] - top[right][i] + top[left][i];
  return sums;
}

} // namespace

std::size_t
TangentNormals::compute (const OrganizedPoints& points,
                         const TangentNormalParameters& parameters,
                         const NormalOutput& output)
{
  if (points.size() == 0)
    return 0;
  parameters_ = parameters;
  prepareSizes (points);
  integral_images_.start (points,
                          parameters.viewpoint,
                          parameters.max_depth_change_factor,
                          half_sizes_.back().u,
                          half_sizes_.back().v);
  windows_.resize (points.size());
  auto plane = windows_.begin();
  for (int v = 0; v < points.height; ++v) {
    integral_images_.advance (v);
    for (int u = 0; u < points.width; ++u)
      *plane++ = fitWindow (points, u, v);
  }

  std::size_t valid = 0, i = 0;
  for (int v = 0; v < points.height; ++v)
    for (int u = 0; u < points.width; ++u, ++i) {
      const WindowPlane& best =
          parameters.edge_aware ? bestWindow (points, u, v) : windows_[i];
      std::copy (
          best.normal.begin(), best.normal.end(), output.normal + i * output.stride);
      // The smallest eigenvalue over the sum of all (section 3) of a square patch
      // z = k x^2 / 2 whose halves differ by this angle.
      const float squared_bend = windows_[i].squared_bend;
      output.curvature[i * output.stride] =
          squared_bend > 10.f ? 1.f / 3.f : squared_bend / 30.f;
      valid += !std::isnan (best.normal[0]);
    }
  return valid;
}

void
TangentNormals::prepareSizes (const OrganizedPoints& points)
{
  const auto half = [] (float size, int limit) {
    return static_cast<int> (std::min (0.5f * size, static_cast<float> (limit)));
  };
  const float automatic = std::max (static_cast<float> (points.width) / 40.f, 6.f);
  const auto chosen = [automatic] (float size) {
    return size == 0.f ? automatic : size;
  };
  const float width = chosen (parameters_.smoothing_width);
  const float height = chosen (parameters_.smoothing_height);
  const int bins = parameters_.depth_dependent_smoothing
                       ? max_growth_metres * static_cast<int> (bins_per_metre)
                       : 1;
  half_sizes_.clear();
  for (int i = 0; i < bins; ++i) {
    const float range = (static_cast<float> (i) + 0.5f) / bins_per_metre;
    const float growth = bins > 1 ? std::sqrt (range) : 1.f;
    half_sizes_.push_back (
        {half (width * growth, points.width), half (height * growth, points.height)});
  }
}

TangentNormals::HalfSize
TangentNormals::halfSize (float range) const
{
  const float bin =
      std::min (range * bins_per_metre, static_cast<float> (half_sizes_.size() - 1));
  return half_sizes_[static_cast<std::size_t> (bin)];
}

TangentNormals::WindowPlane
TangentNormals::fitWindow (const OrganizedPoints& points, int u, int v) const
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr WindowPlane none{{{nan, nan, nan}}, nan, nan};
  const float* p = points[static_cast<std::size_t> (v) * points.width + u];
  const Vector to_sensor{{parameters_.viewpoint[0] - p[0],
                          parameters_.viewpoint[1] - p[1],
                          parameters_.viewpoint[2] - p[2]}};
  const float range = std::sqrt (dot (to_sensor, to_sensor));
  if (!isMeasured (p) || !std::isfinite (range))
    return none;

  const HalfSize half = halfSize (range);
  const int left = std::max (u - half.u, 0);
  const int right = std::min (u + half.u + 1, points.width);
  const int top = std::max (v - half.v, 0);
  const int bottom = std::min (v + half.v + 1, points.height);
  if (parameters_.ignore_border &&
      (right - left <= 2 * half.u || bottom - top <= 2 * half.v))
    return none;

  const Sums* upper_row = integral_images_.above (top);
  const Sums* lower_row = integral_images_.above (bottom);
  const Sums all = window (upper_row, lower_row, left, right);
  if (all[3] == 0 || all[7] == 0)
    return none;

  const Vector horizontal = tangentSum (all, 0);
  const Vector vertical = tangentSum (all, 4);
  const float horizontal_length = std::sqrt (dot (horizontal, horizontal));
  const float vertical_length = std::sqrt (dot (vertical, vertical));
  Vector n = cross (horizontal, vertical);
  const float length = std::sqrt (dot (n, n));
  // Tangents that are zero or parallel span no surface.
  if (!(length > 1e-4f * horizontal_length * vertical_length))
    return none;
  const float scale = dot (n, to_sensor) < 0.f ? -1.f / length : 1.f / length;
  for (float& component : n)
    component *= scale;

  const Sums right_half = window (upper_row, lower_row, (left + right) / 2, right);
  const Sums lower_half =
      window (integral_images_.above ((top + bottom) / 2), lower_row, left, right);
  const float bend_u = bend (all, right_half, 0, horizontal_length, n);
  const float bend_v = bend (all, lower_half, 4, vertical_length, n);
  return {n, dot (n, {{p[0], p[1], p[2]}}), bend_u * bend_u + bend_v * bend_v};
}

/** Of the area around a point and its eight neighbours, the one on whose plane the point
 * lies and that bends least: the counterpart of the second run of principal component
 * analysis, at the cost of looking at nine planes where the area is not clean. */
const TangentNormals::WindowPlane&
TangentNormals::bestWindow (const OrganizedPoints& points, int u, int v) const
{
  const std::size_t index = static_cast<std::size_t> (v) * points.width + u;
  const WindowPlane& own = windows_[index];
  constexpr float bend_weight = 1.f / (clean_bend * clean_bend);
  if (!(own.squared_bend * bend_weight > 1.f))
    return own;

  const Vector p{{points[index][0], points[index][1], points[index][2]}};
  const Vector ray{{p[0] - parameters_.viewpoint[0],
                    p[1] - parameters_.viewpoint[1],
                    p[2] - parameters_.viewpoint[2]}};
  const float squared_range = dot (ray, ray);
  const float per_sigma = 1.f / parameters_.noise.sigma (squared_range);
  const HalfSize half = halfSize (std::sqrt (squared_range));
  const int shift_u = std::max (static_cast<int> (window_shift * half.u), 1);
  const int shift_v = std::max (static_cast<int> (window_shift * half.v), 1);
  const WindowPlane* best = &own;
  float least = better * own.squared_bend * bend_weight;
  for (const int y : {v - shift_v, v, v + shift_v})
    for (const int x : {u - shift_u, u, u + shift_u}) {
      if (x < 0 || y < 0 || x >= points.width || y >= points.height)
        continue;
      const WindowPlane& other =
          windows_[static_cast<std::size_t> (y) * points.width + x];
      const float bends = other.squared_bend * bend_weight;
      if (!(bends < least))
        continue;
      const float sigmas = (dot (other.normal, p) - other.distance) * per_sigma;
      const float badness = bends + sigmas * sigmas;
      if (badness < least && std::abs (sigmas) <= max_sigmas) {
        least = badness;
        best = &other;
      }
    }
  return *best;
}

} // namespace rgbd_planes
} // namespace pcl
