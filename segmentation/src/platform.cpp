// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "platform.h"

#include "point_sample.h"
#include "spread_sample.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Platforms are so many times as long, from corner to corner, and on average as wide as the
 * largest height of an object: for 30 cm, a tread of stairs is one, a box of 50 x 50 cm and a
 * plank are not. */
constexpr float min_length = 2.8f;
constexpr float min_width = 0.75f;
/** So large a part of the rays may go through the hull of a platform: a ramp has strips of floor
 * at its foot. */
constexpr float max_gaps = 0.1f;
constexpr std::size_t sampled_rays = 2000;
constexpr float noise_sigmas = 3.f;
/** The main part reaches so many standard deviations of its own points: evenly spread ones reach
 * 1.73 along the sides of a rectangle, and more if a part of it is hidden. */
constexpr double main_sigmas = 2.2;
constexpr std::size_t sampled_points = 1000;
constexpr int main_part_rounds = 4;

float
lengthOf (const std::vector<Eigen::Vector2f>& corners)
{
  float squared = 0.f;
  for (const auto& a : corners)
    for (const auto& b : corners)
      squared = std::max (squared, (a - b).squaredNorm());
  return std::sqrt (squared);
}

float
areaOf (const std::vector<Eigen::Vector2f>& corners)
{
  float twice = 0.f;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto &a = corners[k], &b = corners[(k + 1) % corners.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5f * twice;
}

} // namespace

bool
isLargerThanTops (const ConvexOutline& hull, float max_object_height)
{
  const float length = lengthOf (hull.corners());
  return length >= min_length * max_object_height &&
         areaOf (hull.corners()) >= min_width * max_object_height * length;
}

void
MainPart::compute (const OrganizedPoints& points,
                   const pcl::Indices& inliers,
                   const SupportSurface& surface)
{
  *this = {};
  for (int round = 0; round < main_part_rounds; ++round) {
    double area = 0.;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    samplePoints (points, inliers, sampled_points, [&] (const auto& p) {
      const Eigen::Vector2f q = surface.project (p.data());
      if (!contains (q))
        return;
      // Of a level surface, a pixel sees a part that grows with the cube of its range.
      const double weight = std::pow (p.norm(), 3.f);
      area += weight;
      sum += weight * q.cast<double>();
      squares += weight * (q * q.transpose()).template cast<double>();
    });
    if (!(area > 0.))
      return;
    const Eigen::Vector2d mean = sum / area;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
    solver.computeDirect (squares / area - mean * mean.transpose());
    center_ = mean.cast<float>();
    axes_ = solver.eigenvectors().transpose().cast<float>();
    reach_ =
        (main_sigmas * solver.eigenvalues().cwiseMax (0.).cwiseSqrt()).cast<float>();
  }
}

bool
isClosed (const OrganizedPoints& points,
          const pcl::Indices& inliers,
          const SupportSurface& surface,
          const ConvexOutline& hull,
          const DepthNoise& noise)
{
  const auto [lowest, highest] = std::minmax_element (inliers.begin(), inliers.end());
  const auto first = static_cast<std::size_t> (*lowest);
  const auto count = static_cast<std::size_t> (*highest) + 1 - first;
  SpreadSample sample (std::max<std::size_t> (count / sampled_rays, 1));
  std::size_t on = 0, through = 0;
  for (std::size_t k = sample.next(); k < count; k = sample.next()) {
    const float* p = points[first + k];
    if (!isMeasured (p))
      continue;
    const float height = surface.plane.distance (p);
    const float to_plane = surface.plane.d / (surface.plane.d - height);
    if (!(to_plane > 0.f) || hull.depthOf (to_plane * surface.project (p)) < 0.f)
      continue;
    if (isWithinNoise (p, surface.plane, height, noise_sigmas, noise))
      ++on;
    else
      through += height < 0.f;
  }
  return static_cast<float> (through) < max_gaps * static_cast<float> (on + through);
}

} // namespace rgbd_planes
} // namespace pcl
