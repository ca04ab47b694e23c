// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/features/impl/tangent_normals.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Images whose longer side has so many pixels and more are computed on the means of 2 x 2
 * pixels: their smoothing areas are so large that nothing is lost. Not those of laser scanners
 * with few rows, which see far floor in steps as it is. */
constexpr int min_side_of_cells = 480, min_shorter_side_of_cells = 96;
/** An area is so many times as large as the one before. With depth-dependent smoothing, its
 * size grows with the square root of the range. */
constexpr float area_growth = 1.4f;
/** Bands of fewer rows of cells are not worth a thread. */
constexpr int min_band_height = 16;

/** Areas this far away overlap with that of a cell by more than half. */
int
shift (int half_size)
{
  return std::max (
      static_cast<int> (std::lround (0.7f * static_cast<float> (half_size))), 1);
}

TangentGrid
makeGrid (const OrganizedPoints& points, const TangentNormalParameters& parameters)
{
  TangentGrid grid;
  const int longer_side = std::max (points.width, points.height);
  const int shorter_side = std::min (points.width, points.height);
  const bool is_large =
      longer_side >= min_side_of_cells && shorter_side >= min_shorter_side_of_cells;
  grid.step = is_large ? 2 : 1;
  grid.width = (points.width + grid.step - 1) / grid.step;
  grid.height = (points.height + grid.step - 1) / grid.step;
  const float side_of_cells = 2.f * static_cast<float> (grid.step);
  const float automatic =
      std::max (static_cast<float> (longer_side) * 3.f / 160.f, 4.f);
  const auto half = [&] (float size, float growth, int limit) {
    // To the nearest number of cells on either side: less than a whole one would be lost.
    const float cells = std::round ((size == 0.f ? automatic : size) / side_of_cells);
    return static_cast<int> (
        std::clamp (growth * cells, 1.f, static_cast<float> (limit)));
  };
  const bool several =
      parameters.depth_dependent_smoothing || parameters.scale_selection;
  grid.number_of_areas = several ? grid.areas.size() : 1;
  float growth = 1.f;
  for (auto& area : grid.areas) {
    area.half_width = half (parameters.smoothing_width, growth, grid.width);
    area.half_height = half (parameters.smoothing_height, growth, grid.height);
    // Between the ranges at which this area and the one before would be right.
    area.min_range = growth * growth / area_growth;
    growth *= area_growth;
  }
  const auto& area = grid.areas[0];
  grid.diagonal = {area.half_width, area.half_height};
  grid.straight = {shift (area.half_width), shift (area.half_height)};
  return grid;
}

} // namespace

std::size_t
TangentNormals::compute (const OrganizedPoints& points,
                         const TangentNormalParameters& parameters,
                         const NormalOutput& output)
{
  if (points.size() == 0)
    return 0;
  const TangentGrid grid = makeGrid (points, parameters);
  const auto most = static_cast<unsigned> (std::max (grid.height / min_band_height, 1));
  const int bands = static_cast<int> (std::clamp (parameters.threads, 1u, most));
  pipelines_.resize (std::max (pipelines_.size(), static_cast<std::size_t> (bands)));
  const auto begin = [&] (int band) { return grid.height * band / bands; };
  // Exceptions, of memory that is short, must not leave a parallel region.
  for (int band = 0; band < bands; ++band)
    pipelines_[static_cast<std::size_t> (band)].start (
        points, parameters, grid, begin (band));
  std::size_t valid = 0;
#pragma omp parallel for num_threads(bands) schedule(static, 1) reduction(+ : valid)
  for (int band = 0; band < bands; ++band)
    valid += pipelines_[static_cast<std::size_t> (band)].run (begin (band + 1), output);
  return valid;
}

} // namespace rgbd_planes
} // namespace pcl
