// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include <pcl/features/impl/organized_view.h>
#include <pcl/features/rgbd_planes_exports.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace pcl {
namespace rgbd_planes {

// The lines of an image, rows or columns, with steps as nextPixel() takes them.

constexpr std::uint32_t no_pixel = std::numeric_limits<std::uint32_t>::max();

/** \brief The pixel next to \a i, \a step further along its row (1 or -1) or column (the width of
 * the image or less that); \a i itself at the border of the image. */
inline std::uint32_t
nextPixel (const OrganizedPoints& points, std::uint32_t i, std::ptrdiff_t step)
{
  const auto width = static_cast<std::uint32_t> (points.width);
  const bool has_next = step == points.width    ? i + width < points.size()
                        : step == -points.width ? i >= width
                        : step > 0              ? i % width + 1 < width
                                                : i % width > 0;
  return has_next ? static_cast<std::uint32_t> (i + step) : i;
}

/** \brief From pixel \a i to the one beside it whose ray points highest.
 * \param[in] normal of a level plane, a unit vector that points up
 */
PCL_RGBD_PLANES_EXPORTS std::ptrdiff_t
stepUpwards (const OrganizedPoints& points,
             const Eigen::Vector3f& normal,
             std::uint32_t i);

inline bool
alongRow (std::ptrdiff_t step)
{
  return step == 1 || step == -1;
}

/** The sine of the angle between the ray to a point and level planes. */
inline float
elevationOf (const float* point, const Eigen::Vector3f& normal)
{
  const Eigen::Map<const Eigen::Vector3f> p (point);
  return normal.dot (p) / p.norm();
}

struct MeasuredPixel {
  std::uint32_t pixel;
  std::size_t steps; // to it
};

/** The next measured pixel on the way from \a i; none before the border of the image. */
inline std::optional<MeasuredPixel>
nextMeasured (const OrganizedPoints& points, std::uint32_t i, std::ptrdiff_t step)
{
  std::uint32_t last = i, next = nextPixel (points, i, step);
  for (std::size_t steps = 1; next != last; ++steps) {
    if (isMeasured (points[next]))
      return MeasuredPixel{next, steps};
    last = next;
    next = nextPixel (points, next, step);
  }
  return {};
}

/** Finds the first and the last pixel of a cluster in each of its lines, or no_pixel.
 * \param[in] forEachRun forEachRun (use) calls use (run) for the runs of the cluster, in any order
 * \return the first line
 */
template <typename ForEachRun>
std::size_t
findLineEnds (std::size_t width,
              bool along_row,
              const ForEachRun& forEachRun,
              std::vector<std::uint32_t>& first,
              std::vector<std::uint32_t>& last)
{
  const auto lineOf = [&] (std::size_t i) { return along_row ? i / width : i % width; };
  std::size_t begin = std::numeric_limits<std::size_t>::max(), end = 0;
  forEachRun ([&] (const auto& run) {
    begin = std::min (begin, lineOf (run.first));
    end = std::max (end, lineOf (run.first + run.length - 1) + 1);
  });
  first.assign (end - begin, no_pixel);
  last.assign (end - begin, no_pixel);
  const auto extend = [&] (std::size_t line, std::size_t from, std::size_t to) {
    first[line] = std::min (first[line], static_cast<std::uint32_t> (from));
    last[line] = std::max (last[line] == no_pixel ? 0 : last[line],
                           static_cast<std::uint32_t> (to));
  };
  forEachRun ([&] (const auto& run) {
    const std::size_t line = lineOf (run.first) - begin;
    if (along_row)
      extend (line, run.first, run.first + run.length - 1);
    else
      for (std::size_t k = 0; k < run.length; ++k)
        extend (line + k, run.first + k, run.first + k);
  });
  return begin;
}

} // namespace rgbd_planes
} // namespace pcl
