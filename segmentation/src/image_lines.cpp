// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "image_lines.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl {
namespace rgbd_planes {

namespace {

/** So many rows and columns are looked at. */
constexpr int sampled_lines = 10;

/** Square pixels of a camera differ by no more in their angles along rows and columns. */
constexpr float max_distortion = 1.2f;

/** Of the pixels of a camera, a smaller part has no depth between two that have. */
constexpr double most_gaps = 0.02;

/** Images of cameras have ragged margins with little depth; each is at most this part of the
 * image. */
constexpr int part_of_ragged = 20;

/** In lines without depth, a smaller part of the pixels has depth, of those that are looked at. */
constexpr int part_measured = 50, pixels_apart = 4;
/** So many rows tell whether such columns are a band. */
constexpr int band_rows = 40;

/** The points of some rows or columns of an image. */
struct Lines {
  const float*
  point (int line, int k) const
  {
    return points[static_cast<std::size_t> (line * to_line + k * to_next)];
  }

  /** Calls use (line) for some of them. */
  template <typename Use>
  void
  sample (const Use& use) const
  {
    const int step = std::max (number / sampled_lines, 1);
    for (int line = step / 2; line < number; line += step)
      use (line);
  }

  const OrganizedPoints& points;
  int number, to_line, length, to_next;
};

Lines
rowsOf (const OrganizedPoints& points)
{
  return {points, points.height, points.width, points.width, 1};
}

Lines
columnsOf (const OrganizedPoints& points)
{
  return {points, points.width, 1, points.height, points.width};
}

/** The angle between the rays of neighbouring points; measured piece by piece, for a line may go
 * all around. */
float
meanAngle (const Lines& lines)
{
  constexpr int pieces = 8;
  const int piece = std::max (lines.length / pieces, 1);
  float angles = 0.f;
  int pixels = 0;
  lines.sample ([&] (int line) {
    const auto ray = [&] (int k) { return lines.point (line, k); };
    int first = 0, last = lines.length - 1;
    while (first < last && !isMeasured (ray (first)))
      ++first;
    while (first < last && !isMeasured (ray (last)))
      --last;
    for (int k = first; first < last; first = k) {
      k = std::min (first + piece, last);
      while (!isMeasured (ray (k)))
        ++k;
      const Eigen::Map<const Eigen::Vector3f> p (ray (first)), q (ray (k));
      const float angle = std::atan2 (p.cross (q).norm(), p.dot (q));
      if (!std::isfinite (angle)) // of points that are too far away for floats
        continue;
      angles += angle;
      pixels += k - first;
    }
  });
  return pixels ? angles / static_cast<float> (pixels) : 0.f;
}

/** How many lines at a border may be ragged. */
std::uint32_t
raggedMargin (const Lines& lines)
{
  return static_cast<std::uint32_t> (lines.number / part_of_ragged + 1);
}

/** How many columns from \a first on, each \a step from the one before, are of a band without
 * depth. Where the scene ends, rows end in different columns; those of a band end beside it. */
std::uint32_t
bandFrom (int first, int step, const Lines& columns)
{
  const auto isInside = [&] (int column) {
    return column >= 0 && column < columns.number;
  };
  int end = first;
  for (; isInside (end); end += step) {
    int measured = 0;
    for (int k = 0; k < columns.length; k += pixels_apart)
      measured += isMeasured (columns.point (end, k));
    if (part_measured * pixels_apart * measured > columns.length)
      break;
  }
  const auto ragged = static_cast<int> (raggedMargin (columns));
  int rows = 0, beside = 0;
  for (int k = 0; k < columns.length; k += std::max (columns.length / band_rows, 1)) {
    int column = end;
    while (isInside (column) && !isMeasured (columns.point (column, k)))
      column += step;
    rows += isInside (column);
    beside += isInside (column) && step * (column - end) < ragged;
  }
  return 2 * beside > rows ? static_cast<std::uint32_t> (step * (end - first)) : 0;
}

} // namespace

ImageMargins
marginsOf (const OrganizedPoints& points)
{
  const Lines rows = rowsOf (points), columns = columnsOf (points);
  const std::uint32_t ragged = raggedMargin (columns);
  return {bandFrom (0, 1, columns) + ragged,
          bandFrom (columns.number - 1, -1, columns) + ragged,
          raggedMargin (rows),
          raggedMargin (rows)};
}

PixelAngles
pixelAngles (const OrganizedPoints& points)
{
  return {meanAngle (rowsOf (points)), meanAngle (columnsOf (points))};
}

float
meanPixelAngle (const OrganizedPoints& points)
{
  const auto [in_row, in_column] = pixelAngles (points);
  return in_column > max_distortion * in_row ? in_column : in_row;
}

bool
hasLinesOfGaps (const OrganizedPoints& points)
{
  std::size_t measured = 0, gaps = 0;
  for (const Lines& lines : {rowsOf (points), columnsOf (points)})
    lines.sample ([&] (int line) {
      const auto isMeasuredAt = [&] (int k) {
        return isMeasured (lines.point (line, k));
      };
      for (int k = 1; k + 1 < lines.length; ++k) {
        const bool is_measured = isMeasuredAt (k);
        measured += is_measured;
        gaps += !is_measured && isMeasuredAt (k - 1) && isMeasuredAt (k + 1);
      }
    });
  return static_cast<double> (gaps) > most_gaps * static_cast<double> (measured);
}

} // namespace rgbd_planes
} // namespace pcl
