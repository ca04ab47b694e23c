// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/tangent_integral_images.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

void
TangentIntegralImages::start (const OrganizedPoints& points,
                              const std::array<float, 3>& viewpoint,
                              float max_depth_change_factor,
                              int max_half_u,
                              int max_half_v)
{
  points_ = points;
  viewpoint_ = viewpoint;
  max_depth_change_factor_ = max_depth_change_factor;
  max_half_v_ = max_half_v;
  appended_ = 0;

  const float area = (2.f * static_cast<float> (max_half_u) + 1.f) *
                     (2.f * static_cast<float> (max_half_v) + 1.f);
  // No component of a tangent exceeds the range, so no window sum exceeds 2^30.
  fixed_point_scale_ = static_cast<float> (1 << 30) / area;

  const std::size_t width = static_cast<std::size_t> (points.width) + 1;
  const std::size_t height = static_cast<std::size_t> (points.height) + 1;
  const std::size_t ring_rows =
      std::min (height, 2 * static_cast<std::size_t> (max_half_v) + 2);
  ring_.resize (ring_rows * width);
  row_pointers_.resize (height);
  for (std::size_t v = 0; v < height; ++v)
    row_pointers_[v] = ring_.data() + v % ring_rows * width;
  std::fill_n (row_pointers_[0], width, Sums{});
  for (auto& row : rows_)
    row.resize (static_cast<std::size_t> (points.width));
  loadRow (0, rows_[1]);
}

void
TangentIntegralImages::advance (int v)
{
  const int end = std::min (v + max_half_v_ + 1, points_.height);
  for (; appended_ < end; ++appended_) {
    if (appended_ + 1 < points_.height)
      loadRow (appended_ + 1, rows_[2]);
    appendRow (appended_);
    std::swap (rows_[0], rows_[1]);
    std::swap (rows_[1], rows_[2]);
  }
}

void
TangentIntegralImages::loadRow (int v, std::vector<RangedPoint>& row) const
{
  const std::size_t begin = static_cast<std::size_t> (v) * row.size();
  for (std::size_t u = 0; u < row.size(); ++u) {
    const float* p = points_[begin + u];
    const float x = p[0] - viewpoint_[0];
    const float y = p[1] - viewpoint_[1];
    const float z = p[2] - viewpoint_[2];
    const float range = std::sqrt (x * x + y * y + z * z);
    const bool measured = isMeasured (p) && std::isfinite (range);
    row[u] = {{{p[0], p[1], p[2]}},
              measured ? range : 0.f,
              2.f * max_depth_change_factor_ * (range + 1.f),
              fixed_point_scale_ / range};
  }
}

void
TangentIntegralImages::addTangent (const RangedPoint& before,
                                   const RangedPoint& at,
                                   const RangedPoint& after,
                                   std::uint32_t* sums) const
{
  const auto neighbour = [&] (const RangedPoint& other) -> const RangedPoint& {
    const bool same = other.range > 0.f && std::abs (other.range - at.range) <= at.gate;
    return same ? other : at;
  };
  const RangedPoint& from = neighbour (before);
  const RangedPoint& to = neighbour (after);
  if (&from == &to)
    return;

  const float x = to.p[0] - from.p[0];
  const float y = to.p[1] - from.p[1];
  const float z = to.p[2] - from.p[2];
  if (!(std::max ({std::abs (x), std::abs (y), std::abs (z)}) <= at.range))
    return;
  const auto fixedPoint = [scale = at.scale] (float value) {
    const float scaled = value * scale;
    return static_cast<std::uint32_t> (
        static_cast<std::int32_t> (scaled + std::copysign (0.5f, scaled)));
  };
  sums[0] += fixedPoint (x);
  sums[1] += fixedPoint (y);
  sums[2] += fixedPoint (z);
  ++sums[3];
}

void
TangentIntegralImages::appendRow (int v)
{
  const Sums* above = row_pointers_[static_cast<std::size_t> (v)];
  Sums* integral = row_pointers_[static_cast<std::size_t> (v) + 1];
  const auto& row = rows_[1];
  const auto& row_above = v > 0 ? rows_[0] : row;
  const auto& row_below = v + 1 < points_.height ? rows_[2] : row;
  const std::size_t last = row.size() - 1;
  integral[0] = Sums{};
  Sums sums{};
  for (std::size_t u = 0; u <= last; ++u) {
    const RangedPoint& at = row[u];
    if (at.range > 0.f) {
      addTangent (row[u > 0 ? u - 1 : u], at, row[u < last ? u + 1 : u], sums.data());
      addTangent (row_above[u], at, row_below[u], sums.data() + 4);
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
      integral[u + 1][i] = above[u + 1][i] + sums[i];
  }
}

} // namespace rgbd_planes
} // namespace pcl
