// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "image_lines.h"
#include "link_kernels.h"
#include "object_kernels.h"
#include "run_kernels.h"

#include <pcl/segmentation/impl/object_clusters.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** How far apart neighbours may be on a surface, in widths of a pixel: slopes stretch it. That of
 * level and upright surfaces, such as tops and sides of boxes, is known. */
constexpr float stretch = 3.f;
constexpr float known_stretch = 1.5f;

} // namespace

void
ObjectClusters::compute (const OrganizedPoints& points,
                         const std::vector<std::uint8_t>& selected,
                         const SupportPlanes& supports,
                         const ObjectParameters& parameters)
{
  points_ = points;
  width_ = static_cast<std::uint32_t> (points.width);
  supports_ = &supports;
  parameters_ = parameters;
  runs_.start (width_);
  set_of_run_.clear();
  sums_.clear();
  if (!supports.planes().empty()) {
    markBackground();
    pixel_angle_ = meanPixelAngle (points);
    findRuns (selected);
    sumUp();
  }
  collect();
}

void
ObjectClusters::markBackground()
{
  is_background_.assign (points_.size() + PointRow::block_size, 0);
  for (const auto& plane : supports_->background())
    for (const auto index : *plane.inliers)
      is_background_[static_cast<std::size_t> (index)] = 1;
}

LinkLimit
ObjectClusters::linkLimit() const
{
  return {stretch * pixel_angle_,
          parameters_.cluster_tolerance,
          parameters_.noise,
          known_stretch * pixel_angle_,
          bases_.back()->plane.normal};
}

/** Runs of points above the same plane that are close to each other, joined where points
 * are close to those of the row above. */
void
ObjectClusters::findRuns (const std::vector<std::uint8_t>& selected)
{
  constexpr std::size_t max_bases = maybe_above - above;
  bases_.clear();
  for (const SupportSurface& support : supports_->planes())
    if (!support.is_on_object && bases_.size() < max_bases)
      bases_.push_back (&support);
  // What fills up the last block of a row is in the next one, which is placed later.
  place_.resize (points_.size() + PointRow::block_size);
  const LinkLimit limit = linkLimit();
  rows_[1].load (points_, 0);
  has_above_.resize (rows_[1].blocks());
  for (auto* links : {&to_left_, &to_above_})
    links->resize (rows_[1].blocks() * PointRow::block_size);
  for (int v = 0; v < points_.height; ++v) {
    PointRow &row = rows_[v % 2], &row_above = rows_[1 - v % 2];
    row.load (points_, v);
    const auto first = static_cast<std::uint32_t> (v * points_.width);
    placeRow (row,
              v,
              bases_,
              parameters_,
              &is_background_[first],
              &place_[first],
              has_above_.data());
    settleRow (first, selected);
    linkRow (
        row, row_above, limit, has_above_.data(), to_left_.data(), to_above_.data());
    findRunBits (&place_[first],
                 &place_[nextPixel (points_, first, -points_.width)],
                 outside,
                 to_left_.data(),
                 to_above_.data(),
                 has_above_.data(),
                 runs_.bits());
    runs_.addRow (first);
  }
  if (hasLinesOfGaps (points_))
    bridgeGaps (limit);
  joinAcrossBases (limit);
}

void
ObjectClusters::bridgeGaps (const LinkLimit& limit)
{
  runs_.bridge (width_, [&] (std::uint32_t before, std::uint32_t after) {
    return place_[before] == place_[after] &&
           !isMeasured (points_[before + (after - before) / 2]) &&
           limit.allows (points_[after], points_[before]);
  });
}

/** Decides where the points of a row are that may be above one of the bases. */
void
ObjectClusters::settleRow (std::uint32_t first,
                           const std::vector<std::uint8_t>& selected)
{
  const std::uint32_t end = first + width_;
  for (std::uint32_t i = first; i < end && !selected.empty(); ++i)
    place_[i] = selected[i] ? place_[i] : std::uint8_t{nowhere};
  for (const std::uint8_t kind : has_above_) {
    for (std::uint32_t i = first; kind > 1 && i < first + PointRow::block_size; ++i)
      if (place_[i] >= maybe_above)
        place_[i] = settle (i, place_[i] - std::size_t{maybe_above + above});
    first += PointRow::block_size;
  }
}

/** The place of a point that may be above one of the bases, or on a platform, but above none
 * before. Beside a platform, what is as high as that may be of a thing on a lower base. */
ObjectClusters::Place
ObjectClusters::settle (std::uint32_t i, std::size_t base) const
{
  const float* p = points_[i];
  bool is_beside_platform = false;
  for (; base < bases_.size(); ++base) {
    const SupportSurface& support = *bases_[base];
    const float height = heightAbove (support, i);
    if (!(std::fabs (height) <= parameters_.max_object_height) ||
        !support.surroundings.bounds().contains (support.project (p)))
      continue;
    const bool is_on = mayBeOnPlane (p, support.plane, height, parameters_);
    if (!is_on && height <= 0.f)
      continue;
    if (support.outline.contains (support.project (p)))
      return is_on ? nowhere : static_cast<Place> (above + base);
    if (is_on && !support.is_platform)
      return nowhere;
    is_beside_platform |= is_on;
  }
  return is_beside_platform ? nowhere : settleBeside (i);
}

/** The place of a point that is over no hull. */
ObjectClusters::Place
ObjectClusters::settleBeside (std::uint32_t i) const
{
  for (std::size_t base = 0; base < bases_.size(); ++base) {
    const float height = heightAbove (*bases_[base], i);
    if (height > 0.f && height <= parameters_.max_object_height &&
        bases_[base]->surroundings.contains (bases_[base]->project (points_[i])))
      return static_cast<Place> (above + base);
  }
  return outside;
}

/** In the direction of \a step. Cameras have margins where nothing is measured: those with
 * nothing between them and the border, if that is near. */
std::size_t
ObjectClusters::pointsAtBorder (const PointRun& run, std::ptrdiff_t step) const
{
  const auto height = static_cast<std::uint32_t> (points_.height);
  const std::uint32_t u = run.first % width_, v = run.first / width_;
  const std::uint32_t end = run.first + run.length;
  const ImageMargins& margins = supports_->margins();
  const bool is_near = step == -1  ? u < margins.left
                       : step == 1 ? u + run.length + margins.right > width_
                       : step == -points_.width ? v < margins.above
                                                : v + margins.below >= height;
  if (!is_near)
    return 0;
  // Along the run, only its end can be next to the border.
  const std::uint32_t first = step == 1 ? end - 1 : run.first;
  const std::uint32_t stop = step == -1 ? run.first + 1 : end;
  std::size_t count = 0;
  for (std::uint32_t k = first; k < stop; ++k)
    count += !nextMeasured (points_, k, step);
  return count;
}

std::size_t
ObjectClusters::pointsAtBorder (const PointRun& run) const
{
  const std::uint32_t u = run.first % width_, v = run.first / width_;
  const ImageMargins& margins = supports_->margins();
  if (u >= margins.left && u + run.length + margins.right <= width_ &&
      v >= margins.above &&
      v + margins.below < static_cast<std::uint32_t> (points_.height))
    return 0;
  return pointsAtBorder (run, -1) + pointsAtBorder (run, 1) +
         pointsAtBorder (run, -points_.width) + pointsAtBorder (run, points_.width);
}

bool
ObjectClusters::isTruncated (const std::vector<PointRun>& runs) const
{
  std::size_t at_border = 0;
  for (const PointRun& run : runs)
    at_border += pointsAtBorder (run);
  return isTruncated (at_border);
}

bool
ObjectClusters::isTruncated (std::size_t at_border)
{
  constexpr std::size_t few = 2;
  return at_border > few;
}

void
ObjectClusters::collect()
{
  constexpr std::size_t none = static_cast<std::size_t> (-1);
  std::size_t count = 0;
  for (auto& sums : sums_) {
    sums.cluster = isObject (sums) ? count++ : none;
    if (sums.cluster == none)
      continue;
    clusters_.resize (std::max (clusters_.size(), count));
    clusters_[sums.cluster].runs.clear();
    clusters_[sums.cluster].support = sums.support;
  }
  clusters_.resize (count);
  for (std::size_t k = 0; k < set_of_run_.size(); ++k) {
    const std::size_t cluster = sums_[set_of_run_[k]].cluster;
    if (cluster != none)
      clusters_[cluster].runs.push_back (runs_.runs()[k]);
  }
}

} // namespace rgbd_planes
} // namespace pcl
