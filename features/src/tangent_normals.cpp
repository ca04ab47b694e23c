// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/tangent_normals.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

using Vector = std::array<float, 3>;

constexpr float bins_per_metre = 64.f;
constexpr int max_growth_metres = 8;

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

/** The mean tangent of a sum of four lanes (x, y, z, number); its number must not be 0.
 */
Vector
meanTangent (const std::uint32_t* sums)
{
  const float scale = 1.f / static_cast<float> (sums[3]);
  Vector mean;
  for (std::size_t i = 0; i < 3; ++i)
    mean[i] = static_cast<float> (static_cast<std::int32_t> (sums[i])) * scale;
  return mean;
}

/** By how much the surface bends between two halves of a window, in radians: the change
 * of their mean tangents along the normal. */
float
bend (const std::uint32_t* first,
      const std::uint32_t* second,
      const Vector& tangent,
      const Vector& normal)
{
  if (first[3] == 0 || second[3] == 0)
    return 0.f;
  return (dot (meanTangent (second), normal) - dot (meanTangent (first), normal)) /
         std::sqrt (dot (tangent, tangent));
}

template <typename Sums>
Sums
window (const Sums* top, const Sums* bottom, int left, int right)
{
  Sums sums;
  for (std::size_t i = 0; i < sums.size(); ++i)
    sums[i] = bottom[right][i] - bottom[left][i] - top[right][i] + top[left][i];
  return sums;
}

template <typename Sums>
Sums
add (const Sums& a, const Sums& b)
{
  Sums sums;
  for (std::size_t i = 0; i < sums.size(); ++i)
    sums[i] = a[i] + b[i];
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
  const float automatic = std::max (static_cast<float> (points.width) / 40.f, 6.f);
  for (float* size : {&parameters_.smoothing_width, &parameters_.smoothing_height})
    if (*size == 0.f)
      *size = automatic;
  prepareWindows (points);
  std::fill_n (integralRow (0), ring_width_, Sums{});
  loadRow (points, 0, rows_[1]);

  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  std::size_t valid = 0;
  int appended = 0;
  for (int v = 0; v < points.height; ++v) {
    for (; appended < std::min (v + max_half_size_.v + 1, points.height); ++appended) {
      if (appended + 1 < points.height)
        loadRow (points, appended + 1, rows_[2]);
      appendIntegralRow (appended, points.width, points.height);
      std::swap (rows_[0], rows_[1]);
      std::swap (rows_[1], rows_[2]);
    }
    for (int u = 0; u < points.width; ++u) {
      const std::size_t index = static_cast<std::size_t> (v) * points.width + u;
      float* normal = output.normal + index * output.stride;
      float& curvature = output.curvature[index * output.stride];
      if (normalAt (points, u, v, normal, curvature))
        ++valid;
      else
        normal[0] = normal[1] = normal[2] = curvature = nan;
    }
  }
  return valid;
}

void
TangentNormals::prepareWindows (const OrganizedPoints& points)
{
  const auto half = [] (float size, int limit) {
    return static_cast<int> (std::min (0.5f * size, static_cast<float> (limit)));
  };
  const int bins = parameters_.depth_dependent_smoothing
                       ? max_growth_metres * static_cast<int> (bins_per_metre)
                       : 1;
  half_sizes_.resize (static_cast<std::size_t> (bins));
  for (int i = 0; i < bins; ++i) {
    const float range = (static_cast<float> (i) + 0.5f) / bins_per_metre;
    const float growth = bins > 1 ? std::cbrt (range * range) : 1.f;
    half_sizes_[static_cast<std::size_t> (i)] = {
        half (parameters_.smoothing_width * growth, points.width),
        half (parameters_.smoothing_height * growth, points.height)};
  }
  max_half_size_ = half_sizes_.back();

  const float area = (2.f * static_cast<float> (max_half_size_.u) + 1.f) *
                     (2.f * static_cast<float> (max_half_size_.v) + 1.f);
  // No component of a tangent exceeds the range, so no window sum exceeds 2^30.
  fixed_point_scale_ = static_cast<float> (1 << 30) / area;

  const std::size_t height = static_cast<std::size_t> (points.height) + 1;
  ring_rows_ = std::min (height, 2 * static_cast<std::size_t> (max_half_size_.v) + 2);
  ring_width_ = static_cast<std::size_t> (points.width) + 1;
  ring_.resize (ring_rows_ * ring_width_);
  for (auto& row : rows_)
    row.resize (static_cast<std::size_t> (points.width));
}

void
TangentNormals::loadRow (const OrganizedPoints& points,
                         int v,
                         std::vector<RangedPoint>& row) const
{
  const std::size_t begin = static_cast<std::size_t> (v) * points.width;
  for (std::size_t u = 0; u < row.size(); ++u) {
    const float* p = points[begin + u];
    Vector ray;
    for (std::size_t i = 0; i < 3; ++i)
      ray[i] = p[i] - parameters_.viewpoint[i];
    const float range = std::sqrt (dot (ray, ray));
    const bool measured = isMeasured (p) && std::isfinite (range);
    row[u] = {{{p[0], p[1], p[2]}}, measured ? range : 0.f};
  }
}

bool
TangentNormals::tangent (const RangedPoint& before,
                         const RangedPoint& at,
                         const RangedPoint& after,
                         std::uint32_t* sums) const
{
  const float gate = 2.f * parameters_.max_depth_change_factor * (at.range + 1.f);
  const auto neighbour = [&] (const RangedPoint& other) -> const RangedPoint& {
    const bool same = other.range > 0.f && std::abs (other.range - at.range) <= gate;
    return same ? other : at;
  };
  const RangedPoint& from = neighbour (before);
  const RangedPoint& to = neighbour (after);
  if (&from == &to)
    return false;

  Vector t;
  for (std::size_t i = 0; i < 3; ++i) {
    t[i] = to.p[i] - from.p[i];
    if (!(std::abs (t[i]) <= at.range))
      return false;
  }
  const float scale = fixed_point_scale_ / at.range;
  for (std::size_t i = 0; i < 3; ++i) {
    const float value = t[i] * scale;
    sums[i] += static_cast<std::uint32_t> (
        static_cast<std::int32_t> (value + std::copysign (0.5f, value)));
  }
  ++sums[3];
  return true;
}

void
TangentNormals::appendIntegralRow (int v, int width, int height)
{
  const Sums* above = integralRow (v);
  Sums* integral = integralRow (v + 1);
  integral[0] = Sums{};
  Sums row{};
  for (int u = 0; u < width; ++u) {
    const auto i = static_cast<std::size_t> (u);
    const RangedPoint& at = rows_[1][i];
    if (at.range > 0.f) {
      tangent (rows_[1][u > 0 ? i - 1 : i],
               at,
               rows_[1][u + 1 < width ? i + 1 : i],
               row.data());
      tangent (v > 0 ? rows_[0][i] : at,
               at,
               v + 1 < height ? rows_[2][i] : at,
               row.data() + 4);
    }
    integral[u + 1] = add (above[u + 1], row);
  }
}

TangentNormals::HalfSize
TangentNormals::halfSize (float range) const
{
  const float bin =
      std::min (range * bins_per_metre, static_cast<float> (half_sizes_.size() - 1));
  return half_sizes_[static_cast<std::size_t> (bin)];
}

TangentNormals::Sums*
TangentNormals::integralRow (int v)
{
  return ring_.data() + static_cast<std::size_t> (v) % ring_rows_ * ring_width_;
}

bool
TangentNormals::normalAt (
    const OrganizedPoints& points, int u, int v, float* normal, float& curvature)
{
  const float* p = points[static_cast<std::size_t> (v) * points.width + u];
  if (!isMeasured (p))
    return false;
  const Vector to_sensor{{parameters_.viewpoint[0] - p[0],
                          parameters_.viewpoint[1] - p[1],
                          parameters_.viewpoint[2] - p[2]}};
  const float range = std::sqrt (dot (to_sensor, to_sensor));
  if (!std::isfinite (range))
    return false;

  const HalfSize half = halfSize (range);
  const int left = std::max (u - half.u, 0),
            right = std::min (u + half.u + 1, points.width);
  const int top = std::max (v - half.v, 0),
            bottom = std::min (v + half.v + 1, points.height);
  if (parameters_.ignore_border &&
      (right - left <= 2 * half.u || bottom - top <= 2 * half.v))
    return false;

  const int middle_u = (left + right) / 2, middle_v = (top + bottom) / 2;
  const Sums* top_row = integralRow (top);
  const Sums* middle_row = integralRow (middle_v);
  const Sums* bottom_row = integralRow (bottom);
  const Sums upper_left = window (top_row, middle_row, left, middle_u);
  const Sums upper_right = window (top_row, middle_row, middle_u, right);
  const Sums lower_left = window (middle_row, bottom_row, left, middle_u);
  const Sums lower_right = window (middle_row, bottom_row, middle_u, right);
  const Sums upper = add (upper_left, upper_right);
  const Sums lower = add (lower_left, lower_right);
  const Sums all = add (upper, lower);
  if (all[3] == 0 || all[7] == 0)
    return false;

  const Vector horizontal = meanTangent (all.data());
  const Vector vertical = meanTangent (all.data() + 4);
  Vector n = cross (horizontal, vertical);
  const float length = std::sqrt (dot (n, n));
  // Tangents that are zero or parallel span no surface.
  if (!(length >
        1e-4f * std::sqrt (dot (horizontal, horizontal) * dot (vertical, vertical))))
    return false;
  const float scale = dot (n, to_sensor) < 0.f ? -1.f / length : 1.f / length;
  for (std::size_t i = 0; i < 3; ++i)
    normal[i] = n[i] *= scale;

  const Sums lefts = add (upper_left, lower_left);
  const Sums rights = add (upper_right, lower_right);
  const float bend_u = bend (lefts.data(), rights.data(), horizontal, n);
  const float bend_v = bend (upper.data() + 4, lower.data() + 4, vertical, n);
  // The smallest eigenvalue over the sum of all (section 3) of a square patch z = k x^2
  // / 2 whose halves differ by this angle.
  curvature = std::min ((bend_u * bend_u + bend_v * bend_v) / 30.f, 1.f / 3.f);
  return true;
}

} // namespace rgbd_planes
} // namespace pcl
