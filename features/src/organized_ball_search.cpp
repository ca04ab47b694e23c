// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "organized_ball_search.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace pcl {
namespace rgbd_planes {

void
OrganizedBallSearch::setPoints (const OrganizedPoints& points)
{
  width_ = points.width;
  tiles_.clear();
  levels_.clear();
  if (points.size() == 0)
    return;

  Level level{(points.width + tile_size - 1) / tile_size,
              (points.height + tile_size - 1) / tile_size,
              {}};
  for (int v = 0; v < level.height; ++v)
    for (int u = 0; u < level.width; ++u) {
      tiles_.push_back (loadTile (points, u, v));
      level.boxes.push_back (bound (tiles_.back()));
    }
  levels_.push_back (std::move (level));
  while (levels_.back().boxes.size() > 1)
    levels_.push_back (halve (levels_.back()));
}

void
OrganizedBallSearch::search (const float* centre,
                             float radius,
                             std::vector<int>& found) const
{
  found.clear();
  if (!levels_.empty())
    visit (levels_.size() - 1,
           0,
           0,
           {{{centre[0], centre[1], centre[2]}}, radius * radius},
           found);
}

OrganizedBallSearch::Tile
OrganizedBallSearch::loadTile (const OrganizedPoints& points,
                               int tile_u,
                               int tile_v) const
{
  Tile tile;
  for (auto& coordinates : tile.xyz)
    coordinates.fill (std::numeric_limits<float>::quiet_NaN());
  const int right = std::min ((tile_u + 1) * tile_size, points.width);
  const int bottom = std::min ((tile_v + 1) * tile_size, points.height);
  for (int v = tile_v * tile_size; v < bottom; ++v)
    for (int u = tile_u * tile_size; u < right; ++u) {
      const float* p = points[static_cast<std::size_t> (v) * points.width + u];
      const int k = v % tile_size * tile_size + u % tile_size;
      if (isMeasured (p))
        for (std::size_t i = 0; i < 3; ++i)
          tile.xyz[i][static_cast<std::size_t> (k)] = p[i];
    }
  return tile;
}

OrganizedBallSearch::Box
OrganizedBallSearch::bound (const Tile& tile)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Box box{{{infinity, infinity, infinity}}, {{-infinity, -infinity, -infinity}}};
  for (std::size_t i = 0; i < 3; ++i)
    for (const float x : tile.xyz[i])
      if (x == x) {
        box.low[i] = std::min (box.low[i], x);
        box.high[i] = std::max (box.high[i], x);
      }
  return box;
}

OrganizedBallSearch::Level
OrganizedBallSearch::halve (const Level& level)
{
  Level half{(level.width + 1) / 2, (level.height + 1) / 2, {}};
  for (int v = 0; v < level.height; v += 2)
    for (int u = 0; u < level.width; u += 2) {
      Box box = level.at (u, v);
      for (int below_v = v; below_v < std::min (v + 2, level.height); ++below_v)
        for (int below_u = u; below_u < std::min (u + 2, level.width); ++below_u)
          for (std::size_t i = 0; i < 3; ++i) {
            const Box& below = level.at (below_u, below_v);
            box.low[i] = std::min (box.low[i], below.low[i]);
            box.high[i] = std::max (box.high[i], below.high[i]);
          }
      half.boxes.push_back (box);
    }
  return half;
}

bool
OrganizedBallSearch::reaches (const Ball& ball, const Box& box)
{
  float squared_distance = 0.f;
  for (std::size_t i = 0; i < 3; ++i) {
    const float outside =
        std::max ({box.low[i] - ball.centre[i], ball.centre[i] - box.high[i], 0.f});
    squared_distance += outside * outside;
  }
  return squared_distance < ball.squared_radius;
}

void
OrganizedBallSearch::visit (
    std::size_t level, int u, int v, const Ball& ball, std::vector<int>& found) const
{
  if (!reaches (ball, levels_[level].at (u, v)))
    return;
  if (level == 0) {
    scanTile (u, v, ball, found);
    return;
  }
  const Level& below = levels_[level - 1];
  for (int below_v = 2 * v; below_v < std::min (2 * v + 2, below.height); ++below_v)
    for (int below_u = 2 * u; below_u < std::min (2 * u + 2, below.width); ++below_u)
      visit (level - 1, below_u, below_v, ball, found);
}

void
OrganizedBallSearch::scanTile (int tile_u,
                               int tile_v,
                               const Ball& ball,
                               std::vector<int>& found) const
{
  const Tile& tile =
      tiles_[static_cast<std::size_t> (tile_v) * levels_.front().width + tile_u];
  std::array<float, tile_points> squared_distances{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < tile_points; ++k) {
      const float difference = ball.centre[i] - tile.xyz[i][k];
      squared_distances[k] += difference * difference;
    }
  const int first = tile_v * tile_size * width_ + tile_u * tile_size;
  for (int k = 0; k < static_cast<int> (tile_points); ++k)
    if (squared_distances[static_cast<std::size_t> (k)] < ball.squared_radius)
      found.push_back (first + k / tile_size * width_ + k % tile_size);
}

} // namespace rgbd_planes
} // namespace pcl
