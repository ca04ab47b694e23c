// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#pragma once

#include "synthetic_clouds.h"
#include <fuzzer/FuzzedDataProvider.h>

#include <pcl/pcl_base.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <vector>

/** Values made of the bytes of a fuzzer: ordinary ones, and what breaks programs. */
namespace fuzz {

/** Stops the fuzzer, which keeps the input, where a promise of the library is broken. */
inline void
expect (bool promise)
{
  if (!promise)
    std::abort();
}

inline float
anyFloat (FuzzedDataProvider& data)
{
  using Limits = std::numeric_limits<float>;
  switch (data.ConsumeIntegralInRange (0, 3)) {
  case 0:
    return data.PickValueInArray ({Limits::quiet_NaN(),
                                   Limits::infinity(),
                                   -Limits::infinity(),
                                   Limits::max(),
                                   -Limits::max(),
                                   Limits::denorm_min(),
                                   Limits::min(),
                                   0.f,
                                   -0.f,
                                   1e-30f,
                                   -1e30f,
                                   1e10f});
  case 1:
    return data.ConsumeFloatingPointInRange (-Limits::max(), Limits::max());
  case 2:
    return data.ConsumeFloatingPointInRange (0.f, 0.1f);
  default:
    return data.ConsumeFloatingPointInRange (-5.f, 5.f);
  }
}

/** Up to 64 x 64 pixels, none at all as well, or a few wide rows, or an image whose normals are
 * computed on 2 x 2 pixels. */
inline synthetic::Cloud::Ptr
anyCloud (FuzzedDataProvider& data)
{
  int width = data.ConsumeIntegralInRange (0, 64);
  int height = data.ConsumeIntegralInRange (0, 64);
  switch (data.ConsumeIntegralInRange (0, 9)) {
  case 0:
    width += 470;
    height /= 8;
    break;
  case 1:
    width += 470;
    height += 80;
    break;
  case 2:
    width += 80;
    height += 470;
  }
  const int scale = std::max (width, height) / 64 + 1;
  std::vector<synthetic::Surface> surfaces;
  for (int n = data.ConsumeIntegralInRange (0, 5); n > 0; --n) {
    surfaces.push_back (
        synthetic::tiltedPlane (data.ConsumeFloatingPointInRange (0.3f, 8.f),
                                data.ConsumeFloatingPointInRange (-90.f, 90.f),
                                data.ConsumeFloatingPointInRange (-60.f, 60.f)));
    const int left = scale * data.ConsumeIntegralInRange (0, 64);
    const int top = scale * data.ConsumeIntegralInRange (0, 64);
    const int side = scale * data.ConsumeIntegralInRange (1, 64);
    if (n > 1) // the last one is a background
      surfaces.back().covers = [=] (int u, int v) {
        return u >= left && u < left + side && v >= top && v < top + side;
      };
  }
  const float noise = data.ConsumeFloatingPointInRange (0.f, 0.02f);
  const auto cloud = synthetic::render (surfaces, width, height, [=] (float z) {
                       return noise * z * z;
                     }).cloud;
  for (int n = data.ConsumeIntegralInRange (0, 6); n > 0 && !cloud->empty(); --n) {
    const auto first = data.ConsumeIntegralInRange<std::size_t> (0, cloud->size() - 1);
    const auto count = data.ConsumeIntegralInRange<std::size_t> (1, cloud->size());
    const auto step = data.ConsumeIntegralInRange<std::size_t> (1, cloud->size());
    const int coordinates = data.ConsumeIntegralInRange (1, 7);
    const float value = anyFloat (data);
    for (std::size_t i = first, k = 0; k < count && i < cloud->size(); ++k, i += step)
      for (int axis = 0; axis < 3; ++axis)
        if (coordinates >> axis & 1)
          (*cloud)[i].data[axis] = value;
  }
  if (data.ConsumeIntegralInRange (0, 15) == 0)
    cloud->width = data.ConsumeIntegral<std::uint32_t>(); // no image any more
  return cloud;
}

/** Often outside of a cloud of \a size points, in any order. */
inline pcl::IndicesPtr
anyIndices (FuzzedDataProvider& data, std::size_t size)
{
  auto indices = pcl::make_shared<pcl::Indices>();
  const auto last = static_cast<pcl::index_t> (size);
  switch (data.ConsumeIntegralInRange (0, 3)) {
  case 0:
    for (int n = data.ConsumeIntegralInRange (0, 20); n > 0; --n)
      indices->push_back (data.ConsumeIntegral<pcl::index_t>());
    break;
  case 1:
    for (int n = data.ConsumeIntegralInRange (0, 200); n > 0; --n)
      indices->push_back (data.ConsumeIntegralInRange (0, last));
    break;
  default:
    const int step = data.ConsumeIntegralInRange (1, 5);
    for (pcl::index_t i = last - 1; i >= 0; i -= step)
      indices->push_back (i);
  }
  return indices;
}

} // namespace fuzz
