// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/depth_noise_estimation.h>
#include <pcl/segmentation/impl/plane_moments.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace pcl {

namespace {

using rgbd_planes::OrganizedPoints;

/** Along the longer side of the image, and at least along the shorter one, for rows of laser
 * scanners are few and far apart; in pixels. */
constexpr int blocks_in_a_line = 40, blocks_across = 10, min_side = 8;
constexpr double min_filled = 0.9;
/** Cosine of the angle between the normal and the ray: flatter surfaces are left out. */
constexpr double min_cosine = 0.5;
/** In metres; beyond that, units are others. */
constexpr double max_range = 100.;
/** From one level of ranges to the next. */
constexpr double range_step = 1.15;
constexpr std::size_t min_blocks = 20;
constexpr float for_larger_surfaces = 2.f;
/** Below this the error of blocks is that of numbers. */
constexpr float min_sigma = 0.00005f;
/** Relative to depth, the difference of numbers that say the same. */
constexpr float same_depth = 1e-6f;
/** How large the constant part may well be where no level is near enough to tell, and how far
 * off, of their own, levels may be for that. */
constexpr double usual_constant = 0.001, level_error = 0.2;
/** Levels that are farther off in the mean tell another one: that of laser scanners is
 * centimetres. */
constexpr double max_error = 1.5 * level_error;
/** The first quartile of turns of a Kinect v1, 0.48 to 0.58 in recordings and simulated. */
constexpr float turn_of_kinect = 0.55f;

/** What the measured points of a small square of the image see. */
struct Block {
  double range;
  /** Inverse ranges are the scalar product with the directions of rays. */
  Eigen::Vector3d plane;
  /** In the mean of its points. */
  Eigen::Vector3d ray;
  /** Standard deviation of inverse ranges. */
  double error;
  /** Then the steps in which depth is told hide its noise. */
  bool has_one_depth;

  /** That of ranges. */
  double
  sigma () const
  {
    return error * range * range;
  }
};

/** How far the planes of two blocks turn, over the distance from one to the other, in standard
 * deviations of inverse ranges. */
float
turnBetween (const Block& a, const Block& b)
{
  const double turn = std::fabs ((a.plane - b.plane).dot (a.ray - b.ray));
  return static_cast<float> (turn /
                             std::sqrt (0.5 * (a.error * a.error + b.error * b.error)));
}

/** The first quartile; \a values are not empty. */
float
firstQuartile (std::vector<float> values)
{
  const auto quartile =
      values.begin() + static_cast<std::ptrdiff_t> (values.size() / 4);
  std::nth_element (values.begin(), quartile, values.end());
  return *quartile;
}

/** The block from (\a left, \a top) on; none where too few points are measured or their plane is
 * seen flatly. */
std::optional<Block>
fitBlock (const OrganizedPoints& points, int left, int top, int side)
{
  rgbd_planes::PlaneMoments moments;
  Eigen::Vector3d rays = Eigen::Vector3d::Zero();
  double ranges = 0.;
  float nearest = std::numeric_limits<float>::infinity(), farthest = -nearest;
  for (int v = top; v < top + side; ++v)
    for (int u = left; u < left + side; ++u) {
      const float* p = points[static_cast<std::size_t> (v * points.width + u)];
      if (!rgbd_planes::isMeasured (p))
        continue;
      const Eigen::Vector3d point =
          Eigen::Map<const Eigen::Vector3f> (p).cast<double>();
      const double range = point.norm();
      // Errors of inverse ranges count alike.
      moments.add (p, 1. / (range * range));
      rays += point / range;
      ranges += range;
      nearest = std::min (nearest, p[2]);
      farthest = std::max (farthest, p[2]);
    }
  const auto count = static_cast<double> (moments.points);
  if (count < min_filled * side * side)
    return std::nullopt;
  const Eigen::Vector3d m = moments.inverseDistance();
  const double range = ranges / count;
  if (!(m.dot (rays) > min_cosine * m.norm() * rays.norm() && range < max_range))
    return std::nullopt;
  const double squares = std::max (0., moments.squaredErrors (m));
  const double error =
      std::max (std::sqrt (squares / (count - 3.)), min_sigma / (range * range));
  const bool has_one_depth = farthest - nearest <= same_depth * farthest;
  return Block{range, m, rays / count, error, has_one_depth};
}

using Levels = std::vector<DepthNoiseEstimation::Level>;

/** What a constant and a quadratic part of 1 m give at a level, in its sigmas. */
Eigen::Vector2d
partsAt (const DepthNoiseEstimation::Level& level)
{
  return Eigen::Vector2d (1., level.range * level.range) / level.sigma;
}

/** Least squares of the relative errors of all levels, and of the constant part times \a
 * shrink. */
Eigen::Vector2d
fitLevels (const Levels& levels, double shrink)
{
  Eigen::Matrix2d products = Eigen::Vector2d (shrink * shrink, 0.).asDiagonal();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const auto& level : levels) {
    const Eigen::Vector2d parts = partsAt (level);
    products += parts * parts.transpose();
    right += parts;
  }
  const Eigen::Vector2d fit = products.ldlt().solve (right);
  if (fit[0] < 0.)
    return {0., right[1] / products (1, 1)};
  if (fit[1] < 0.)
    return {right[0] / products (0, 0), 0.};
  return fit;
}

/** Root of the mean squared relative error of all levels. */
double
errorOf (const Eigen::Vector2d& fit, const Levels& levels)
{
  double squares = 0.;
  for (const auto& level : levels)
    squares += std::pow (fit.dot (partsAt (level)) - 1., 2);
  return std::sqrt (squares / static_cast<double> (levels.size()));
}

} // namespace

void
DepthNoiseEstimation::addPoints (const OrganizedPoints& points)
{
  ++frames_;
  const auto [shorter, longer] = std::minmax (points.width, points.height);
  const int side = std::max (
      min_side, std::min (longer / blocks_in_a_line, shorter / blocks_across));
  // Of a camera on its side, that is what is below.
  const bool is_beside = points.height > points.width;
  std::vector<std::optional<Block>> above (
      static_cast<std::size_t> (points.width / side));
  for (int top = 0; top + side <= points.height; top += side) {
    std::optional<Block> left;
    for (std::size_t column = 0; column < above.size(); ++column) {
      const auto block = fitBlock (points, static_cast<int> (column) * side, top, side);
      if (block) {
        Blocks& similar =
            (block->has_one_depth ? blocks_of_one_depth_ : blocks_)[static_cast<int> (
                std::floor (std::log (block->range) / std::log (range_step)))];
        similar.ranges += block->range;
        similar.sigmas.push_back (static_cast<float> (block->sigma()));
      }
      const auto& before = is_beside ? left : above[column];
      if (block && before && !block->has_one_depth && !before->has_one_depth)
        turns_.push_back (turnBetween (*before, *block));
      left = above[column] = block;
    }
  }
}

std::vector<DepthNoiseEstimation::Level>
DepthNoiseEstimation::getLevels() const
{
  std::vector<Level> levels = levelsOf (blocks_);
  return levels.empty() ? levelsOf (blocks_of_one_depth_) : levels;
}

std::vector<DepthNoiseEstimation::Level>
DepthNoiseEstimation::levelsOf (const std::map<int, Blocks>& all_blocks)
{
  std::size_t all = 0;
  for (const auto& [step, blocks] : all_blocks)
    all += blocks.sigmas.size();
  std::vector<Level> levels;
  for (const auto& [step, blocks] : all_blocks) {
    const std::size_t count = blocks.sigmas.size();
    if (count < min_blocks || count < all / 100)
      continue;
    levels.push_back ({static_cast<float> (blocks.ranges / static_cast<double> (count)),
                       count,
                       firstQuartile (blocks.sigmas)});
  }
  return levels;
}

bool
DepthNoiseEstimation::estimate (rgbd_planes::DepthNoise& noise) const
{
  const std::vector<Level> levels = getLevels();
  if (levels.empty()) {
    PCL_ERROR (
        "[pcl::DepthNoiseEstimation::estimate] No %zu smooth pieces of surfaces at one "
        "range in %zu frames: add frames that see floor, walls or tables, in metres; a "
        "small image has few pieces.\n",
        min_blocks,
        frames_);
    return false;
  }
  Eigen::Vector2d fit = fitLevels (levels, level_error / usual_constant);
  if (errorOf (fit, levels) > max_error)
    fit = fitLevels (levels, 0.);
  noise = {std::max (for_larger_surfaces * static_cast<float> (fit[0]), 0.0001f),
           std::max (for_larger_surfaces * static_cast<float> (fit[1]), 0.0002f)};
  if (turns_.size() >= min_blocks)
    noise.normal_scatter = std::clamp (firstQuartile (turns_) / turn_of_kinect,
                                       1.f,
                                       rgbd_planes::DepthNoise::max_normal_scatter);
  return true;
}

} // namespace pcl
