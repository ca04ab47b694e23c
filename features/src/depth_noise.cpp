// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_rgbd_planes authors

#include <pcl/console/print.h>
#include <pcl/features/depth_noise.h>

#include <cmath>

namespace pcl {
namespace rgbd_planes {

void
setDepthNoise (const std::string& class_name,
               const DepthNoise& value,
               DepthNoise& noise)
{
  const float sigma = value.sigma (1.f);
  if (!(value.constant >= 0.f && value.quadratic >= 0.f && sigma > 0.f &&
        std::isfinite (sigma) && value.max_range > 0.f)) {
    PCL_ERROR ("[pcl::%s::setDepthNoise] The noise must be more than 0 m and the range "
               "as well, got %g m + %g m z^2 up to %g m. Keeping what was set.\n",
               class_name.c_str(),
               value.constant,
               value.quadratic,
               value.max_range);
    return;
  }
  noise = value;
}

} // namespace rgbd_planes
} // namespace pcl
