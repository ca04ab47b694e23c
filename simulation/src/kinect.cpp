// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "kinect.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace rgbd_planes {

namespace {

/** Focal length of the infrared camera, which defines the unit of the disparity. */
constexpr float focal_px = 580.f;
constexpr float disparity_step_px = 1.f / 8.f;
constexpr float disparity_noise_px = 0.5f * disparity_step_px;
constexpr float noise_correlation_px = 1.5f;
constexpr float edge_jitter_px = 0.8f;
constexpr float jitter_correlation_px = 1.5f;
constexpr float min_range_m = 0.5f;
constexpr float max_range_m = 8.f;
constexpr float min_incidence_cosine = 0.14f;
constexpr float min_albedo = 0.06f;

/** Replaces each value by the weighted sum of those around it, along one axis. */
std::vector<float>
convolve (const std::vector<float>& image,
          const std::vector<float>& kernel,
          int width,
          int height,
          int step_u,
          int step_v)
{
  const int half = static_cast<int> (kernel.size()) / 2;
  std::vector<float> result (image.size(), 0.f);
  for (int k = -half; k <= half; ++k)
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < width; ++u) {
        const int x = (u + k * step_u + width) % width;
        const int y = (v + k * step_v + height) % height;
        result[v * width + u] += kernel[k + half] * image[y * width + x];
      }
  return result;
}

/** Standard normal noise, correlated by a Gaussian of \a sigma_px over neighbours. */
std::vector<float>
correlatedNoise (const Camera& camera, float sigma_px, Random& random)
{
  std::vector<float> noise (static_cast<std::size_t> (camera.width) * camera.height);
  for (auto& value : noise)
    value = random.normal();

  const int half = static_cast<int> (std::ceil (3.f * sigma_px));
  std::vector<float> kernel;
  float squares = 0.f;
  for (int k = -half; k <= half; ++k) {
    kernel.push_back (
        std::exp (-0.5f * static_cast<float> (k * k) / (sigma_px * sigma_px)));
    squares += kernel.back() * kernel.back();
  }
  for (auto& weight : kernel)
    weight /= std::sqrt (squares);
  noise = convolve (noise, kernel, camera.width, camera.height, 1, 0);
  return convolve (noise, kernel, camera.width, camera.height, 0, 1);
}

bool
isMeasurable (const RenderedPixel& pixel)
{
  if (pixel.surface == RenderedPixel::no_surface || pixel.in_shadow)
    return false;
  const float cosine = -pixel.normal.dot (pixel.point.normalized());
  return cosine >= min_incidence_cosine && pixel.color.mean() >= min_albedo;
}

} // namespace

std::vector<float>
measureWithKinect (const std::vector<RenderedPixel>& image,
                   const Camera& camera,
                   Random& random)
{
  const auto noise = correlatedNoise (camera, noise_correlation_px, random);
  const auto jitter_u = correlatedNoise (camera, jitter_correlation_px, random);
  const auto jitter_v = correlatedNoise (camera, jitter_correlation_px, random);
  std::vector<float> depth (image.size(), std::numeric_limits<float>::quiet_NaN());
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const std::size_t i = v * camera.width + u;
      const int x = u + static_cast<int> (std::lround (edge_jitter_px * jitter_u[i]));
      const int y = v + static_cast<int> (std::lround (edge_jitter_px * jitter_v[i]));
      const RenderedPixel& seen =
          image[std::clamp (y, 0, camera.height - 1) * camera.width +
                std::clamp (x, 0, camera.width - 1)];
      if (!isMeasurable (seen))
        continue;
      // The surface seen is continued to this pixel: only edges are displaced.
      const float true_depth =
          seen.normal.dot (seen.point) / seen.normal.dot (rayThrough (camera, u, v));
      const float disparity =
          focal_px * kinect_baseline_m / true_depth + disparity_noise_px * noise[i];
      const float quantised =
          std::round (disparity / disparity_step_px) * disparity_step_px;
      const float measured = focal_px * kinect_baseline_m / quantised;
      if (measured >= min_range_m && measured <= max_range_m)
        depth[i] = measured;
    }
  return depth;
}

} // namespace rgbd_planes
} // namespace pcl
