// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <cmath>
#include <cstddef>

namespace pcl {
namespace rgbd_planes {

/** \brief The points of an organized cloud, read in place.
 *
 * Point (u, v), column u and row v of the image, is the three floats x, y, z at
 * \a xyz + (v * width + u) * stride.
 */
struct OrganizedPoints {
  const float* xyz = nullptr;
  std::size_t stride = 0;
  int width = 0;
  int height = 0;

  std::size_t
  size () const
  {
    return static_cast<std::size_t> (width) * static_cast<std::size_t> (height);
  }

  const float*
  operator[] (std::size_t index) const
  {
    return xyz + index * stride;
  }
};

/** \brief The normals that belong to OrganizedPoints, read in place. Normal i is the three
 * floats at \a normal + i * stride, its curvature is curvature[i * stride]. */
struct OrganizedNormals {
  const float* normal = nullptr;
  const float* curvature = nullptr;
  std::size_t stride = 0;

  const float*
  operator[] (std::size_t index) const
  {
    return normal + index * stride;
  }
};

/** \brief Whether \a p is a measurement: NaN, Inf and (0, 0, 0) mean missing depth. */
inline bool
isMeasured (const float* p)
{
  return std::isfinite (p[0]) && std::isfinite (p[1]) && std::isfinite (p[2]) &&
         (p[0] != 0.f || p[1] != 0.f || p[2] != 0.f);
}

/** \brief The square of the distance of \a point from the origin. */
inline float
squaredRange (const float* point)
{
  return point[0] * point[0] + point[1] * point[1] + point[2] * point[2];
}

/** \brief The square of the length of normals that count: of unit length, to 5 %. */
constexpr float min_normal_square = 0.9f, max_normal_square = 1.1f;

/** \brief Whether \a normal is one that counts. */
inline bool
isUnit (const float* normal)
{
  const float square = squaredRange (normal);
  return square > min_normal_square && square < max_normal_square;
}

} // namespace rgbd_planes
} // namespace pcl
