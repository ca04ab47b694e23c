// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "kinect.h"

#include "correlated_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl {
namespace rgbd_planes {

namespace {

constexpr float baseline_m = 0.075f;
constexpr float color_camera_m = 0.025f;
/** The focal length of the infrared camera that drivers assume. */
constexpr float infrared_focal_px = 575.8f;
/** A disparity in steps, times depth in metres. */
constexpr float steps_per_px = 8.f;
constexpr float steps_times_m = steps_per_px * infrared_focal_px * baseline_m;

/** Noise of the disparity: together with its quantisation, the half step of Khoshelham and
 * Elberink. Neighbours share most of their correlation window; 9 x 9 px in the literature,
 * 8 x 8 px fits the recordings best. */
constexpr float noise_steps = 0.4f;
constexpr int noise_window_px = 8;
/** What calibration leaves: smooth, less than a step. Fitted to the recordings. */
constexpr float warp_steps = 0.75f;
constexpr int warp_waves = 4;
constexpr float min_wave_length_px = 250.f;
constexpr float max_wave_length_px = 600.f;
/** Where a pixel looks is uncertain: it shows on slopes (Barron and Malik), and more at
 * edges (Nguyen et al.). The window is fitted to the recordings. */
constexpr float slope_jitter_px = 0.5f;
constexpr float edge_jitter_px = 0.8f;
constexpr int jitter_window_width_px = 7;
constexpr int jitter_window_height_px = 3;

constexpr float min_range_m = 0.5f;
constexpr float max_range_m = 8.f;
constexpr float min_albedo = 0.06f;

/** The smooth error of the disparity of one camera, in steps: a few plane waves. */
class Warp {
public:
  explicit Warp (Random& random)
  {
    for (auto& wave : waves_) {
      const float direction = random.uniform (0.f, 6.2831853f);
      const float per_px =
          6.2831853f / random.uniform (min_wave_length_px, max_wave_length_px);
      wave = {per_px * std::cos (direction),
              per_px * std::sin (direction),
              random.uniform (0.f, 6.2831853f)};
    }
  }

  float
  at (int u, int v) const
  {
    float sum = 0.f;
    for (const auto& wave : waves_)
      sum += std::sin (wave[0] * static_cast<float> (u) +
                       wave[1] * static_cast<float> (v) + wave[2]);
    return warp_steps * std::sqrt (2.f / warp_waves) * sum;
  }

private:
  std::array<std::array<float, 3>, warp_waves> waves_;
};

bool
isMeasurable (const RenderedPixel& pixel)
{
  return isInView (pixel) && pixel.color.mean() >= min_albedo;
}

/** The pixel of the infrared camera, which has more of them, that is nearest: where it
 * lies in the image of the colour camera. */
float
nearestInfrared (float pixel, float focal, float center)
{
  const float scale = infrared_focal_px / focal;
  return center + std::round ((pixel - center) * scale) / scale;
}

/** Depth in metres from a disparity in steps, as drivers report it: both are whole. */
float
quantisedDepth (float steps)
{
  return std::round (1000.f * steps_times_m / std::round (steps)) / 1000.f;
}

} // namespace

std::vector<Eigen::Vector3f>
kinectEyes ()
{
  return {{-color_camera_m, 0.f, 0.f}, {baseline_m - color_camera_m, 0.f, 0.f}};
}

std::vector<float>
measureWithKinect (const std::vector<RenderedPixel>& image,
                   const Camera& camera,
                   Random& random,
                   Random& camera_random)
{
  const auto noise = correlatedNoise (camera, noise_window_px, noise_window_px, random);
  const auto jitter = [&] {
    return correlatedNoise (
        camera, jitter_window_width_px, jitter_window_height_px, random);
  };
  const auto jitter_u = jitter();
  const auto jitter_v = jitter();
  const Warp warp (camera_random);

  std::vector<float> depth (image.size(), std::numeric_limits<float>::quiet_NaN());
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const std::size_t i = v * camera.width + u;
      const auto x = u + static_cast<int> (std::lround (edge_jitter_px * jitter_u[i]));
      const auto y = v + static_cast<int> (std::lround (edge_jitter_px * jitter_v[i]));
      const RenderedPixel& seen =
          image[std::clamp (y, 0, camera.height - 1) * camera.width +
                std::clamp (x, 0, camera.width - 1)];
      if (!isMeasurable (seen))
        continue;
      const Eigen::Vector3f ray = rayThrough (
          camera,
          nearestInfrared (u, camera.fx, camera.cx) + slope_jitter_px * jitter_u[i],
          nearestInfrared (v, camera.fy, camera.cy) + slope_jitter_px * jitter_v[i]);
      const float true_depth = seen.normal.dot (seen.point) / seen.normal.dot (ray);
      const float measured = quantisedDepth (steps_times_m / true_depth +
                                             noise_steps * noise[i] + warp.at (u, v));
      if (measured >= min_range_m && measured <= max_range_m)
        depth[i] = measured;
    }
  return depth;
}

} // namespace rgbd_planes
} // namespace pcl
