// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "plane_noise.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr int tile_px = 40;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Region {
  int left, top, right, bottom;
};

/** One over depth, NaN where there is none. */
struct InverseDepth {
  std::vector<double> values;
  int width;
  int height;

  double
  at (int u, int v) const
  {
    return values[static_cast<std::size_t> (v) * width + u];
  }
};

template <typename Visit>
void
forEachPoint (const InverseDepth& image, const Region& region, const Visit& visit)
{
  for (int v = region.top; v < std::min (region.bottom, image.height); ++v)
    for (int u = region.left; u < std::min (region.right, image.width); ++u)
      if (std::isfinite (image.at (u, v)))
        visit (u, v, image.at (u, v));
}

struct Fit {
  int points = 0;
  Eigen::Vector3d plane;
};

Fit
fitPlane (const InverseDepth& image, const Region& region)
{
  Fit fit;
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d products = Eigen::Vector3d::Zero();
  forEachPoint (image, region, [&] (int u, int v, double value) {
    const Eigen::Vector3d row (u, v, 1.);
    squares += row * row.transpose();
    products += row * value;
    ++fit.points;
  });
  fit.plane = squares.ldlt().solve (products);
  return fit;
}

/** Deviations in depth from the planes of tiles. */
struct Deviations {
  std::vector<double> values;
  double rms = 0.;
};

Deviations
deviationsFromTiles (const InverseDepth& image,
                     int tile_width,
                     int tile_height,
                     int min_points)
{
  Deviations result;
  result.values.assign (image.values.size(), nan);
  double squares = 0.;
  int freedom = 0;
  for (int top = 0; top < image.height; top += tile_height)
    for (int left = 0; left < image.width; left += tile_width) {
      const Region tile{left, top, left + tile_width, top + tile_height};
      const Fit fit = fitPlane (image, tile);
      if (fit.points < min_points)
        continue;
      forEachPoint (image, tile, [&] (int u, int v, double value) {
        const double expected = fit.plane.dot (Eigen::Vector3d (u, v, 1.));
        const double deviation = (expected - value) / (expected * expected);
        result.values[static_cast<std::size_t> (v) * image.width + u] = deviation;
        squares += deviation * deviation;
      });
      freedom += fit.points - 3;
    }
  if (freedom <= 0)
    throw std::invalid_argument ("measurePlaneNoise: the plane does not fill a tile");
  result.rms = std::sqrt (squares / freedom);
  return result;
}

double
correlation (const Deviations& deviations, int width, int right, int down)
{
  double products = 0.;
  int pairs = 0;
  const int height = static_cast<int> (deviations.values.size()) / width;
  for (int v = 0; v + down < height; ++v)
    for (int u = 0; u + right < width; ++u) {
      const bool same_tile =
          u / tile_px == (u + right) / tile_px && v / tile_px == (v + down) / tile_px;
      const double product = deviations.values[v * width + u] *
                             deviations.values[(v + down) * width + u + right];
      if (same_tile && std::isfinite (product)) {
        products += product;
        ++pairs;
      }
    }
  return products / pairs / (deviations.rms * deviations.rms);
}

} // namespace

PlaneNoise
measurePlaneNoise (const std::vector<float>& depth, int width)
{
  PlaneNoise noise;
  InverseDepth image{{}, width, static_cast<int> (depth.size()) / width};
  std::set<float> levels;
  for (const float value : depth) {
    image.values.push_back (1. / value);
    if (!std::isfinite (value))
      continue;
    levels.insert (value);
    noise.depth_m += value;
    ++noise.points;
  }
  const Deviations local =
      deviationsFromTiles (image, tile_px, tile_px, tile_px * tile_px * 4 / 5);
  noise.depth_m /= static_cast<double> (noise.points);
  noise.step_m = noise.depth_m * noise.depth_m *
                 (1. / *levels.begin() - 1. / *levels.rbegin()) /
                 static_cast<double> (levels.size() - 1);
  noise.local_rms_m = local.rms;
  noise.global_rms_m = deviationsFromTiles (image, image.width, image.height, 0).rms;
  for (std::size_t i = 0; i < PlaneNoise::lags.size(); ++i) {
    noise.correlation_right[i] = correlation (local, width, PlaneNoise::lags[i], 0);
    noise.correlation_down[i] = correlation (local, width, 0, PlaneNoise::lags[i]);
  }
  const Fit fit = fitPlane (image, {0, 0, image.width, image.height});
  noise.plane = {{fit.plane[0], fit.plane[1], fit.plane[2]}};
  return noise;
}

} // namespace rgbd_planes
} // namespace pcl
