// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <hwy/cache_control.h>

#include <pcl/segmentation/impl/plane_warp.h>

#include <algorithm>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr std::size_t sample_step = 10;
/** Points are fetched before so many samples. */
constexpr std::size_t samples_ahead = 16;
/** Blocks of a row for which a window reaches one block further to each side. */
constexpr std::size_t blocks_per_reach = 16;
/** The part of the pixels of a window that inliers must fill. */
constexpr float min_part = 0.125f;

} // namespace

void
PlaneWarp::compute (const OrganizedPoints& points,
                    const pcl::Indices& inliers,
                    const Plane& plane)
{
  const auto blocksIn = [] (int pixels) {
    return static_cast<std::size_t> ((pixels + block_size - 1) / block_size);
  };
  columns_ = blocksIn (points.width);
  rows_ = blocksIn (points.height);
  sums_.assign (columns_ * rows_, {});
  const auto width = static_cast<std::size_t> (points.width);
  std::size_t row = 0; // of the pixel before
  for (std::size_t k = 0; k < inliers.size(); k += sample_step) {
    if (k + samples_ahead * sample_step < inliers.size())
      hwy::Prefetch (
          points[static_cast<std::size_t> (inliers[k + samples_ahead * sample_step])]);
    const auto index = static_cast<std::size_t> (inliers[k]);
    const float* p = points[index];
    if (!isMeasured (p))
      continue;
    if (index - row * width >= width) // also where it is less
      row = index / width;
    Sum& sum = sums_[row / block_size * columns_ + (index - row * width) / block_size];
    sum.heights += plane.distance (p);
    sum.points += 1.f;
  }
  heights_.assign (columns_ * rows_, 0.f);
  for (std::size_t v = 0; v < rows_; ++v)
    for (std::size_t u = 0; u < columns_; ++u)
      if (const Sum sum = window (u, v); sum.points > 0.f)
        heights_[v * columns_ + u] = sum.heights / sum.points;
}

/** Sums over the blocks around one; nothing where there are too few inliers. */
PlaneWarp::Sum
PlaneWarp::window (std::size_t column, std::size_t row) const
{
  const std::size_t reach = columns_ / blocks_per_reach;
  Sum sum;
  float blocks = 0.f;
  for (std::size_t v = row - std::min (row, reach);
       v <= std::min (row + reach, rows_ - 1);
       ++v)
    for (std::size_t u = column - std::min (column, reach);
         u <= std::min (column + reach, columns_ - 1);
         ++u) {
      const Sum& block = sums_[v * columns_ + u];
      sum.heights += block.heights;
      sum.points += block.points;
      ++blocks;
    }
  constexpr float samples_in_block = float{block_size * block_size} / sample_step;
  return sum.points < min_part * blocks * samples_in_block ? Sum{} : sum;
}

} // namespace rgbd_planes
} // namespace pcl
