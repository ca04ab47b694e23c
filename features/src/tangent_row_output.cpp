// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "tangent_rows.h"
#include <hwy/cache_control.h>

#include <pcl/features/tangent_normals.h>
#include <pcl/features/tangent_row_pipeline.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl {
namespace rgbd_planes {

std::size_t
TangentRowPipeline::write (int v, const NormalOutput& output)
{
  const int y = v / grid_.step;
  const int stage = lastStage();
  const auto [du, dv] = grid_.straight;
  const PlaneRow above = planesOf (stage, y - dv);
  const PlaneRow own = planesOf (stage, y);
  const PlaneRow below = planesOf (stage, y + dv);
  const Candidates<9> around{{own,
                              own.shifted (-du),
                              own.shifted (du),
                              above,
                              above.shifted (-du),
                              above.shifted (du),
                              below,
                              below.shifted (-du),
                              below.shifted (du)}};
  const ChannelRow<float> normals = normals_[0];
  std::size_t valid = writeNormals (grid_.step > 1 ? pointsOf (v) : nullptr,
                                    static_cast<std::size_t> (padded_width_),
                                    grid_.step,
                                    sensor(),
                                    own,
                                    rowsAround() > 0 ? &around : nullptr,
                                    {{normals[0], normals[1]}});
  if (parameters_->ignore_border)
    valid -= blankBorder (y);

  copyNormals (v, output);
  return valid;
}

/** Copies the normals of row \a v of pixels to where they go, and begins to fetch where the
 * next ones go. */
void
TangentRowPipeline::copyNormals (int v, const NormalOutput& output)
{
  const auto step = static_cast<std::size_t> (grid_.step);
  const auto width = static_cast<std::size_t> (points_.width);
  const std::size_t begin = static_cast<std::size_t> (v) * width * output.stride;
  for (std::size_t k = 0; k < step; ++k) {
    const float* from = normals_[0][k];
    float* normal = output.normal + begin + k * output.stride;
    float* curvature = output.curvature + begin + k * output.stride;
    for (std::size_t u = k; u < width; u += step) {
      hwy::Prefetch (normal + step * width * output.stride);
      std::memcpy (normal, from, 3 * sizeof (float));
      *curvature = from[3];
      from += 4;
      normal += step * output.stride;
      curvature += step * output.stride;
    }
  }
}

/** Removes the normals of the cells in row \a y whose area leaves the image.
 * \return how many there were */
std::size_t
TangentRowPipeline::blankBorder (int y)
{
  const auto& area = grid_.areas[0];
  const bool whole_row = y < area.half_height || y + area.half_height >= grid_.height;
  std::size_t removed = 0;
  for (int x = 0; x < grid_.width; ++x)
    if (whole_row || x < area.half_width || x + area.half_width >= grid_.width)
      for (int k = 0; k < grid_.step && x * grid_.step + k < points_.width; ++k) {
        float* normal = normals_[0][static_cast<std::size_t> (k)] + 4 * x;
        removed += !std::isnan (normal[0]);
        std::fill_n (normal, 4, std::numeric_limits<float>::quiet_NaN());
      }
  return removed;
}

} // namespace rgbd_planes
} // namespace pcl
