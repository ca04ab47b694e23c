// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include "tangent_rows.h"
#include <hwy/cache_control.h>

#include <pcl/features/impl/tangent_normals.h>
#include <pcl/features/impl/tangent_row_pipeline.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl {
namespace rgbd_planes {

std::size_t
TangentRowPipeline::write (int v, const NormalOutput& output)
{
  const bool in_place = output.padded && points_.width == padded_width_ * grid_.step;
  float* normals = in_place
                       ? output.normal + static_cast<std::size_t> (v) *
                                             static_cast<std::size_t> (points_.width) *
                                             normal_floats
                       : normals_[0][0];
  std::size_t valid = writeRow (v, normals);
  if (parameters_->ignore_border)
    valid -= blankBorder (v / grid_.step, normals);
  if (!in_place)
    copyNormals (normals, v, output);
  return valid;
}

std::size_t
TangentRowPipeline::writeRow (int v, float* normals)
{
  const int y = v / grid_.step;
  const int stage = lastStage();
  const PlaneRow own = planesOf (stage, y);
  const auto writeWith = [&] (const Candidates<9>* around) {
    return writeNormals (grid_.step > 1 ? pointsOf (v) : nullptr,
                         static_cast<std::size_t> (padded_width_),
                         grid_.step,
                         sensor_,
                         own,
                         around,
                         normals);
  };
  if (rowsAround() == 0)
    return writeWith (nullptr);
  const auto [du, dv] = grid_.straight;
  const PlaneRow above = planesOf (stage, y - dv);
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
  return writeWith (&around);
}

/** Copies the normals of a row of pixels to where they go, and begins to fetch where the next
 * ones go. */
void
TangentRowPipeline::copyNormals (const float* normals,
                                 int v,
                                 const NormalOutput& output)
{
  const auto width = static_cast<std::size_t> (points_.width);
  const std::size_t stride = output.stride, row = width * stride;
  float* normal = output.normal + static_cast<std::size_t> (v) * row;
  float* curvature = output.curvature + static_cast<std::size_t> (v) * row;
  for (std::size_t u = 0; u < width; ++u) {
    hwy::Prefetch (normal + row);
    std::memcpy (normal, normals, 3 * sizeof (float));
    *curvature = normals[4];
    normals += normal_floats;
    normal += stride;
    curvature += stride;
  }
}

/** Removes the normals of the cells in row \a y whose area leaves the image.
 * \return how many there were */
std::size_t
TangentRowPipeline::blankBorder (int y, float* normals)
{
  const auto& area = grid_.areas[0];
  const bool whole_row = y < area.half_height || y + area.half_height >= grid_.height;
  std::size_t removed = 0;
  for (int x = 0; x < grid_.width; ++x)
    if (whole_row || x < area.half_width || x + area.half_width >= grid_.width)
      for (int k = 0; k < grid_.step && x * grid_.step + k < points_.width; ++k) {
        float* normal =
            normals + normal_floats * static_cast<std::size_t> (x * grid_.step + k);
        removed += !std::isnan (normal[0]);
        std::fill_n (normal, 3, std::numeric_limits<float>::quiet_NaN());
        normal[4] = std::numeric_limits<float>::quiet_NaN();
      }
  return removed;
}

} // namespace rgbd_planes
} // namespace pcl
