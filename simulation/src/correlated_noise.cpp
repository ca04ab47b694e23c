// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "correlated_noise.h"

#include <cmath>

namespace pcl {
namespace rgbd_planes {

std::vector<float>
correlatedNoise (const Camera& camera,
                 int window_width,
                 int window_height,
                 Random& random)
{
  const int width = camera.width;
  const int padded_width = width + window_width - 1;
  const int padded_height = camera.height + window_height - 1;
  std::vector<float> white (static_cast<std::size_t> (padded_width) * padded_height);
  for (auto& value : white)
    value = random.normal();

  std::vector<float> rows (static_cast<std::size_t> (width) * padded_height, 0.f);
  for (int v = 0; v < padded_height; ++v)
    for (int k = 0; k < window_width; ++k)
      for (int u = 0; u < width; ++u)
        rows[v * width + u] += white[v * padded_width + u + k];

  const float scale =
      1.f / std::sqrt (static_cast<float> (window_width * window_height));
  std::vector<float> noise (static_cast<std::size_t> (width) * camera.height, 0.f);
  for (int v = 0; v < camera.height; ++v)
    for (int k = 0; k < window_height; ++k)
      for (int u = 0; u < width; ++u)
        noise[v * width + u] += scale * rows[(v + k) * width + u];
  return noise;
}

} // namespace rgbd_planes
} // namespace pcl
