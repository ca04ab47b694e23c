// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "active_stereo.h"

#include "correlated_noise.h"

#include <cmath>
#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr float baseline_m = 0.05f;
/** A disparity in steps, of which a pixel has 32, times depth in metres, for the focal length of
 * a D435 with 640 columns. */
constexpr float steps_times_m = 32.f * 383.8f * baseline_m;
/** The standard deviation of the disparity, and the windows that share it; both fitted to the
 * recording. */
constexpr float noise_steps = 1.9f;
constexpr int window_width_px = 18, window_height_px = 12;

constexpr float min_range_m = 0.3f, max_range_m = 8.f;

} // namespace

std::vector<Eigen::Vector3f>
activeStereoEyes ()
{
  return {{baseline_m, 0.f, 0.f}};
}

std::vector<float>
measureWithActiveStereo (const std::vector<RenderedPixel>& image,
                         const Camera& camera,
                         Random& random)
{
  const auto noise =
      correlatedNoise (camera, window_width_px, window_height_px, random);
  std::vector<float> depth (image.size(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < image.size(); ++i) {
    if (!isInView (image[i]))
      continue;
    const float steps =
        std::round (steps_times_m / image[i].point.z() + noise_steps * noise[i]);
    const float measured = std::round (1000.f * steps_times_m / steps) / 1000.f;
    if (measured >= min_range_m && measured <= max_range_m)
      depth[i] = measured;
  }
  return depth;
}

} // namespace rgbd_planes
} // namespace pcl
