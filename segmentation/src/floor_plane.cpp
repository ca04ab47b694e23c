// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/segmentation/floor_plane.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Noise tilts small planes of the floor less. */
constexpr float max_cos_tilted = 0.9962f; // 5 degrees
/** Points further from the floor are not on it. */
constexpr float off_sigmas = 3.f;
/** The smooth error of depth bends parts of a floor by less, in the mean. Those with a
 * quarter of the points of the floor are too large for the top of a low thing. */
constexpr float part_sigmas = 1.5f, large_part_sigmas = 3.f;
/** A camera that is nearer cannot see a floor. */
constexpr float min_camera_height = 0.01f;

/** Calls visit (point, plane) for about every 64th point that is usable and on a plane. */
template <typename Visit>
void
forEachSample (const OrganizedPoints& points,
               const LabelledPlanes& planes,
               const DepthNoise& noise,
               const Visit& visit)
{
  const int step = std::max (points.width / 80, 1);
  for (int v = step / 2; v < points.height; v += step)
    for (int u = step / 2; u < points.width; u += step) {
      const auto i = static_cast<std::size_t> (v * points.width + u);
      if (planes[i] < planes.coefficients.size() && isUsable (points[i], noise))
        visit (points[i], planes[i]);
    }
}

} // namespace

void
FloorPlane::find (const OrganizedPoints& points,
                  const LabelledPlanes& planes,
                  const Eigen::Affine3f& camera_to_base,
                  const DepthNoise& noise,
                  float max_angle,
                  float max_height)
{
  const Eigen::Vector4f height = camera_to_base.matrix().row (2);
  samples_.assign (planes.coefficients.size(), {});
  forEachSample (points, planes, noise, [&] (const float* p, std::uint32_t plane) {
    samples_[plane].height += heightAbove (height, p);
    ++samples_[plane].points;
  });

  const float min_cos = std::cos (max_angle);
  std::size_t most = 0, floor = 0;
  found_ = false;
  coefficients_.setZero();
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    const Eigen::Vector4f& plane = planes.coefficients[k];
    const auto count = static_cast<float> (samples_[k].points);
    if (samples_[k].points <= most || plane[3] < min_camera_height ||
        plane.head<3>().dot (height.head<3>()) < min_cos ||
        std::abs (samples_[k].height) > max_height * count)
      continue;
    found_ = true;
    coefficients_ = plane;
    floor = k;
    most = samples_[k].points;
  }
  if (found_)
    compare (points, planes, noise, floor);
}

void
FloorPlane::compare (const OrganizedPoints& points,
                     const LabelledPlanes& planes,
                     const DepthNoise& noise,
                     std::size_t floor)
{
  forEachSample (points, planes, noise, [&] (const float* p, std::uint32_t plane) {
    const float height = heightAbove (coefficients_, p);
    const float variance = heightVariance (p, coefficients_[3], noise);
    samples_[plane].off += height * height > off_sigmas * off_sigmas * variance;
    samples_[plane].sigmas += height / noise.sigma (squaredRange (p));
  });
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    Samples& samples = samples_[k];
    samples.is_tilted =
        planes.coefficients[k].head<3>().dot (coefficients_.head<3>()) < max_cos_tilted;
    const bool is_large = 4 * samples.points >= samples_[floor].points;
    const float sigmas = is_large ? large_part_sigmas : part_sigmas;
    samples.is_part =
        k != floor && !samples.is_tilted &&
        std::abs (samples.sigmas) < sigmas * static_cast<float> (samples.points);
  }
}

} // namespace rgbd_planes
} // namespace pcl
